// What a simulation refuses to combine, each for a reason of physics, and what stands next to it and works.
#include <gtest/gtest.h>

#include <string>

#include "base/errors.h"
#include "sph_solver/simulation.h"
#include "three_levels.h"

namespace tw {
namespace refused_combinations_test {

/// A section of still water over a floor, and a box in it.
SimulationSetup tank() {
    SimulationSetup s;
    s.dimensions = 2;
    s.dp = 0.05;
    s.state_equation.c0 = 20;
    s.domain = {Vec3(0, -1, 0), Vec3(2, 1, 2)};
    s.mirrors.on = {{{true, true}, {false, false}, {true, false}}};
    s.bodies.emplace_back(box_surface({Vec3(0.8, -1, 0.4), Vec3(1.2, 1, 0.8)}));
    s.threads = 1;
    return s;
}
SimulationSetup tank_with_free_box() {
    SimulationSetup s = tank();
    s.bodies[0].moving = RigidBodySetup{};
    s.bodies[0].moving->mass = solid_mass(s.bodies[0].surface, 800);
    return s;
}
const std::vector<Box> water{Box{Vec3(0, -1, 0), Vec3(2, 1, 1)}};

/// The sentence with which a setup is refused; empty: it is not.
std::string refusal(const SimulationSetup& s) {
    try {
        Simulation simulation(s, fill_levels(s, water));
    } catch (const InputError& e) { return e.what(); }
    return {};
}
void expect_refused(const SimulationSetup& s, const char* reason) {
    const std::string said = refusal(s);
    EXPECT_NE(said.find(reason), std::string::npos) << '"' << said << '"';
}

TEST(RefusedCombinations, SeveralSizesWithASchemeOfAnotherOrderThanTheEdge) {
    SimulationSetup s = tank();
    s.zones = {zone_between(0.4, 1.6, -infinite, infinite)};
    EXPECT_EQ(refusal(s), "");
    for (const Scheme scheme : {Scheme::symplectic_euler, Scheme::predictor_corrector, Scheme::rk4_frozen_diffusion}) {
        s.scheme = scheme;
        expect_refused(s, "linear in time over the coarse step");
    }
}

TEST(RefusedCombinations, AFreeBodyWithASchemeInStages) {
    SimulationSetup s = tank_with_free_box();
    s.scheme = Scheme::symplectic_euler;
    EXPECT_EQ(refusal(s), "");
    s.scheme = Scheme::predictor_corrector;
    expect_refused(s, "added mass");
    s.bodies[0].moving->law = MotionLaw{.rate = 0.1};  // one that the water does not move may
    EXPECT_EQ(refusal(s), "");
}

TEST(RefusedCombinations, AFreeBodyBesideParticlesFinerThanItsOwn) {
    SimulationSetup s = tank_with_free_box();
    s.zones = {zone_between(0.4, 1.6, -infinite, infinite)};
    EXPECT_EQ(refusal(s), "");
    s.partial_zones = 1;
    expect_refused(s, "would load it between its steps");
    s.bodies[0].moving.reset();  // one that stays may
    EXPECT_EQ(refusal(s), "");
}

TEST(RefusedCombinations, AirBesideWaterOfSeveralSizes) {
    SimulationSetup s = tank();
    LevelSetup gas = s;
    gas.material = "air";
    gas.rho0 = 1.2;
    const Fluid above = fill_with_air(s, water);
    Simulation one(s, fill_with_fluid(s, water));
    EXPECT_NO_THROW(one.add_gas(gas, {}, above));
    s.zones = {zone_between(0.4, 1.6, -infinite, infinite)};
    Simulation two(s, fill_levels(s, water));
    try {
        two.add_gas(gas, {}, above);
        ADD_FAILURE() << "taken";
    } catch (const InputError& e) {
        EXPECT_NE(std::string(e.what()).find("density and pressure gradient jump"), std::string::npos) << e.what();
    }
}

}  // namespace refused_combinations_test
}  // namespace tw
