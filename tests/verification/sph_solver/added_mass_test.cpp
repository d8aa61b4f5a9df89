// Water that weighs more than the plate that it moves with.
#include <gtest/gtest.h>

#include <cstdio>
#include <numbers>

#include "base/errors.h"
#include "column_on_plate.h"

namespace tw {
namespace added_mass_test {

struct Outcome {
    double made = 0;        ///< the most energy made lately at the interface [-]
    double deflection = 0;  ///< mean, as in elastic_test.cpp [m]
    double reached = 0;     ///< time [s]
};

Outcome column_with(const ColumnOnPlate& column, bool relaxed, int iterations, double T) {
    SimulationSetup s = column.setup();
    auto setup = std::make_shared<ElasticSetup>(*s.bodies[0].elastic);
    setup->coupling.relaxed = relaxed;
    setup->coupling.iterations = iterations;
    s.bodies[0] = BodySetup(setup);
    Simulation run(s, column.water(s));
    Outcome out;
    double sum = 0, weight = 0;
    try {
        while (run.time() < T) {
            const double time = run.time();
            run.step();
            const double bell = (run.time() - time) * std::pow(std::sin(std::numbers::pi * time / T), 2);
            sum += bell * plate_of(run).deflection(0).z(), weight += bell;
            // the first steps are those of the release
            if (run.steps() > 20) out.made = std::max(out.made, *plate_of(run).energy_made_lately());
        }
    } catch (const RunError&) {  // it may not come to the end, but has to be known before
    }
    out.deflection = -sum / weight;
    out.reached = run.time();
    return out;
}

/// A layer of water one spacing thick, which answers to a wall's acceleration at once, weighs twice as much as this
/// plate. The conventional staggered scheme then throws the acceleration to and fro; with relaxed accelerations it does
/// not.
TEST(AddedMass, IsKnownByTheEnergyOfTheInterfaceAndCuredByRelaxation) {
    const ColumnOnPlate column{0.01};
    const double T = 0.3;
    const Outcome conventional = column_with(column, false, 1, T), relaxed = column_with(column, true, 1, T),
                  iterated = column_with(column, true, 3, T);
    for (const auto& [name, o] :
         {std::pair{"conventional", conventional}, {"relaxed", relaxed}, {"relaxed, 3 iterations", iterated}})
        std::printf("%s: to %.3g s, energy made lately at most %.3g %%, mean deflection %+.2f %% off\n", name,
                    o.reached, 100 * o.made, 100 * (o.deflection / column.exact() - 1));
    EXPECT_LT(conventional.reached, T) << "or the case is not unstable";
    EXPECT_GT(conventional.made, trusted_interface_energy);
    EXPECT_LT(relaxed.made, trusted_interface_energy);
    EXPECT_LT(iterated.made, trusted_interface_energy);
    EXPECT_NEAR(relaxed.deflection / column.exact(), 1, 0.05);
    EXPECT_NEAR(iterated.deflection / column.exact(), 1, 0.05);
}

}  // namespace added_mass_test
}  // namespace tw
