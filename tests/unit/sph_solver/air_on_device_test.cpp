// Air beside water in steps that a device makes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <numbers>

#include "../../verification/sph_solver/column_on_plate.h"
#include "on_device.h"
#include "sph_solver/air.h"
#include "sph_solver/effects/moving_tank.h"
#include "sph_solver/effects/viscosity.h"
#include "sph_solver/state/checkpoint.h"

namespace tw {
namespace air_on_device_test {

const std::vector<Box> column{{Vec3(0, 0, 0), Vec3(0.5, 0.3, 0.6)}};

/// Air that impulses, so that lists last some steps only.
Simulation with_air(const SimulationSetup& s, const std::vector<Box>& water = column) {
    Simulation simulation(s, fill_with_fluid(s, water), emulated());
    add_air(simulation, {}, fill_with_air(s, water));
    std::ranges::fill(simulation.gas()->fields_to_set().u, 20.0f);
    return simulation;
}

void expect_same_steps(Simulation& host, Simulation& device, int steps) {
    for (int k = 0; k < steps; ++k) {
        host.step(), device.step();
        ASSERT_EQ(host.dt(), device.dt()) << "step " << k;
        for (std::size_t b = 0; b < host.bodies().size(); ++b) {
            ASSERT_EQ(host.load(b).force, device.load(b).force) << "step " << k;
            ASSERT_EQ(host.gas()->system().walls.loads()[b].force, device.gas()->system().walls.loads()[b].force)
                << "step " << k;
            ASSERT_EQ(host.body(b).state(), device.body(b).state()) << "step " << k;
        }
    }
    EXPECT_TRUE(same_bits(host.particles(), device.particles()));
    EXPECT_TRUE(same_bits(host.gas()->fields().particles(), device.gas()->fields().particles()));
    EXPECT_GT(device.gas()->timers().rebuilds, 1);
}

void expect_the_same_run(const SimulationSetup& s, int steps, const std::vector<Box>& water = column) {
    Simulation host = with_air(s, water), device = with_air(s, water);
    put_on_device(device);
    expect_same_steps(host, device, steps);
}

TEST_F(OnDevice, AFallingColumnDrivesTheAirAsOnTheHost) {
    const SimulationSetup s = dam_break();
    Simulation host = with_air(s), device = with_air(s), alone(s, water_of(s), emulated());
    put_on_device(device);
    expect_same_steps(host, device, 60);
    while (alone.time() < host.time()) alone.step();
    EXPECT_FALSE(same_bits(host.particles(), alone.particles())) << "the air does nothing here";
    PointSamples on_host, on_device;
    on_host.places = on_device.places = {Vec3(0.2, 0.1, 0.2), Vec3(0.7, 0.1, 0.5)};
    host.sample(on_host), device.sample(on_device);
    for (std::size_t n = 0; n < on_host.p.size(); ++n)  // slices may begin at other neighbours
        EXPECT_NEAR(on_host.p[n], on_device.p[n], 1e-5 * std::abs(on_host.p[n]) + 0.1);
    EXPECT_EQ(gas_energy(*host.gas(), s.gravity), gas_energy(*device.gas(), s.gravity));
}

TEST_F(OnDevice, AirBesideViscousWaterInATankThatSwaysAndABodyThatFloats) {
    SimulationSetup s = dam_break();
    BodySetup floats = box_surface({Vec3(0.1, 0.05, 0.55), Vec3(0.3, 0.25, 0.75)});
    floats.moving.emplace();
    floats.moving->mass = solid_mass(floats.surface, 500);
    s.bodies.emplace_back(floats);
    s.frame = MovingFrame{};
    s.frame->law = {.kind = MotionLaw::Kind::sinusoid,
                    .turns = true,
                    .axis = Vec3(0, 1, 0),
                    .amplitude = 0.2,
                    .period = 0.5,
                    .phase = std::numbers::pi / 2};
    s.frame->pivot = Vec3(0.5, 0.15, -0.3);
    s.effects = {Viscosity{0.01, true, {}}, MovingTank{}};
    expect_the_same_run(s, 40);
}

TEST_F(OnDevice, AirUnderAPlateInTwoDimensions) {
    const ColumnOnPlate on_plate{0.01};
    SimulationSetup s = on_plate.setup();
    const double skin = 6 * on_plate.dp, half = on_plate.span / 2;
    s.domain.min.z() = -skin - 0.1;
    s.mirrors.on[2] = {true, false};
    expect_the_same_run(s, 60, {Box{Vec3(-half, -on_plate.dp / 2, 0), Vec3(half, on_plate.dp / 2, on_plate.depth)}});
}

TEST_F(OnDevice, OfAirAndWaterNothingTravelsButTheStepsExtremes) {
    SimulationSetup s = dam_break();
    s.bodies.clear();
    Simulation run = with_air(s);
    const auto device = put_on_device(run);
    run.step();  // takes all there
    const cuda::Device::Traffic from = device->traffic();
    constexpr int steps = 60;
    for (int k = 0; k < steps; ++k) run.step();
    const cuda::Device::Traffic to = device->traffic();
    const double bytes = double(to.to_device - from.to_device + to.to_host - from.to_host) / steps,
                 particles = double(run.level(0).fields().count() + run.gas()->fields().count());
    std::printf("air and water: %.2f bytes a particle and step between host and device\n", bytes / particles);
    EXPECT_LT(bytes, 4 * particles);  // one number of each in single precision
    EXPECT_GT(run.gas()->timers().rebuilds, 1);
}

TEST_F(OnDevice, ACheckpointWithAirGoesFromTheHostToADeviceAndBack) {
    const auto file = std::filesystem::temp_directory_path() / "air_on_device_test.h5";
    const SimulationSetup s = dam_break();
    Simulation whole = with_air(s), device = with_air(s), back = with_air(s);
    put_on_device(device);
    for (int k = 0; k < 40; ++k) whole.step();
    const auto hand_over = [&](const Simulation& from, Simulation& to) {
        write_checkpoint(file, "a scene", checkpoint_of(from, 1));
        whole.mark_restart_point();
        restore(to, read_checkpoint(file, "a scene"));
        expect_same_steps(whole, to, 40);
    };
    hand_over(whole, device);
    hand_over(device, back);
    std::filesystem::remove(file);
}

}  // namespace air_on_device_test
}  // namespace tw
