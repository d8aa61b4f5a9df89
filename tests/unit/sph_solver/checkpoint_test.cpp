#include <gtest/gtest.h>

#include <filesystem>

#include "sph_solver/state/checkpoint.h"

namespace tw {
namespace checkpoint_test {

/// Water with finer particles in a part of it, which the balance round the bodies does not belong to.
struct Balanced {
    Simulation simulation;
    Balanced() : Balanced(setup()) {}

private:
    explicit Balanced(const SimulationSetup& s) : simulation(s, fill_levels(s, {Box{s.domain.min, Vec3(4, 1, 0)}})) {
        simulation.set_control_volume(ControlVolume({Vec3(1.5, -1, -0.3), Vec3(2.5, 1, 0.3)}, 0.1, {2}));
    }
    static SimulationSetup setup() {
        SimulationSetup s;
        s.dimensions = 2;
        s.threads = 1;
        s.dp = 0.05;
        s.state_equation.c0 = 20;
        s.domain = {Vec3(0, -1, -1), Vec3(4, 1, 1)};
        s.mirrors.on = {{{true, true}, {false, false}, {true, false}}};
        s.zones = {Zone({Box{Vec3(1, -1, -0.5), Vec3(3, 1, 0.5)}})};
        s.partial_zones = 1;
        return s;
    }
};

TEST(Checkpoint, GivesTheBalanceBackToTheLevelThatHasIt) {
    const auto file = std::filesystem::temp_directory_path() / "twinwake_balance_test.h5";
    Balanced first, second;
    Simulation &whole = first.simulation, &resumed = second.simulation;
    ASSERT_NE(&whole.at_bodies(), &whole.finest()) << "or this test sees nothing";
    whole.step();
    whole.control_volume()->set_state({Vec3(1, 2, 3), Vec3(4, 5, 6), 0.5});
    write_checkpoint(file, "a scene", whole, 1);
    restore(resumed, read_checkpoint(file, "a scene"));
    std::filesystem::remove(file);
    const ControlVolume::State& state = resumed.control_volume()->state();
    EXPECT_EQ(state.crossed, Vec3(1, 2, 3));
    EXPECT_EQ(state.impulse, Vec3(4, 5, 6));
    EXPECT_EQ(state.since, 0.5);
    EXPECT_EQ(resumed.time(), whole.time());
}

}  // namespace checkpoint_test
}  // namespace tw
