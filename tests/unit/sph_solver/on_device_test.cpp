#include <gtest/gtest.h>

#include <cmath>
#include <filesystem>

#include "base/errors.h"
#include "meshes/generate.h"
#include "on_device.h"
#include "sph_solver/bench.h"
#include "sph_solver/effects/ventilation.h"
#include "sph_solver/gpu_self_test.h"
#include "sph_solver/measure/spray_gate.h"
#include "sph_solver/state/checkpoint.h"
#include "waves/regular_wave.h"
#include "waves/sea.h"

namespace tw {
namespace on_device_test {

/// A stream past a box that pierces the surface, with walls that let water go.
SimulationSetup stream() {
    SimulationSetup s;
    s.dp = 0.1;
    s.state_equation.c0 = 40;
    s.domain = {Vec3(-1, 0, -1), Vec3(1.5, 0.8, 2)};
    s.mirrors.on = {{{false, false}, {true, true}, {true, false}}};
    s.stream = Stream{4, 0.02, 0.5};
    s.bodies = {box_surface({Vec3(-0.3, -0.3, -0.2), Vec3(0.3, 0.3, 0.4)})};
    s.effects.push_back(Ventilation{});
    s.threads = 1;
    return s;
}
Fluid stream_water(const SimulationSetup& s) {
    Box water = s.domain;
    water.min.x() -= s.stream->buffer, water.max.x() += s.stream->buffer, water.max.z() = 0;
    return fill_with_fluid(s, {water});
}

/// How often a wall had to hold a particle comes out.
void expect_the_same_run(const SimulationSetup& s, const Fluid& water, int steps, std::int64_t* held = nullptr) {
    Simulation host(s, water, emulated()), device(s, water, emulated());
    put_on_device(device);
    for (int k = 0; k < steps; ++k) {
        host.step(), device.step();
        ASSERT_EQ(host.dt(), device.dt()) << "step " << k;
        ASSERT_EQ(host.load().force, device.load().force) << "step " << k;
        ASSERT_EQ(host.load().moment, device.load().moment) << "step " << k;
        ASSERT_EQ(host.extremes().fastest, device.extremes().fastest) << "step " << k;
        if (k % 20 != 7) continue;
        PointSamples on_host, on_device;
        on_host.places = on_device.places = {Vec3(0.05, 0.1, 0.02), Vec3(-0.31, 0.1, -0.1)};
        host.sample(on_host), device.sample(on_device);
        for (std::size_t n = 0; n < on_host.p.size(); ++n) {  // slices may begin at other neighbours
            ASSERT_NEAR(on_host.p[n], on_device.p[n], 1e-5 * std::abs(on_host.p[n]) + 1e-3) << "step " << k;
            ASSERT_NEAR(on_host.support[n], on_device.support[n], 1e-6) << "step " << k;
        }
    }
    EXPECT_TRUE(same_bits(host.particles(), device.particles()));
    EXPECT_GT(host.level(0).timers().rebuilds, 2);
    EXPECT_NE(host.load().force.norm(), 0);
    EXPECT_EQ(host.ledger().held, device.ledger().held);
    if (held) *held = device.ledger().held;
}

TEST_F(OnDevice, AFallingColumnTakesTheStepsOfTheHostBitForBit) {
    expect_the_same_run(dam_break(), water_of(dam_break()), 60);
}

// What doctor asks a GPU: an exact answer, to a case that sorts, finds neighbours and walls, and steps.
TEST_F(OnDevice, PassesItsSelfTest) {
    const double error = gpu_self_test();
    std::cout << "self-test: error " << error << '\n';
    EXPECT_LT(error, sound_gpu_error);
    EXPECT_GT(error, 0) << "no pressure of particles is exact";
}

// Ten million particles of one size in 4 GB of the device; so few as here have more images each.
TEST_F(OnDevice, AParticleTakesLessThanFourHundredBytes) {
    const BenchResult r = run_bench_on_gpu(60000, 1.55, 1, 0);
    std::cout << r.bytes_on_device << " bytes a particle on the device, of " << r.bytes_per_particle << '\n';
    EXPECT_LT(r.bytes_on_device, 400);
    EXPECT_GT(r.bytes_on_device, 2 * 49) << "the state alone, twice for sorting";
}

TEST_F(OnDevice, SoDoesAStreamWithInletOutletAndAirAlongItsWalls) {
    expect_the_same_run(stream(), stream_water(stream()), 40);
}

TEST_F(OnDevice, SoDoesAWaveThatEntersWithIt) {
    SimulationSetup s = stream();
    const RegularWave wave = regular_wave({.height = 0.2, .length = 4, .depth = 1, .closed = false, .stream = 4});
    s.stream->wave = Stream::Wave{in_stream(wave), wave.gravity, 0.02, 0.05};
    expect_the_same_run(s, stream_water(s), 40);
}

TEST_F(OnDevice, SoDoesASumOfWavesThatEntersWithIt) {
    SimulationSetup s = stream();
    const Sea sea = make_sea({.depth = 1, .stream = 4, .height = 0.2, .peak_period = 1.2, .components = 12});
    s.stream->wave = Stream::Wave{sea_in_stream(sea.waves), sea.gravity, 0.02, 0.05};
    expect_the_same_run(s, stream_water(s), 40);
}

TEST_F(OnDevice, ParticlesThatAWallHasToHoldAreLookedAfterByTheHost) {
    SimulationSetup s = dam_break();
    s.bodies = {box_surface({Vec3(0.45, -0.4, -0.3), Vec3(0.8, 0.7, 0.15)})};
    const Fluid water = fill_with_fluid(s, {Box{Vec3(0, 0, 0.3), Vec3(1, 0.3, 0.6)}});  // falls on it
    std::int64_t held = 0;
    expect_the_same_run(s, water, 250, &held);
    EXPECT_GT(held, 0);
}

TEST_F(OnDevice, ABodyThatFloatsAndOneThatIsMovedAreCarriedByTheDevicesWater) {
    SimulationSetup s = dam_break();
    BodySetup floats = box_surface({Vec3(0.2, 0.05, 0.5), Vec3(0.4, 0.25, 0.7)});
    floats.moving.emplace();
    floats.moving->mass = solid_mass(floats.surface, 500);
    BodySetup falls = box_surface({Vec3(0.7, 0.05, 0.55), Vec3(0.9, 0.25, 0.75)});
    falls.moving.emplace();
    falls.moving->mass = solid_mass(falls.surface, 900);
    falls.moving->velocity = Vec3(0, 0, -1);
    s.bodies = {floats, falls};
    const Fluid water = fill_with_fluid(s, {Box{Vec3(0, 0, 0), Vec3(1, 0.3, 0.6)}});
    Simulation host(s, water, emulated()), device(s, water, emulated());
    put_on_device(device);
    for (int k = 0; k < 100; ++k) {
        host.step(), device.step();
        ASSERT_EQ(host.load(0).force, device.load(0).force) << "step " << k;
        ASSERT_EQ(host.load(1).moment, device.load(1).moment) << "step " << k;
    }
    EXPECT_TRUE(same_bits(host.particles(), device.particles()));
    EXPECT_EQ(host.body(0).state(), device.body(0).state());
    EXPECT_GT((host.body(1).now(Vec3::Zero())).norm(), 0.01);  // it has moved
}

TEST_F(OnDevice, InTwoDimensionsTheStepsAreTheSameToo) {
    SimulationSetup s = dam_break();
    s.dimensions = 2;
    s.dp = 0.02;
    s.mirrors.on[1] = {false, false};
    s.domain = {Vec3(0, -0.01, 0), Vec3(1, 0.01, 1)};
    s.bodies = {box_surface({Vec3(0.6, -0.4, -0.3), Vec3(0.8, 0.7, 0.15)})};
    expect_the_same_run(s, fill_with_fluid(s, {Box{Vec3(0, -0.01, 0), Vec3(0.5, 0.01, 0.6)}}), 120);
}

TEST_F(OnDevice, ACheckpointGoesFromTheHostToADeviceAndBack) {
    const auto file = std::filesystem::temp_directory_path() / "on_device_test.h5";
    const SimulationSetup s = stream();
    Simulation whole(s, stream_water(s), emulated());
    for (int k = 0; k < 20; ++k) whole.step();
    write_checkpoint(file, "a scene", checkpoint_of(whole, 1));
    whole.mark_restart_point();
    Simulation device(s, stream_water(s), emulated());
    put_on_device(device);
    restore(device, read_checkpoint(file, "a scene"));
    for (int k = 0; k < 20; ++k) whole.step(), device.step();
    EXPECT_TRUE(same_bits(whole.particles(), device.particles()));
    write_checkpoint(file, "a scene", checkpoint_of(device, 1));
    whole.mark_restart_point();
    Simulation back(s, stream_water(s), emulated());
    restore(back, read_checkpoint(file, "a scene"));
    for (int k = 0; k < 20; ++k) whole.step(), back.step();
    EXPECT_TRUE(same_bits(whole.particles(), back.particles()));
    std::filesystem::remove(file);
}

TEST_F(OnDevice, WhatTheHostChangesBetweenTwoStepsCounts) {
    const SimulationSetup s = dam_break();
    Simulation host(s, water_of(s), emulated()), device(s, water_of(s), emulated());
    put_on_device(device);
    for (int k = 0; k < 5; ++k) host.step(), device.step();
    host.fields_to_set().u[17] += 0.5f, device.fields_to_set().u[17] += 0.5f;
    for (int k = 0; k < 5; ++k) host.step(), device.step();
    EXPECT_TRUE(same_bits(host.particles(), device.particles()));
}

TEST_F(OnDevice, TheSprayGateTakesTheSameLumps) {
    SimulationSetup s = dam_break();
    s.bodies.clear();
    const Fluid water = fill_with_fluid(s, {Box{{0, 0, 0}, {1, 0.3, 0.3}}, Box{{0.2, 0.1, 0.7}, {0.3, 0.2, 0.8}}});
    SphOptions beyond;
    beyond.gate_point = {0, 0, 0.5}, beyond.gate_normal = {0, 0, 1};
    const auto gate = SprayGate::of(beyond);
    Simulation host(s, water, emulated()), device(s, water, emulated());
    put_on_device(device);
    for (int k = 0; k < 5; ++k) host.step(), device.step();
    const std::vector<SprayLump> from_host = gate->take(host), from_device = gate->take(device);
    ASSERT_EQ(from_device.size(), 1u);
    EXPECT_EQ(from_device[0].particles, 8);
    EXPECT_EQ(from_device[0].velocity, from_host[0].velocity);
    for (int k = 0; k < 20; ++k) host.step(), device.step();
    EXPECT_TRUE(same_bits(host.particles(), device.particles()));
    EXPECT_EQ(device.ledger().out, 8);
}

TEST_F(OnDevice, NotANumberStopsTheRunThereToo) {
    const SimulationSetup s = dam_break();
    Simulation device(s, water_of(s), emulated());
    put_on_device(device);
    device.step();
    device.fields_to_set().u[17] = std::numeric_limits<float>::quiet_NaN();
    try {
        device.step();
        FAIL() << "went on";
    } catch (const RunError& e) {
        EXPECT_NE(std::string(e.what()).find("not a number"), std::string::npos) << e.what();
        EXPECT_NE(std::string(e.what()).find("water particle"), std::string::npos) << e.what();
    }
}

std::string complaint() {
    try {
        cuda::Device::open();
    } catch (const InputError& e) { return e.what(); }
    return {};
}

TEST_F(OnDevice, NoneOrOneThatIsTooOldIsSaid) {
    if (real()) GTEST_SKIP() << "a real device is what it is";
    EXPECT_EQ(cuda::Device::reason_against(), "");
    pretend("no_device");
    EXPECT_NE(complaint().find("the driver knows no device"), std::string::npos) << complaint();
    pretend("old_device");
    EXPECT_NE(complaint().find("compute capability 6.0, and 8.0 is needed"), std::string::npos) << complaint();
    pretend("two_devices");
    const auto second = cuda::Device::open();
    EXPECT_EQ(second->name(), "Emulated device");
    EXPECT_EQ(second->number(), 2);
    EXPECT_EQ(second->of(), 2);
    setenv("TWINWAKE_LIBCUDA", "/nowhere/libcuda.so.1", 1);
    EXPECT_NE(complaint().find("no driver was found"), std::string::npos) << complaint();
}

TEST_F(OnDevice, TooLittleMemoryAndALostDeviceEndTheRunInWords) {
    if (real()) GTEST_SKIP() << "a real device is what it is";
    const SimulationSetup s = dam_break();
    const auto what_ends = [&](const char* trouble) -> std::string {
        pretend(trouble);
        Simulation device(s, water_of(s), emulated());
        put_on_device(device);
        try {
            for (int k = 0; k < 20; ++k) device.step();
        } catch (const RunError& e) { return e.what(); }
        return {};
    };
    EXPECT_NE(what_ends("memory=200000").find("MB left for the particles"), std::string::npos);
    const std::string lost = what_ends("lost_after=40");
    EXPECT_NE(lost.find("unspecified launch failure"), std::string::npos) << lost;
}

}  // namespace on_device_test
}  // namespace tw
