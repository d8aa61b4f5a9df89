#include <gtest/gtest.h>

#include <hdf5.h>

#include <cmath>
#include <filesystem>

#include "base/atomic_file.h"
#include "base/errors.h"
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
    write_checkpoint(file, "a scene", checkpoint_of(whole, 1));
    restore(resumed, read_checkpoint(file, "a scene"));
    std::filesystem::remove(file);
    const ControlVolume::State& state = resumed.control_volume()->state();
    EXPECT_EQ(state.crossed, Vec3(1, 2, 3));
    EXPECT_EQ(state.impulse, Vec3(4, 5, 6));
    EXPECT_EQ(state.since, 0.5);
    EXPECT_EQ(resumed.time(), whole.time());
}

std::string refusal(const std::filesystem::path& file) {
    try {
        read_checkpoint(file, "a scene");
    } catch (const InputError& e) { return e.what(); }
    return {};
}

/// Fletcher-32, HDF5's own sum, takes bytes of FF for bytes of 00; the line behind the file does not.
TEST(Checkpoint, WhoseZerosBecameOnesIsRefused) {
    const auto file = std::filesystem::temp_directory_path() / "twinwake_zeros_test.h5";
    Balanced whole;
    write_checkpoint(file, "a scene", checkpoint_of(whole.simulation, 1));
    EXPECT_EQ(refusal(file), "");
    std::string bytes = read_text(file);
    const std::size_t zeros = bytes.find(std::string(64, '\0'), bytes.size() / 2);
    ASSERT_NE(zeros, std::string::npos);
    for (std::size_t k = 0; k < 64; ++k) bytes[zeros + k] = '\xff';
    write_text_atomically(file, bytes);
    EXPECT_NE(refusal(file).find("twinwake_zeros_test.h5: cannot be resumed from: "), std::string::npos);
    std::filesystem::remove(file);
}

TEST(Checkpoint, OfAnotherFormatIsRefusedByName) {
    const auto file = std::filesystem::temp_directory_path() / "twinwake_format_test.h5";
    Balanced whole;
    for (const auto& [format, words] : {std::pair{2.0, "of format 2, by an earlier version"},
                                        {99.0, "of format 99, by a later version"},
                                        {std::nan(""), "its format is no number from 1 on"}}) {
        write_checkpoint(file, "a scene", checkpoint_of(whole.simulation, 1));
        const hid_t h = H5Fopen(file.c_str(), H5F_ACC_RDWR, H5P_DEFAULT);
        const hid_t attribute = H5Aopen(h, "twinwake_checkpoint", H5P_DEFAULT);
        H5Awrite(attribute, H5T_NATIVE_DOUBLE, &format);
        H5Aclose(attribute);
        H5Fclose(h);
        EXPECT_NE(refusal(file).find(words), std::string::npos) << refusal(file);
    }
    std::filesystem::remove(file);
}

}  // namespace checkpoint_test
}  // namespace tw
