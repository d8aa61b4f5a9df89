#include <gtest/gtest.h>

#include <cmath>

#include "base/numbers.h"
#include "compare/reference/planing.h"
#include "meshes/generate.h"
#include "meshes/section.h"
#include "record/planing_plate.h"
#include "tests/data_table.h"

namespace tw {
namespace planing_plate_test {

// Columns: alpha_deg, J, z_TE/H, delta/H, N/(rho U^2 H), N by pressure, ...
TEST(PlaningPlate, EqualsTheIndependentTableBothWays) {
    const std::vector<std::vector<double>> rows = number_rows("planing_plate_channel.csv");
    for (std::size_t k = 0; k < rows.size(); ++k) {
        SCOPED_TRACE(k);
        const std::vector<double>& row = rows[k];
        const double alpha = row[0] * degree;
        const PlaningPlate plate = planing_plate(alpha, row[1]);
        EXPECT_NEAR(plate.z_te, row[2], 1e-6);
        EXPECT_NEAR(plate.delta, row[3], 1e-6);
        EXPECT_NEAR(plate.force, row[4], 2e-6);
        const std::optional<PlaningPlate> found = planing_plate_at(alpha, row[2]);
        ASSERT_TRUE(found);
        EXPECT_NEAR(found->force, row[4], 2e-5);
    }
    EXPECT_EQ(rows.size(), 11u);
}

/// What a run of studies/planing_plate.toml leaves, as far as the reference reads it.
RunRecord plate_record(const char* shape = "plate") {
    RunRecord r;
    r.numbers = {{"dimensions", 2}, {"gravity", 0}, {"depth", 1},          {"speed", 10},
                 {"density", 1000}, {"heel", 0},    {"trim", 30 * degree}, {"draft", 0.101338}};
    r.hull = section_prism(posed(make_hull(shape, {}), {.trim = 30 * degree, .draft = 0.101338}));
    return r;
}

TEST(PlaningPlate, IsTheReferenceOfAFlatBottomInAWeightlessChannelOnly) {
    const std::vector<Reference> both = planing_plate_references(plate_record());
    ASSERT_EQ(both.size(), 2u);
    EXPECT_EQ(both[0].quantity, "lift");
    EXPECT_EQ(both[0].unit, "N/m");
    EXPECT_NEAR(std::hypot(both[0].value, both[1].value), 98723.5, 10);
    EXPECT_NEAR(both[1].value / both[0].value, std::tan(30 * degree), 1e-9) << "normal to the plate";

    const auto without = [](const char* number, double value) {
        RunRecord r = plate_record();
        r.numbers[number] = value;
        return planing_plate_references(r).size();
    };
    EXPECT_EQ(without("gravity", 9.81), 0u);
    EXPECT_EQ(without("dimensions", 3), 0u);
    EXPECT_EQ(without("speed", 0), 0u);
    EXPECT_EQ(without("trim", 10 * degree), 0u) << "not the angle of the surface";
    EXPECT_EQ(planing_plate_references(plate_record("cylinder")).size(), 0u);
}

}  // namespace planing_plate_test
}  // namespace tw
