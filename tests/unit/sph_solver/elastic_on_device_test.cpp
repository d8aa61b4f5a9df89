// Bodies that bend in water whose steps a device makes.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdio>
#include <filesystem>
#include <limits>

#include "../../verification/sph_solver/column_on_plate.h"
#include "on_device.h"
#include "sph_solver/state/checkpoint.h"

namespace tw {
namespace elastic_on_device_test {

::testing::AssertionResult same_bits(const Simulation& a, const Simulation& b) {
    for (std::size_t k = 0; k < a.levels().size(); ++k)
        if (const auto same = tw::same_bits(a.level(k).fields().particles(), b.level(k).fields().particles()); !same)
            return ::testing::AssertionFailure() << "level " << k << ": " << same.message();
    for (std::size_t k = 0; k < a.bodies().size(); ++k)
        if (a.body(k).state() != b.body(k).state()) return ::testing::AssertionFailure() << "body " << k << " differs";
    return ::testing::AssertionSuccess();
}

void expect_same_steps(Simulation& host, Simulation& device, int steps) {
    for (int k = 0; k < steps; ++k) {
        host.step(), device.step();
        ASSERT_EQ(host.dt(), device.dt()) << "step " << k;
        for (std::size_t b = 0; b < host.bodies().size(); ++b) {
            ASSERT_EQ(host.load(b).force, device.load(b).force) << "step " << k;
            ASSERT_EQ(host.body(b).state(), device.body(b).state()) << "step " << k;
        }
    }
    EXPECT_TRUE(same_bits(host, device));
}

struct Runs {
    Simulation host, device;
    Runs(const SimulationSetup& s, const std::vector<Fluid>& water)
        : host(s, water, emulated()), device(s, water, emulated()) {
        put_on_device(device);
    }
};

TEST_F(OnDevice, APlateBendsUnderTheDevicesWaterAsUnderTheHosts) {
    const ColumnOnPlate column{0.01};
    for (const bool large_rotations : {false, true}) {
        const SimulationSetup s = column.setup(1, large_rotations);
        Runs run(s, {column.water(s)});
        expect_same_steps(run.host, run.device, 60);
        EXPECT_LT(plate_of(run.device).deflection(0).z(), -1e-5);
        EXPECT_GT(run.device.level(0).timers().rebuilds, 1);
    }
}

TEST_F(OnDevice, APlateAndTheDevicesWaterAnswerEachOtherSeveralTimesAStep) {
    const ColumnOnPlate column{0.01};
    SimulationSetup s = column.setup();
    auto setup = std::make_shared<ElasticSetup>(*s.bodies[0].elastic);
    setup->coupling.iterations = 3;
    s.bodies[0] = BodySetup(setup);
    Runs run(s, {column.water(s)});
    expect_same_steps(run.host, run.device, 30);
}

TEST_F(OnDevice, APlatePressesOnTheDevicesWaterByPenaltyContact) {
    const ColumnOnPlate column{0.01};
    SimulationSetup s = column.setup();
    auto setup = std::make_shared<ElasticSetup>(*s.bodies[0].elastic);
    setup->coupling.interface = penalty_interface({.law = PenaltyContact::Law::adaptive, .factor = 1e-3});
    s.bodies[0] = BodySetup(setup);
    Runs run(s, {column.water(s)});
    expect_same_steps(run.host, run.device, 60);
    EXPECT_FALSE(run.device.level(0).system().walls.pushes().empty());
}

TEST_F(OnDevice, APlateBendsUnderWaterOfTwoSizes) {
    const ColumnOnPlate column{0.005};
    SimulationSetup s = column.setup();
    constexpr double endless = std::numeric_limits<double>::infinity();
    s.zones = {Zone({Box{Vec3(-endless, -endless, -endless), Vec3(endless, endless, 0.06)}})};
    const Box water{Vec3(-column.span / 2, -column.dp / 2, 0), Vec3(column.span / 2, column.dp / 2, 0.12)};
    Runs run(s, fill_levels(s, {water}));
    expect_same_steps(run.host, run.device, 20);
}

/// The host looks after particles that the plate has to hold, and the plate gets their impulses.
TEST_F(OnDevice, APlateHoldsParticlesThatStrikeIt) {
    const ColumnOnPlate column{0.01};
    const SimulationSetup s = column.setup();
    Runs run(s, {column.water(s)});
    for (Simulation* of : {&run.host, &run.device}) {
        const std::vector<double>& z = of->particles().z;
        const auto lowest = std::ranges::min_element(z) - z.begin();
        of->level(0).fields_to_set().w[static_cast<std::size_t>(lowest)] = -8;
    }
    expect_same_steps(run.host, run.device, 40);
    EXPECT_EQ(run.host.ledger().held, run.device.ledger().held);
    EXPECT_GT(run.device.ledger().held, 0);
}

/// A flap of rubber on the floor of the tank, in the way of the column; and a box that floats.
SimulationSetup flap() {
    SimulationSetup s = dam_break();
    structure::ShellMesh mesh = structure::plate_mesh(0.4, 0.6, 8, 6);
    for (Vec3& p : mesh.nodes) p = Vec3(0.6, p.y() - 0.15, p.x() - 0.1);
    structure::Shell shell(mesh, structure::Laminate({{structure::isotropic(1e6, 0.3, 1100), 0, 0.02}}), Vec3::UnitZ());
    structure::DegreesOfFreedom dofs(mesh.nodes, 6);
    for (int n = 0; n < static_cast<int>(mesh.nodes.size()); ++n)
        if (const int node[] = {n}; mesh.nodes[static_cast<std::size_t>(n)].z() < 1e-9) dofs.clamp(node);
    BodySetup floats = box_surface({Vec3(0.1, 0.05, 0.55), Vec3(0.3, 0.25, 0.75)});
    floats.moving.emplace();
    floats.moving->mass = solid_mass(floats.surface, 500);
    s.bodies = {BodySetup(box_surface({Vec3(0.85, -0.4, -0.3), Vec3(1.2, 0.7, 0.1)})), floats,
                BodySetup(std::make_shared<ElasticSetup>(ElasticSetup{
                    .structure = ElasticShell{.shell = std::move(shell), .skin = 0.1}, .dofs = std::move(dofs)}))};
    return s;
}

TEST_F(OnDevice, AFlapBendsInThreeDimensionsBesideBodiesThatAreRigid) {
    const SimulationSetup s = flap();
    Runs run(s, {water_of(s)});
    expect_same_steps(run.host, run.device, 100);
    const auto& bends = dynamic_cast<const ElasticBody&>(run.device.body(2));
    EXPECT_GT(bends.kinetic_energy(), 0);
    EXPECT_GT(bends.work_exchanged(), 0);
}

TEST_F(OnDevice, ACheckpointWithAPlateGoesFromTheHostToADeviceAndBack) {
    const auto file = std::filesystem::temp_directory_path() / "elastic_on_device_test.h5";
    const SimulationSetup s = flap();
    Simulation whole(s, water_of(s), emulated()), back(s, water_of(s), emulated()), device(s, water_of(s), emulated());
    put_on_device(device);
    for (int k = 0; k < 40; ++k) whole.step();
    const auto hand_over = [&](const Simulation& from, Simulation& to) {
        write_checkpoint(file, "a scene", checkpoint_of(from, 1));
        whole.mark_restart_point();
        restore(to, read_checkpoint(file, "a scene"));
        expect_same_steps(whole, to, 25);
    };
    hand_over(whole, device);
    hand_over(device, back);
    EXPECT_GT(dynamic_cast<const ElasticBody&>(back.body(2)).work_exchanged(), 0);
    std::filesystem::remove(file);
}

/// Of the water only what is near the plate travels: more of it above makes no difference but for the step's extremes.
TEST_F(OnDevice, OfTheWaterOverAPlateOnlyWhatIsNearItTravels) {
    const ColumnOnPlate column{0.005};
    const SimulationSetup s = column.setup();
    double bytes[2];
    std::int64_t particles[2];
    for (int twice = 0; twice < 2; ++twice) {
        const double depth = twice ? 0.2 : 0.1, half = column.span / 2;
        Simulation run(s, fill_with_fluid(s, {Box{Vec3(-half, -column.dp / 2, 0), Vec3(half, column.dp / 2, depth)}}),
                       emulated());
        const auto device = put_on_device(run);
        run.step();  // takes all there
        const cuda::Device::Traffic from = device->traffic();
        constexpr int steps = 10;
        for (int k = 0; k < steps; ++k) run.step();
        const cuda::Device::Traffic to = device->traffic();
        bytes[twice] = double(to.to_device - from.to_device + to.to_host - from.to_host) / steps;
        particles[twice] = run.level(0).fields().count();
    }
    const double more = (bytes[1] - bytes[0]) / double(particles[1] - particles[0]);
    std::printf("a plate under water: %.0f bytes a step, and %.2f more for each particle more\n", bytes[0], more);
    EXPECT_LT(more, 4);  // one number of a particle in single precision
    EXPECT_GT(bytes[0], 24 * double(s.bodies.size()));
}

}  // namespace elastic_on_device_test
}  // namespace tw
