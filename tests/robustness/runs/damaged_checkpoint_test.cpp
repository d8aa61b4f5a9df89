// A checkpoint with a byte changed or an end missing: the run refuses it by name, or goes on to the same bits.
#include <gtest/gtest.h>

#include <random>

#include "base/atomic_file.h"
#include "first_difference.h"
#include "program.h"

namespace tw::test {
namespace damaged_checkpoint_test {

namespace fs = std::filesystem;

class DamagedCheckpoint : public testing::Test {
protected:
    ScratchFolder scratch{"damaged_checkpoint"};
    fs::path scene = write_small_scene(scratch.path() / "scene.toml", 0.2);
    std::string checkpoint;  ///< bytes of a whole one, of a run that has come half way
    RunRecord undisturbed;   ///< of the run resumed from there

    std::vector<std::string> command(const fs::path& out, const char* duration) const {
        return {"run",         scene.string(), "--no-twins", "--method", "sph",   "--threads", "1",
                "--near-hull", "50mm",         "--duration", duration,   "--out", out.string()};
    }
    /// Goes on in a fresh copy of the half run whose checkpoint holds `bytes`: exit status and output.
    std::pair<int, std::string> go_on_with(const std::string& bytes) {
        fs::remove_all(scratch.path() / "again");
        fs::copy(scratch.path() / "half", scratch.path() / "again", fs::copy_options::recursive);
        write_text_atomically(scratch.path() / "again/sph/checkpoint.h5", bytes);
        auto arguments = command(scratch.path() / "again", "0.2s");
        arguments.push_back("--resume");
        Program run(arguments, scratch.path());
        const int status = run.wait();
        return {status, run.output()};
    }
    RunRecord record() const { return read_record(scratch.path() / "again/sph/record.h5"); }

    void SetUp() override {
        Program half(command(scratch.path() / "half", "0.1s"), scratch.path());
        ASSERT_EQ(half.wait(), 0) << half.output();
        checkpoint = read_text(scratch.path() / "half/sph/checkpoint.h5");
        const auto [status, output] = go_on_with(checkpoint);
        ASSERT_EQ(status, 0) << output;
        undisturbed = record();
        ASSERT_GT(undisturbed.tables.at("forces").time.back(), 0.15);
    }
    /// The refusal, which names the file, or nothing where the run went on to the same bits. `what` was done to the
    /// file.
    std::string refusal(const std::string& bytes, const std::string& what) {
        const auto [status, output] = go_on_with(bytes);
        if (status == 2) {
            EXPECT_NE(output.find("checkpoint.h5: "), std::string::npos) << what << ": " << output;
            return output;
        }
        EXPECT_EQ(status, 0) << what << ": " << output;
        EXPECT_EQ(first_difference(undisturbed, record()), "") << what;
        return {};
    }
};

TEST_F(DamagedCheckpoint, AFlippedByteNeverGivesOtherNumbers) {
    std::mt19937 random(1);
    int refused = 0, arrays_named = 0;
    constexpr int tries = 100;
    for (int i = 0; i < tries; ++i) {
        std::string bad = checkpoint;
        const std::size_t at = random() % bad.size();
        bad[at] = static_cast<char>(bad[at] ^ (1 + random() % 255));
        const std::string message = refusal(bad, "byte " + std::to_string(at) + " of " + std::to_string(bad.size()));
        refused += !message.empty();
        arrays_named += message.find(": checksum does not match: the file is damaged") != std::string::npos;
    }
    EXPECT_GT(refused, tries / 2) << "too few to have hit anything that counts";
    EXPECT_GT(arrays_named, tries / 10) << "\"dataset x: checksum does not match\"";
}

TEST_F(DamagedCheckpoint, ACutOffEndIsRefused) {
    std::mt19937 random(2);
    for (int i = 0; i < 12; ++i) {
        const std::size_t keep = random() % checkpoint.size();
        EXPECT_NE(refusal(checkpoint.substr(0, keep), "cut off at " + std::to_string(keep)), "");
    }
}

}  // namespace damaged_checkpoint_test
}  // namespace tw::test
