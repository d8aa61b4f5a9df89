// Water at rest round solids whose faces do not fit the particles' lattice: it keeps its volume, its particles stand as
// their densities say, and it presses as Archimedes has it. Two dimensions.
//
// Exact: nothing moves. The level follows from the particles' volume: of n particles of mass m round a solid of the
// area A in a tank of the length L they fill V = n m / rho0 less what the pressure takes, rho g times the second moment
// of the depths over rho0 c0^2, and stand (V + A) / L high. The force on the solid is rho g A.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <numbers>

#include "prism.h"
#include "record/recorded_checks.h"
#include "sph_solver/equations/packing.h"
#include "sph_solver/fit_solids.h"
#include "sph_solver/measure/packing.h"
#include "sph_solver/simulation.h"

namespace tw {
namespace still_water_round_solids_test {

constexpr double g = 9.81, length = 1.2, depth = 0.6;

/// A solid under water: corners in the x-z plane, anticlockwise.
struct Solid {
    const char* name;
    std::vector<std::pair<double, double>> corners;
    double area() const {
        double twice = 0;
        for (std::size_t i = 0; i < corners.size(); ++i) {
            const auto &a = corners[i], &b = corners[(i + 1) % corners.size()];
            twice += a.first * b.second - b.first * a.second;
        }
        return twice / 2;
    }
};
/// A plate two spacings thick at 35 degrees, a body with an inner corner that looks up, and a box of whose faces three
/// go through places of the lattice.
const Solid plate{"inclined plate", {{-0.2052, -0.427}, {0.1224, -0.1976}, {0.1052, -0.173}, {-0.2224, -0.4024}}};
const Solid hook{"body with an inner corner",
                 {{-0.0148, -0.4287},
                  {0.3024, -0.2808},
                  {0.2813, -0.2355},
                  {0.1097, -0.2934},
                  {0.0777, -0.1539},
                  {-0.0051, -0.2366},
                  {-0.0486, -0.3562}}};
const Solid box{"box", {{-0.03, -0.45}, {0.03, -0.45}, {0.03, -0.2}, {-0.03, -0.2}}};

struct Rest {
    double volume = 0;        ///< by the level of the water, over that of the particles at rest, less 1
    double force = 0;         ///< mean over the exact one
    double kinetic = 0;       ///< over the potential energy, at the end
    double packing = 0;       ///< mean of the kernel supports under water less 1
    double most_crowded = 0;  ///< the largest of them less 1
    double crowding = 0;      ///< of the validity checks
};

/// Mean height at which the kernel support is a half, over columns of samples clear of the walls.
double level_of(Simulation& simulation, double dp) {
    constexpr int heights = 65;
    PointSamples points;
    for (double x = -length / 2 + dp / 2; x < length / 2; x += dp)
        for (int k = 0; k < heights; ++k) points.places.emplace_back(x, 0, (k - heights / 2) * dp / 8);
    simulation.sample(points);
    double sum = 0;
    const std::size_t columns = points.places.size() / heights;
    for (std::size_t c = 0; c < columns; ++c) {
        const float* const support = points.support.data() + c * heights;
        int k = heights - 2;
        while (k > 0 && support[k] < 0.5f) --k;
        sum += (k - heights / 2 + (support[k] - 0.5) / (support[k] - support[k + 1])) * dp / 8;
    }
    return sum / double(columns);
}

Rest rest_round(const Solid& solid, double dp, double h_over_dp, double packing, double until) {
    SimulationSetup s;
    s.dimensions = 2;
    s.dp = dp;
    s.h_over_dp = h_over_dp;
    s.packing = packing;
    s.state_equation.c0 = 10 * std::sqrt(2 * g * depth);
    s.domain = {Vec3(-length / 2, -1, -depth), Vec3(length / 2, 1, 0.1)};
    s.mirrors.on = {{{true, true}, {false, false}, {true, false}}};
    s.bodies = {prism_along_y(solid.corners, 3)};
    Box water = s.domain;
    water.max.z() = 0;
    std::vector<Fluid> fluid{fill_with_fluid(s, {water})};
    fit_to_solids(s, std::span(&water, 1), fluid);
    Simulation simulation(s, fluid);
    const Particles& p = simulation.particles();
    const double m = simulation.mass(), V = m * double(p.size()) / s.rho0;
    double potential = 0, force = 0, forces = 0;
    for (std::size_t i = 0; i < p.size(); ++i) potential += m * g * (p.z[i] + depth);
    const double exact_level = (V + solid.area()) / length - depth;
    while (simulation.time() < until) {
        simulation.step();
        if (simulation.time() > until / 2) force += simulation.load(0).force.z(), ++forces;
    }
    Rest r;
    r.volume = (level_of(simulation, dp) - exact_level) * length / V;
    r.force = force / forces / (s.rho0 * g * solid.area());
    double kinetic = 0, count = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        kinetic += m / 2 * (double(p.u[i]) * p.u[i] + double(p.w[i]) * p.w[i]);
        if (p.z[i] > -3.5 * dp) continue;
        const double crowded = double(p.shift_support[i].support) - 1;
        r.packing += crowded, r.most_crowded = std::max(r.most_crowded, crowded), ++count;
    }
    r.packing /= count;
    r.crowding = crowding(simulation);
    r.kinetic = kinetic / potential;
    return r;
}

Rest shown(const Solid& solid, double dp, double h_over_dp, double packing, double until) {
    const Rest r = rest_round(solid, dp, h_over_dp, packing, until);
    std::printf(
        "%-26s dp %g mm, h/dp %g, k %g, %g s: volume %+.2f %%, force %.3f of Archimedes, kinetic energy %.1e of "
        "the potential one, packing %+.2f %%, at most %+.1f %%\n",
        solid.name, 1e3 * dp, h_over_dp, packing, until, 100 * r.volume, r.force, r.kinetic, 100 * r.packing,
        100 * r.most_crowded);
    return r;
}

TEST(StillWaterRoundSolids, KeepsItsVolumePressesAndRests) {
    for (const auto& [solid, h_over_dp] : {std::pair{plate, 1.55}, std::pair{hook, 2.0}, std::pair{box, 1.55}}) {
        const Rest r = shown(solid, 0.02, h_over_dp, Packing::k, 2.5);
        EXPECT_LT(std::abs(r.volume), 0.003) << solid.name;
        EXPECT_NEAR(r.force, 1, 0.01) << solid.name;
        EXPECT_LT(r.kinetic, 1e-4) << solid.name;
        EXPECT_LT(std::abs(r.packing), 0.003) << solid.name;
        EXPECT_LT(std::abs(r.crowding), largest_crowding / 2) << solid.name;
    }
}

/// The fault that the term mends, or the test above sees nothing. The validity checks of a run tells it.
TEST(StillWaterRoundSolids, ShrinksAndStirsWhereDensityDoesNotFollowPacking) {
    const Rest r = shown(box, 0.02, 1.55, 0, 4);
    EXPECT_LT(r.volume, -0.006);
    EXPECT_GT(r.kinetic, 5e-4);
    EXPECT_GT(r.packing, 0.008);
    EXPECT_GT(r.most_crowded, 0.04);
    EXPECT_GT(r.crowding, largest_crowding);
}

}  // namespace still_water_round_solids_test
}  // namespace tw
