#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "meshes/generate.h"
#include "on_device.h"
#include "sph_solver/effects/acoustic_damping.h"
#include "sph_solver/effects/cavitation.h"
#include "sph_solver/effects/forcing_zones.h"
#include "sph_solver/effects/moving_tank.h"
#include "sph_solver/effects/surface_tension.h"
#include "sph_solver/effects/viscosity.h"
#include "sph_solver/equations/power_less_one.h"

namespace tw {
namespace effects_on_device_test {

/// The device takes the steps of the host, and not those of `without`: of a run without what is asked about.
void expect_the_same_run(const SimulationSetup& s, const SimulationSetup& without, int steps) {
    const Fluid water = water_of(s);
    Simulation host(s, water, emulated()), device(s, water, emulated()), other(without, water_of(without), emulated());
    put_on_device(device);
    for (int k = 0; k < steps; ++k) {
        host.step(), device.step(), other.step();
        ASSERT_EQ(host.dt(), device.dt()) << "step " << k;
        for (std::size_t b = 0; b < s.bodies.size(); ++b) {
            ASSERT_EQ(host.load(b).force, device.load(b).force) << "step " << k;
            ASSERT_EQ(host.load(b).friction, device.load(b).friction) << "step " << k;
            ASSERT_EQ(host.load(b).moment, device.load(b).moment) << "step " << k;
        }
    }
    EXPECT_TRUE(same_bits(host.particles(), device.particles()));
    EXPECT_FALSE(same_bits(host.particles(), other.particles())) << "what is asked about does nothing here";
    EXPECT_GT(host.level(0).timers().rebuilds, 1);
}
void expect_the_same_run_with(const EffectOptions& effects, const SimulationSetup& plain, int steps) {
    SimulationSetup s = plain;
    s.effects = effects;
    expect_the_same_run(s, plain, steps);
}

TEST_F(OnDevice, AcousticDampingIsThatOfTheHost) { expect_the_same_run_with({AcousticDamping{}}, dam_break(), 40); }

TEST_F(OnDevice, TheCutOffOfCavitationToo) { expect_the_same_run_with({Cavitation{-100}}, dam_break(), 60); }

TEST_F(OnDevice, ForcingZonesOfSeveralWidthsAndStrengthsToo) {
    expect_the_same_run_with(
        {ZoneForcing{{{0, true, 0.4, 1.0, 20}, {1, false, 0.1, 0.0, 5}, {0, false, 0.1, 0.0, 40}}}}, dam_break(), 60);
}

TEST_F(OnDevice, ViscosityOfWaterThatWallsTankAndAMovingBodyHold) {
    SimulationSetup s = dam_break();
    s.mirrors.holding = {{{true, false}, {false, true}, {true, false}}};
    BodySetup falls = box_surface({Vec3(0.1, 0.05, 0.55), Vec3(0.3, 0.25, 0.75)});
    falls.moving.emplace();
    falls.moving->mass = solid_mass(falls.surface, 900);
    falls.moving->velocity = Vec3(0, 0, -1);
    s.bodies = {BodySetup(box_surface({Vec3(0.6, -0.4, -0.3), Vec3(0.8, 0.7, 0.15)}), Vec3(0, 0.5, 0)), falls};
    SimulationSetup slips = s;
    s.effects = {Viscosity{0.01, true, {}}};
    slips.effects = {Viscosity{0.01, false, {}}};
    expect_the_same_run(s, slips, 50);
}

TEST_F(OnDevice, EddiesToo) {
    SimulationSetup s = dam_break();
    s.mirrors.holding = {{{false, false}, {false, true}, {true, false}}};
    SimulationSetup laminar = s;
    laminar.effects = {Viscosity{1e-3, true, {}}};
    s.effects = {Viscosity{1e-3, true, EddyViscosity{0.5}}};
    expect_the_same_run(s, laminar, 50);
}

TEST_F(OnDevice, SurfaceTensionBesideOtherEffects) {
    SimulationSetup s = dam_break(), without = s;
    s.effects = {Cavitation{-200}, Viscosity{1e-3, false, {}}, SurfaceTension{20}};
    without.effects = {Cavitation{-200}, Viscosity{1e-3, false, {}}};
    expect_the_same_run(s, without, 50);
}

TEST_F(OnDevice, EffectsInTwoDimensions) {
    SimulationSetup s = dam_break();
    s.dimensions = 2;
    s.dp = 0.02;
    s.mirrors.on[1] = {false, false};
    s.domain = {Vec3(0, -0.01, 0), Vec3(1, 0.01, 1)};
    expect_the_same_run_with({Viscosity{1e-3, true, EddyViscosity{}}, SurfaceTension{1}}, s, 40);
}

TEST_F(OnDevice, ATankThatSwaysAndOneThatRollsCarryTheirWaterAndABodyInIt) {
    SimulationSetup s = dam_break();
    BodySetup floats = box_surface({Vec3(0.1, 0.05, 0.55), Vec3(0.3, 0.25, 0.75)});
    floats.moving.emplace();
    floats.moving->mass = solid_mass(floats.surface, 500);
    for (const bool turns : {false, true}) {
        if (turns) s.bodies.emplace_back(floats);
        SimulationSetup rests = s;
        s.frame = MovingFrame{};
        s.frame->law = {.kind = MotionLaw::Kind::sinusoid,
                        .turns = turns,
                        .axis = Vec3(0.6, 0.8, 0),
                        .amplitude = 0.2,
                        .period = 0.5,
                        .phase = std::numbers::pi / 2};
        s.frame->pivot = Vec3(0.5, 0.15, -0.3);
        s.effects = {MovingTank{}};
        expect_the_same_run(s, rests, 30);
    }
}

TEST_F(OnDevice, OtherEquationsOfStateToo) {
    for (const auto form : {StateEquation::Form::tait, StateEquation::Form::mie_grueneisen}) {
        SimulationSetup s = dam_break(), linear = s;
        s.state_equation.c0 = linear.state_equation.c0 = 15;
        s.state_equation.form = form;
        expect_the_same_run(s, linear, 40);
    }
}

TEST_F(OnDevice, SchemesOfSeveralStagesToo) {
    for (const auto scheme : {Scheme::predictor_corrector, Scheme::rk4_frozen_diffusion, Scheme::symplectic_euler}) {
        SimulationSetup s = dam_break(), other = s;
        s.scheme = scheme;
        expect_the_same_run(s, other, 20);
    }
}

TEST(PowerLessOne, IsThatOfTheMathematicalLibrary) {
    for (const double n : {1.0, 7.0, 13.6, 20.0})
        for (double x = -0.5; x <= 0.5; x += 0.0009765625) {
            const double exact = std::expm1(n * std::log1p(x));
            EXPECT_NEAR(power_less_one(x, n), exact, 1e-14 * std::abs(exact)) << x << " " << n;
        }
    for (const double n : {0.5, 1.4, 2.0})  // a gas
        for (double x = -0.95; x <= 10; x += 0.0078125) {
            const double exact = std::expm1(n * std::log1p(x));
            EXPECT_NEAR(power_less_one(x, n), exact, 1e-14 * std::abs(exact)) << x << " " << n;
        }
    EXPECT_NEAR(power_less_one(1e-9, 7), 7e-9 * (1 + 3e-9), 1e-23);
    for (const double x : {HUGE_VAL, -2.0, -1.0}) power_less_one(x, 1.4);  // comes to an end
}

}  // namespace effects_on_device_test
}  // namespace tw
