#include "structure/tyre.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/errors.h"

namespace tw::structure {
namespace tyre_test {

TEST(Tyre, HasItsMainDimensions) {
    const Tyre t;
    const SolidMesh m = tyre_mesh(t);
    double outermost = 0, widest = 0, bead = 1;
    for (const Vec3& p : m.nodes) {
        outermost = std::max(outermost, std::hypot(p.x(), p.z()));
        widest = std::max(widest, std::abs(p.y()));
    }
    for (const int n : m.sets.at("rim")) {
        const Vec3& p = m.nodes[static_cast<std::size_t>(n)];
        bead = std::min(bead, std::hypot(p.x(), p.z()));
    }
    EXPECT_NEAR(outermost, 0.125, 1e-12);
    EXPECT_NEAR(widest, 0.040, 0.0005);
    EXPECT_NEAR(bead, 0.0475, 1e-12);
    EXPECT_EQ(m.sets.at("rim").size(), 2u * 48 * 4);
    for (const int k : {0, 1, 2}) EXPECT_GT(std::count(m.material.begin(), m.material.end(), k), 0);
}

TEST(Tyre, ThatIsNoneIsRefused) {
    Tyre t;
    t.rim_diameter = 0.24;
    EXPECT_THROW(tyre_mesh(t), InputError);
    t = {};
    t.bead_angle = 1;
    EXPECT_THROW(tyre_mesh(t), InputError);
}

}  // namespace tyre_test
}  // namespace tw::structure
