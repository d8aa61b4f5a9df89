// Savitsky's regression against an independently computed table.
#include "compare/reference/savitsky.h"
#include "base/numbers.h"
#include "tests/data_table.h"

#include <gtest/gtest.h>

#include <string>
#include <vector>

namespace tw {
namespace savitsky_test {

// Columns: Cv, deadrise [deg], trim [deg], lambda, beam [m], U [m/s], CL0, CLbeta, lift [N], Cf, friction, drag [N], ...
std::vector<std::vector<double>> table() { return number_rows("savitsky_prismatic_fixed_trim.csv"); }

TEST(Savitsky, LiftAndDragEqualTheIndependentTable) {
    const auto rows = table();
    ASSERT_GE(rows.size(), 90u);
    for (const auto& row : rows) {
        // The table's water: standard gravity, fresh water of 15 degrees.
        const PlaningState state{.beam = row[4],
                                 .deadrise = row[1] * degree,
                                 .trim = row[2] * degree,
                                 .speed = row[5],
                                 .density = 1000,
                                 .kinematic_viscosity = 1.139e-6,
                                 .gravity = 9.80665};
        const Savitsky result = savitsky(state, row[3]);
        EXPECT_NEAR(result.lift / row[8], 1, 2e-6) << "Cv " << row[0] << " deadrise " << row[1] << " lambda " << row[3];
        EXPECT_NEAR(result.drag / row[11], 1, 2e-6)
            << "Cv " << row[0] << " deadrise " << row[1] << " lambda " << row[3];
    }
}

}  // namespace savitsky_test
}  // namespace tw
