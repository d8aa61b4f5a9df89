#include <gtest/gtest.h>

#include "foam_cases/mesh/edge_cells.h"

namespace tw {
namespace edge_cells_test {

TEST(SmallestEdgeCell, IsSoughtAlongEdgesAcrossTheStreamOnly) {
    const SheddingEdge transom{{2, 0, -0.2}, {2.01, 0.5, 0}, {-1, 0, 0}},
        chine{{2.01, 0.5, 0}, {0, 0.5, 0.2}, {0, -1, 0}};
    const double edge_cell = 0.02, whole = 8e-6;
    const std::vector<Vec3> middles{{2.01, 0.25, -0.11}, {1.5, 0.5, 0.05}, {2.1, 0.25, -0.1}};
    const std::vector<double> volumes{0.08 * whole, 0.05 * whole, 0.01 * whole};
    EXPECT_NEAR(smallest_edge_cell(middles, volumes, {transom, chine}, edge_cell, whole), 0.08, 1e-12)
        << "neither the cell at the chine nor the one too far astern";
    EXPECT_EQ(smallest_edge_cell(middles, volumes, {chine}, edge_cell, whole), 1);
    EXPECT_EQ(smallest_edge_cell(middles, volumes, {transom}, 1e-3, whole), 1);
}

}  // namespace edge_cells_test
}  // namespace tw
