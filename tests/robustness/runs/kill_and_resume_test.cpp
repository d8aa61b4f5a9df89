#include <gtest/gtest.h>

#include <cmath>

#include "base/atomic_file.h"
#include "first_difference.h"
#include "program.h"
#include "record/run_record.h"
#include "test_paths.h"

namespace tw::test {
namespace kill_and_resume_test {

void kill_and_resume(const std::string& name, const std::filesystem::path& scene, const std::filesystem::path& folder) {
    const auto command = [&](const char* out) {
        return std::vector<std::string>{"run", scene.string(), "--no-twins",           "--method",
                                        "sph", "--out",        (folder / out).string()};
    };
    Program whole(command("whole"), folder);
    ASSERT_EQ(whole.wait(), 0) << whole.output();

    const auto checkpoint = folder / "killed" / "sph" / "checkpoint.h5";
    for (int kills = 0; kills < 2; ++kills) {  // once in the first part, once in the resumed one
        auto arguments = command("killed");
        if (kills > 0) arguments.push_back("--resume");
        Program part(arguments, folder);
        const auto before = std::filesystem::exists(checkpoint) ? std::filesystem::last_write_time(checkpoint)
                                                                : std::filesystem::file_time_type::min();
        ASSERT_TRUE(wait_until(
            [&] {
                return !part.running() ||
                       (std::filesystem::exists(checkpoint) && std::filesystem::last_write_time(checkpoint) != before);
            },
            120));
        ASSERT_TRUE(part.running()) << name << ": ended before it could be killed\n" << part.output();
        part.kill_hard();
        ASSERT_EQ(part.wait(), -9);
    }
    auto arguments = command("killed");
    arguments.push_back("--resume");
    Program rest(arguments, folder);
    ASSERT_EQ(rest.wait(), 0) << rest.output();

    const RunRecord a = read_record(folder / "whole" / "sph" / "record.h5"),
                    b = read_record(folder / "killed" / "sph" / "record.h5");
    EXPECT_EQ(b.state, "finished");
    EXPECT_EQ(first_difference(a, b), "");
}

/// A scene of this folder that ends at another time.
std::string with_duration(const char* file, const std::string& old, const std::string& seconds) {
    std::string text = read_text(std::filesystem::path(TWINWAKE_SOURCE) / "tests/robustness/runs" / file);
    const std::string key = "duration   = ";
    const std::size_t at = text.find(key + old);
    EXPECT_NE(at, std::string::npos) << file;
    return at == std::string::npos ? text : text.replace(at + key.size(), old.size(), seconds);
}
std::string small_planing(const std::string& duration) {
    return with_duration("small_planing.toml", "\"0.4 s\"", "\"" + duration + "\"");
}

TEST(KillAndResume, CollapsingColumnGoesOnToTheSameBits) {
    const ScratchFolder folder("kill_tank");
    kill_and_resume("tank", write_small_scene(folder.path() / "scene.toml", 0.3), folder.path());
}

TEST(KillAndResume, HullInAStreamGoesOnToTheSameBits) {
    const ScratchFolder folder("kill_stream");
    const auto scene = folder.path() / "scene.toml";
    write_text_atomically(scene, small_planing("0.2 s"));
    kill_and_resume("stream", scene, folder.path());
}

/// Whose zone goes with it. A free hull among particles of one size: Crash.OfAHullThatIsFreeInAStreamLosesNothing.
TEST(KillAndResume, AHullFreeAmongTwoSizesGoesOnToTheSameBits) {
    const ScratchFolder folder("kill_free");
    const auto scene = folder.path() / "scene.toml";
    std::string text = small_planing("0.18 s");
    const std::string half = "half     = true\n";
    text.insert(text.find(half) + half.size(),
                "free = [\"heave\", \"pitch\"]\nmass = 40\nlcg = 0.7\nvcg = 0.15\nrelease = 0.05\n");
    const std::string ahead = "ahead  = \"0.4 m\"";
    text.replace(text.find(ahead), ahead.size(), "ahead  = \"1.6 m\"");
    write_text_atomically(scene, text + "\n[sph]\nlevels = 2\nzone = 8\n");
    kill_and_resume("free", scene, folder.path());
    const RunRecord whole = read_record(folder.path() / "whole" / "sph" / "record.h5");
    const std::vector<double>& trim = whole.tables.at("hull_motion").find("trim")->values;
    EXPECT_GT(std::abs(trim.back() - trim.front()), 0.01) << "or it was held";
    EXPECT_TRUE(whole.tables.contains("level_1"));
}

// Three sizes, of which the finest stands round a part of the hull only: the hull's load is that of all of them.
TEST(KillAndResume, AFinerSprayRootGoesOnToTheSameBits) {
    const ScratchFolder folder("kill_root");
    const auto scene = folder.path() / "scene.toml";
    std::string text = small_planing("0.18 s");
    const std::string ahead = "ahead  = \"0.4 m\"";
    text.replace(text.find(ahead), ahead.size(), "ahead  = \"1.2 m\"");
    write_text_atomically(scene, text +
                                     "\n[sph]\nlevels = 2\nzone = 8\n"
                                     "[[refine]]\naround = \"spray_root\"\nspacing = 0.025\n");
    kill_and_resume("root", scene, folder.path());
    RunRecord run = read_record(folder.path() / "whole" / "sph" / "record.h5");
    EXPECT_EQ(run.numbers.at("levels"), 3);
    Table& forces = run.table("forces");
    double by_pairs = 0, by_surface = 0;
    for (std::size_t i = 0; i < forces.time.size(); ++i) {
        const double surface = forces.column("fz_surface", "N").values[i];
        if (forces.time[i] < 0.1 || std::isnan(surface)) continue;
        by_pairs += forces.column("fz", "N").values[i];
        by_surface += surface;
    }
    EXPECT_GT(by_pairs, 0);
    EXPECT_NEAR(by_surface / by_pairs, 1, 0.05);
}

// A run that has ended because its loads had settled is resumed as if it never had.
TEST(KillAndResume, ARunThatHasSettledGoesOnToTheSameBits) {
    const ScratchFolder folder("settled");
    const auto scene = folder.path() / "scene.toml";
    std::string text = small_planing("2 s");
    const auto put = [&](const std::string& old, const std::string& now) {
        for (std::size_t at = text.find(old); at != std::string::npos; at = text.find(old, at + now.size()))
            text.replace(at, old.size(), now);
    };
    put("\"0.05 m\"", "\"0.0625 m\"");
    put("\"2 m\"", "\"1.25 m\"");
    put("interval = \"0.05 s\"", "interval = \"0.02 s\"\nmean_from = \"0.9 s\"");
    put("\"2 s\"", "\"2 s\"\nstop = \"settled\"");
    put("checkpoint = \"0.04 s\"", "checkpoint = \"0.5 s\"");
    write_text_atomically(scene, text);
    const auto run = [&](const char* out, const std::vector<std::string>& more) {
        std::vector<std::string> words{"run", scene.string(), "--no-twins", "--out", (folder.path() / out).string()};
        words.insert(words.end(), more.begin(), more.end());
        Program program(words, folder.path());
        EXPECT_EQ(program.wait(), 0) << program.output();
        return program.output();
    };
    const std::string said = run("ended", {});
    EXPECT_NE(said.find("its loads have settled at "), std::string::npos) << said;
    RunRecord ended = read_record(folder.path() / "ended/sph/record.h5");
    EXPECT_EQ(ended.state, "finished");
    EXPECT_EQ(ended.attributes["ended_by"], "settled");
    EXPECT_EQ(ended.numbers["duration_bound"], 2);
    const double end = ended.tables.at("samples").time.back();
    EXPECT_EQ(ended.numbers["duration"], end);
    ASSERT_LT(end, 1.9);

    EXPECT_NE(run("ended", {"--resume"}).find("finished before"), std::string::npos) << "there is nothing left to do";
    const std::vector<std::string> longer{"--duration", std::to_string(end + 0.1)};
    run("whole", longer);
    run("ended", {"--resume", longer[0], longer[1]});
    const RunRecord gone_on = read_record(folder.path() / "ended/sph/record.h5");
    EXPECT_GT(gone_on.tables.at("samples").time.back(), end + 0.09);
    EXPECT_FALSE(gone_on.attributes.contains("ended_by"));
    EXPECT_EQ(first_difference(read_record(folder.path() / "whole/sph/record.h5"), gone_on), "");
}

TEST(KillAndResume, ABodyThatFallsIntoWaterGoesOnToTheSameBits) {
    const ScratchFolder folder("kill_body");
    const auto scene = folder.path() / "scene.toml";
    // it touches the water after 0.05 s
    write_text_atomically(scene, with_duration("small_entry.toml", "0.8", "0.3"));
    kill_and_resume("entry", scene, folder.path());
}

TEST(KillAndResume, DamagedCheckpointIsRefusedByName) {
    const ScratchFolder folder("damaged");
    const auto scene = write_small_scene(folder.path() / "scene.toml", 2.0);
    std::vector<std::string> command{
        "run", scene.string(), "--no-twins", "--method", "sph", "--out", (folder.path() / "run").string()};
    const auto checkpoint = folder.path() / "run" / "sph" / "checkpoint.h5";
    {
        Program run(command, folder.path());
        ASSERT_TRUE(wait_until([&] { return std::filesystem::exists(checkpoint); }, 60)) << run.output();
        run.kill_hard();
        ASSERT_EQ(run.wait(), -9);
    }
    std::filesystem::resize_file(checkpoint, std::filesystem::file_size(checkpoint) / 2);
    command.push_back("--resume");
    Program resumed(command, folder.path());
    EXPECT_EQ(resumed.wait(), 2);
    EXPECT_NE(resumed.output().find("checkpoint.h5"), std::string::npos) << resumed.output();
}

}  // namespace kill_and_resume_test
}  // namespace tw::test
