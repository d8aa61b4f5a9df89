// Several processes, each with a GPU of its own: the same record and the same checkpoint, byte for byte, as one process
// with one. The GPUs are the driver without a device of tests/fake_cuda.
#include <cstdlib>
#include <string>
#include <vector>

#include "base/atomic_file.h"
#include "program.h"
#include "ranks_run.h"
#include "record/run_record.h"
#include "test_paths.h"

namespace tw::test {
namespace ranks_on_gpu_test {

using namespace ranks_test;

class RanksOnGpu : public Ranks {
protected:
    void SetUp() override {
        Ranks::SetUp();
        setenv("TWINWAKE_LIBCUDA", TWINWAKE_FAKE_CUDA, 1);
        setenv("FAKE_CUDA", "devices=2", 1);
    }
    void TearDown() override { unsetenv("TWINWAKE_LIBCUDA"), unsetenv("FAKE_CUDA"); }

    static std::vector<std::string> on_gpu(std::vector<std::string> more) {
        more.insert(more.end(), {"--device", "gpu"});
        return more;
    }
    /// Also whether GPUs made the steps.
    void same(const fs::path& scene, const std::vector<int>& ranks, const std::vector<std::string>& more) {
        same_for_any_ranks(scene, folder_.path(), ranks, on_gpu(more));
        for (const int n : ranks) {
            RunRecord record = read_record(folder_.path() / ("ranks_" + std::to_string(n)) / "sph/record.h5");
            EXPECT_EQ(record.attributes["device"], "Emulated device");
            EXPECT_EQ(record.attributes["ranks"], std::to_string(n));
        }
    }
    fs::path written(const std::string& text) const {
        const fs::path scene = folder_.path() / "scene.toml";
        write_text_atomically(scene, text);
        return scene;
    }

    const ScratchFolder folder_{"ranks_on_gpu"};
};

TEST_F(RanksOnGpu, WaterThatStrikesAnObstacleHasTheSameBytes) {
    same(written(column_on_an_obstacle), {2, 3}, {"--near-hull", "40mm", "--duration", "0.12s"});
}

TEST_F(RanksOnGpu, AHullBetweenInletAndOutletHasTheSameBytes) {
    same(fs::path(TWINWAKE_SOURCE) / "tests/robustness/runs/small_planing.toml", {3}, {"--duration", "0.012s"});
}

TEST_F(RanksOnGpu, ABodyThatFallsIntoWaterHasTheSameBytes) {
    // it touches the water after 0.05 s
    same(fs::path(TWINWAKE_SOURCE) / "tests/robustness/runs/small_entry.toml", {2},
         {"--near-hull", "40mm", "--duration", "0.12s"});
}

TEST_F(RanksOnGpu, EffectsHaveTheSameBytes) {
    std::vector<std::string> on{"--near-hull", "40mm", "--duration", "0.015s"};
    for (const char* effect : {"viscosity", "no_slip", "turbulence", "surface_tension", "ventilation", "cavitation",
                               "acoustic_damping", "forcing_zones"})
        on.insert(on.end(), {"--effect", std::string(effect) + "=on"});
    same(written(column_on_an_obstacle), {2}, on);
}

TEST_F(RanksOnGpu, WaterAndAirHaveTheSameBytes) {
    same(written(column_on_an_obstacle), {3}, {"--effect", "air=on", "--near-hull", "40mm", "--duration", "0.004s"});
}

TEST_F(RanksOnGpu, APlateThatBendsHasTheSameBytes) {
    same(fs::path(TWINWAKE_SOURCE) / "studies/elastic_gate.toml", {2}, {"--near-hull", "4mm", "--duration", "1ms"});
}

TEST_F(RanksOnGpu, ARunWithTwoSizesGoesOnWithAnotherNumberOfRanks) {
    goes_on_with_another_number_of_ranks(column_and_fine_particles(), folder_, on_gpu({}));
    for (const char* of : {"births", "spray"}) EXPECT_GT(last(folder_.path() / "ranks_1/sph", 1, of), 10) << of;
}

TEST_F(RanksOnGpu, TheSprayGateTakesTheSameBytes) {
    same(written(with(text_of("small_spray.toml"), "0.46, 0.06, 0.4]\nmax = [0.52, 0.14,",
                      "0.32, 0, 0.4]\nmax = [0.52, 0.2,")),
         {2}, {"--near-hull", "40mm", "--duration", "0.15s"});
    EXPECT_GT(taken_by_gate(folder_.path() / "ranks_1/sph"), 10);
}

TEST_F(RanksOnGpu, TheCardsAndHowTheyAreSharedAreSaid) {
    const fs::path scene = written(column_on_an_obstacle);
    const auto output = [&](int ranks, const std::string& device, int status) {
        std::vector<std::string> words = command(scene, folder_.path() / (device + std::to_string(ranks)), ranks);
        words.insert(words.end(), {"--near-hull", "60mm", "--duration", "0.005s", "--device", device, "--overwrite"});
        Program program(words, folder_.path());
        EXPECT_EQ(program.wait(), status) << program.output();
        return program.output();
    };
    const auto says = [](const std::string& text, const char* words) {
        EXPECT_NE(text.find(words), std::string::npos) << text;
    };
    says(output(2, "gpu", 0), "each of 2 ranks here has a GPU of its own, of 2");
    says(output(3, "gpu", 0), "3 ranks here share 2 GPUs");
    setenv("FAKE_CUDA", "devices=1 memory=50000", 1);
    says(output(2, "gpu", 2), "particles need");
    output(2, "auto", 0);
    EXPECT_FALSE(read_record(folder_.path() / "auto2/sph/record.h5").attributes.contains("device"));
}

}  // namespace ranks_on_gpu_test
}  // namespace tw::test
