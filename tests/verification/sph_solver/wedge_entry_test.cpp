// Wedges that enter still water at constant speed against the similarity solution, as wedge_entry.h says.
#include <gtest/gtest.h>

#include "tests/verification/sph_solver/wedge_entry.h"

namespace tw {
namespace wedge_entry_test {

TEST(WedgeEntry, ForceAndPressureAreThoseOfTheSimilaritySolution) {
    // Spacings changed by 4 % and another instruction set change the forces by 0.2 % (10 degrees) to 5 % (20 degrees).
    // The peak of pressure at 10 degrees is narrower than the kernel, and at 45 and 60 degrees it sits in the corner at
    // the apex, so its height is held to little there.
    struct Case {
        Entry entry;
        double force, cp_max;  ///< allowed errors
    };
    print_head();
    for (const Case& c : {Case{{.deadrise_deg = 10, .fineness = 18}, 0.08, 0.6},     // found +5.5 %, -44 %
                          Case{{.deadrise_deg = 30, .fineness = 26}, 0.07, 0.3},     // -2.7 %, -13 %
                          Case{{.deadrise_deg = 60, .fineness = 18}, 0.05, 0.4}}) {  // -0.7 %, -30 %
        const double deadrise = c.entry.deadrise_deg;
        const Exact exact = exact_of(deadrise);
        const Found found = print(c.entry);
        EXPECT_NEAR(found.force / exact.force, 1, c.force) << deadrise;
        EXPECT_NEAR(found.cp_max / exact.cp_max, 1, c.cp_max) << deadrise;
        EXPECT_LT(found.cp_error, 0.15) << deadrise;  // found 2 to 10 %
        EXPECT_NEAR(found.cp_apex / exact.cp_apex, 1, deadrise < 25 ? 0.06 : deadrise < 50 ? 0.2 : 0.35) << deadrise;
        if (deadrise < 25) { EXPECT_NEAR(found.y_cp_max, exact.y_cp_max, 0.15) << deadrise; }
        // a kernel does not see the narrow void right at the root
        const double root_off = (found.x_root / exact.x_root - 1) * c.entry.fineness;  // in spacings
        EXPECT_GT(root_off, -3.5) << deadrise;
        EXPECT_LT(root_off, 3.5) << deadrise;  // found -2.5 to +1.6
    }
}

}  // namespace wedge_entry_test
}  // namespace tw
