// Blows: water against a flat plate, a nearly flat one and a knife's edge; water laid out askew; a sound speed that is
// too low, which has to be said.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "base/errors.h"
#include "base/numbers.h"
#include "meshes/generate.h"
#include "meshes/query.h"
#include "record/recorded_checks.h"
#include "sph_solver/measure/validity_checks.h"
#include "watched_run.h"

namespace tw {
namespace impacts_test {

/// A section 1 m wide with hard chines, keel at the origin.
Surface section(double deadrise_deg) {
    if (deadrise_deg >= 1)
        return make_hull("wedge",
                         {{"width", 1}, {"span", 6}, {"deadrise", deadrise_deg * pi / 180}, {"side_height", 0.3}});
    Surface box = make_hull("box", {{"length", 1}, {"beam", 6}, {"height", 0.3}});
    const Box at = box.bounds();
    for (Vec3& p : box.points) p -= Vec3((at.min.x() + at.max.x()) / 2, 0, at.min.z());
    return box;
}

/// Weightless water that fills `block`, thrown upwards at 1 m/s. `turned_deg`: its lattice is turned by that.
Simulation thrown_at(const Surface& solid, const Box& block, double dp, double c0, double turned_deg = 0) {
    SimulationSetup s = plane(dp, c0, 6);
    s.bodies = {solid};
    Fluid water = weightless(s, block);
    if (turned_deg != 0) {
        const double c = std::cos(turned_deg * pi / 180), n = std::sin(turned_deg * pi / 180);
        const SurfaceQuery query(solid);
        water = {};
        for (int i = -400; i < 400; ++i)
            for (int k = -400; k < 400; ++k) {
                const double a = (i + 0.5) * dp, b = (k + 0.5) * dp;
                const Vec3 x(c * a - n * b, 0, n * a + c * b);
                // as far from the block's edges as the straight lattice is
                if (x.x() < block.min.x() || x.x() > block.max.x() || x.z() < block.min.z() ||
                    x.z() > block.max.z() - dp / 2)
                    continue;
                if (query.nearest(x, 2 * dp).distance <= 0) continue;
                water.places.push_back(x), water.depth.push_back(0);
            }
    }
    Simulation simulation(s, water);
    for (float& w : simulation.fields_to_set().w) w = 1;
    return simulation;
}

struct AtPlace {
    double impulse = 0;  ///< on the section [N s/m]
    double lost = 0;     ///< momentum that the water has lost meanwhile [N s/m]
    double peak = 0;     ///< largest force [N/m]
    double aside = 0;    ///< impulse along x
};
AtPlace blow_of(Simulation& simulation, double until) {
    AtPlace b;
    const double start = sums_of(simulation).z;
    double before = 0;
    while (simulation.time() < until) {
        simulation.step();
        const Vec3 force = simulation.load().force;
        EXPECT_TRUE(force.allFinite());
        b.impulse += force.z() * (simulation.time() - before);
        b.aside += force.x() * (simulation.time() - before);
        b.peak = std::max(b.peak, force.z());
        before = simulation.time();
    }
    EXPECT_EQ(simulation.ledger().lost + simulation.ledger().out, 0);
    b.lost = start - sums_of(simulation).z;
    return b;
}

/// A plate of half width a meets flat water: the hammer's pressure rho c0 U all over it, which waves from its two edges
/// take away. Linear acoustics (Sommerfeld's half plane): until they have crossed, c0 t < 2a,
///
///   F = rho c0 U 2a (1 - c0 t / 2a),   so at c0 t = a the impulse is 3/2 rho U a^2
///
/// and rho U pi a^2 / 2, half the added mass, is what it goes to. The peak goes with c0 and is no result.
TEST(FlatPlate, GetsTheImpulseOfTheWaterHammerAndItsRelief) {
    const double c0 = 160, a = 0.5;  // so fast that the water stays where it is
    Simulation simulation = thrown_at(section(0), {Vec3(-1.5, 0, -0.8), Vec3(1.5, 0, 0)}, a / 20, c0);
    const AtPlace b = blow_of(simulation, a / c0);
    const double t = simulation.time(), exact = 1000 * c0 * 2 * a * t * (1 - c0 * t / (4 * a));
    std::cout << "flat: impulse over exact " << b.impulse / exact << ", momentum lost over it " << b.lost / b.impulse
              << ", peak over rho c0 U 2a " << b.peak / (1000 * c0 * 2 * a) << "\n";
    EXPECT_NEAR(b.impulse / exact, 1, 0.06);
    EXPECT_NEAR(b.lost / b.impulse, 1, 1e-4);
    EXPECT_NEAR(b.peak / (1000 * c0 * 2 * a), 1, 0.15);
}

TEST(FlatPlate, WithTwoDegreesGetsTheSameImpulseWithoutThePeak) {
    // Wagner: two degrees are wet to the chines after U t = 0.011 m, and the impulse is then that of the flat plate.
    const Box block{Vec3(-2.5, 0, -2), Vec3(2.5, 0, 0)};
    Simulation flat_water = thrown_at(section(0), block, 1.0 / 32, 40),
               water = thrown_at(section(2), block, 1.0 / 32, 40);
    const AtPlace flat = blow_of(flat_water, 0.1), b = blow_of(water, 0.1);
    std::cout << "2 degrees over flat: impulse " << b.impulse / flat.impulse << ", peak " << b.peak / flat.peak
              << "; impulse over rho U pi a^2 / 2 " << b.impulse / (1000 * pi / 8) << "\n";
    EXPECT_NEAR(b.impulse / flat.impulse, 1, 0.08);
    EXPECT_NEAR(b.lost / b.impulse, 1, 1e-4);
    EXPECT_LT(b.peak, 0.85 * flat.peak);
}

TEST(SharpKeel, CutsTheWaterAndNoneIsInside) {
    // A blade, 20 degrees between its faces: 2 spacings wide at 5.7 spacings from its edge.
    const Surface blade =
        make_hull("wedge", {{"width", 0.4}, {"span", 6}, {"deadrise", 80 * pi / 180}, {"side_height", 0}});
    const double dp = 1.0 / 40;
    Simulation simulation = thrown_at(blade, {Vec3(-0.5, 0, -0.8), Vec3(0.5, 0, 0)}, dp, 20);
    const std::size_t n = simulation.particles().size();
    const double energy = sums_of(simulation).energy;
    const AtPlace b = blow_of(simulation, 0.8);
    const Particles& p = simulation.particles();
    ASSERT_EQ(p.size(), n);
    const SurfaceQuery query(blade);
    double deepest = 0, highest = 0;
    for (std::size_t i = 0; i < n; ++i) {
        deepest = std::min(deepest, query.nearest(Vec3(p.x[i], 0, p.z[i]), 1).distance);
        highest = std::max(highest, p.z[i]);
    }
    std::cout << "deepest inside " << deepest / dp << " dp, impulse over the water's momentum "
              << b.impulse / (simulation.mass() * double(n)) << ", aside over up " << b.aside / b.impulse
              << ", energy kept " << sums_of(simulation).energy / energy << "\n";
    EXPECT_GT(deepest, -0.1 * dp);
    EXPECT_GT(highest, 0.6);  // it is cut, not held up
    EXPECT_NEAR(b.lost / b.impulse, 1, 1e-4);
    EXPECT_LT(std::abs(b.aside), 0.05 * b.impulse);
    EXPECT_LT(sums_of(simulation).energy + elastic_of(simulation), energy);
}

TEST(RotatedLattice, StrikesAsTheStraightOneDoes) {
    // The same water on a section of 30 degrees, its lattice turned by 30 degrees: the sides of the block are ragged,
    // and nothing lies along the walls.
    const Box block{Vec3(-1.5, 0, -1.2), Vec3(1.5, 0, 0)};
    Simulation straight = thrown_at(section(30), block, 1.0 / 40, 20),
               turned = thrown_at(section(30), block, 1.0 / 40, 20, 30);
    const double mass = double(turned.particles().size()) / double(straight.particles().size());
    const double a = blow_of(straight, 0.25).impulse, b = blow_of(turned, 0.25).impulse;
    std::cout << "particles " << mass << ", impulse " << b / a << " of the straight lattice's\n";
    EXPECT_NEAR(mass, 1, 0.02);
    EXPECT_NEAR(b / a, 1, 0.05);
}

/// The worst of a run's validity checks by name; NaN where there is no such line.
double worst(const RunRecord& record, const std::string& name) {
    for (const RecordedCheck& line : record.validity_checks)
        if (line.name == name) return line.value;
    return std::nan("");
}
struct Watched {
    RunRecord record;
    std::string stopped;
};
Watched impact_with_validity_checks(double c0) {
    Watched w;
    try {
        Simulation simulation = thrown_at(section(10), {Vec3(-1, 0, -1), Vec3(1, 0, 0)}, 1.0 / 25, c0);
        while (simulation.time() < 0.3) simulation.step(), watch_stability(simulation, w.record);
    } catch (const RunError& e) { w.stopped = e.what(); }
    return w;
}

TEST(SoundSpeedTooLow, IsSaidAndNotPassed) {
    // Half the speed of the flow that rules allow, and less: the run does not go on, and names the sound speed.
    for (const double c0 : {2.0, 1 / 0.3}) {
        const Watched w = impact_with_validity_checks(c0);
        EXPECT_NE(w.stopped.find("sound speed"), std::string::npos) << c0 << ": " << w.stopped;
    }
    // Ten times the impact's speed, as a scene has it by default, runs on, but its jets are faster: the record says so.
    const Watched low = impact_with_validity_checks(10), enough = impact_with_validity_checks(40);
    EXPECT_EQ(low.stopped + enough.stopped, "");
    std::cout << "Mach number and compression: " << worst(low.record, "Mach number") << ", "
              << worst(low.record, "compression") << " %; with four times the sound speed "
              << worst(enough.record, "Mach number") << ", " << worst(enough.record, "compression") << " %\n";
    const auto met = [](const RunRecord& record) {
        return std::ranges::all_of(record.validity_checks, &RecordedCheck::met);
    };
    EXPECT_GT(worst(low.record, "Mach number"), 0.3);
    EXPECT_FALSE(met(low.record));
    EXPECT_TRUE(met(enough.record));
}

}  // namespace impacts_test
}  // namespace tw
