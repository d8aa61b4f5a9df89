#include <gtest/gtest.h>

#include "spray/load/impact.h"
#include "tests/verification/spray/table.h"

namespace tw::spray {
namespace impact_test {

TEST(ImpactLaw, GivesTheTabledForcesAndImpulses) {
    const auto t = table("droplet_impact_eq23_eq24.csv");
    const Liquid water{1000, 0.001, 0.07342};
    for (std::size_t i = 0; i < t.at("diameter_m").size(); ++i) {
        const double d = t.at("diameter_m")[i], V = t.at("V_m_per_s")[i];
        EXPECT_NEAR(peak_force(V, d, water) / t.at("F_max_N")[i], 1, 1e-8);
        EXPECT_NEAR(impulse(V, d, water) / t.at("impulse_Ns_with_rho_w")[i], 1, 1e-8);
        EXPECT_NEAR(impact_reynolds(V, d, water) / t.at("Re")[i], 1, 1e-8);
        EXPECT_NEAR(impact_weber(V, d, water) / t.at("We")[i], 1, 1e-8);
        // an impulse is between once (no rebound) and twice (full rebound) the momentum; without rho it would be 1e-3
        const double ratio = impulse(V, d, water) / (1000 * sphere_volume(d) * V);
        EXPECT_GT(ratio, 1);
        EXPECT_LT(ratio, 1.25);
    }
}

}  // namespace impact_test
}  // namespace tw::spray
