// "An effect that is off costs nothing": no instruction, no byte of a checkpoint.
#include <gtest/gtest.h>

#include <array>
#include <cmath>
#include <cstdio>
#include <filesystem>
#include <string>

#include "sph_solver/effects/acoustic_damping.h"
#include "sph_solver/effects/cavitation.h"
#include "sph_solver/effects/forcing_zones.h"
#include "sph_solver/effects/surface_tension.h"
#include "sph_solver/effects/viscosity.h"
#include "sph_solver/simulation.h"
#include "sph_solver/state/checkpoint.h"

namespace tw {
namespace off_is_free_test {

/// What a command prints on both its channels.
std::string output_of(const std::string& command) {
    FILE* pipe = popen((command + " 2>&1").c_str(), "r");
    std::string text;
    std::array<char, 4096> buffer;
    while (pipe && fgets(buffer.data(), buffer.size(), pipe)) text += buffer.data();
    if (pipe) pclose(pipe);
    return text;
}

struct Count {
    double instructions = 0;
    std::string result;
};
Count count_of(const std::string& program) {
    const std::string text = output_of(
        "TWINWAKE_ISA=baseline OMP_NUM_THREADS=1 valgrind --tool=callgrind "
        "--callgrind-out-file=/dev/null '" +
        program + "'");
    Count c;
    const auto at = text.find("Collected : ");
    if (at != std::string::npos) c.instructions = std::stod(text.substr(at + 12));
    if (const auto line = text.find(" particles, "); line != std::string::npos)
        c.result = text.substr(line, text.find('\n', line) - line);
    return c;
}

TEST(OffIsFree, ARunWithoutEffectsCountsTheInstructionsOfABuildThatLacksThem) {
    const Count full = count_of(FULL), bare = count_of(BARE);
    ASSERT_GT(full.instructions, 1e7) << "valgrind has to be installed";
    ASSERT_GT(bare.instructions, 1e7);
    EXPECT_EQ(full.result, bare.result);
    std::printf("instructions: %.6g with the effects in the build and off, %.6g without them: %+.4f %%\n",
                full.instructions, bare.instructions, 100 * (full.instructions / bare.instructions - 1));
    EXPECT_LT(std::abs(full.instructions / bare.instructions - 1), 0.005);
}

/// Effects hold no state between steps, so that a checkpoint is as long with them as without.
TEST(OffIsFree, ACheckpointDoesNotGrow) {
    const auto length = [](bool on) {
        SimulationSetup s;
        s.dimensions = 2;
        s.dp = 0.05;
        s.state_equation.c0 = 20;
        s.domain = {Vec3(0, -1, 0), Vec3(1, 1, 1)};
        s.mirrors.on = {{{true, true}, {false, false}, {true, false}}};
        s.threads = 1;
        if (on) {
            s.effects = {AcousticDamping{}, Cavitation{}, Viscosity{1e-3, true, EddyViscosity{}}, SurfaceTension{},
                         ZoneForcing{{{0, true, 0.8, 1.0, 1}}}};
        }
        Simulation simulation(s, fill_with_fluid(s, {Box{Vec3(0, -1, 0), Vec3(0.5, 1, 0.5)}}));
        for (int k = 0; k < 5; ++k) simulation.step();
        const auto file = std::filesystem::temp_directory_path() / (on ? "tw_effects_on.h5" : "tw_effects_off.h5");
        write_checkpoint(file, "same", checkpoint_of(simulation, 1));
        const auto size = std::filesystem::file_size(file);
        std::filesystem::remove(file);
        return size;
    };
    EXPECT_EQ(length(true), length(false));
}

}  // namespace off_is_free_test
}  // namespace tw
