// One run of the particles shared by several processes: the same record and the same checkpoint, byte for byte, as that
// of one.
#include <gtest/gtest.h>

#include <signal.h>
#include <sys/resource.h>

#include <algorithm>
#include <cstdlib>
#include <fstream>
#include <optional>
#include <sstream>

#include "base/atomic_file.h"
#include "program.h"
#include "ranks_run.h"
#include "record/run_record.h"
#include "sph_solver/parallel/comm.h"
#include "test_paths.h"

namespace tw::test {
namespace ranks_test {

TEST_F(Ranks, WaterThatStrikesAnObstacleHasTheSameBytes) {
    const ScratchFolder folder("ranks_tank");
    const fs::path scene = folder.path() / "scene.toml";
    write_text_atomically(scene, column_on_an_obstacle);
    same_for_any_ranks(scene, folder.path(), {2, 3, 4}, {"--near-hull", "27mm", "--duration", "0.25s"});
}

TEST_F(Ranks, AHullInAStreamHasTheSameBytes) {
    const ScratchFolder folder("ranks_hull");
    same_for_any_ranks(fs::path(TWINWAKE_SOURCE) / "tests/robustness/runs/small_planing.toml", folder.path(), {2, 3},
                       {"--duration", "0.12s"});
}

TEST_F(Ranks, WavesThatEnterWithTheStreamHaveTheSameBytes) {
    const ScratchFolder folder("ranks_waves");
    const fs::path scene = folder.path() / "scene.toml";
    // they begin when the stream has its speed, after 0.12 s
    write_text_atomically(scene, text_of("small_planing.toml") +
                                     "[wave]\nspectrum = \"jonswap\"\nsignificant_height = \"40 mm\"\npeak_period = "
                                     "\"1.2 s\"\ncomponents = 12\n");
    same_for_any_ranks(scene, folder.path(), {3}, {"--duration", "0.3s"});
}

TEST_F(Ranks, ABodyThatFallsIntoWaterHasTheSameBytes) {
    const ScratchFolder folder("ranks_body");
    // it touches the water after 0.05 s
    same_for_any_ranks(fs::path(TWINWAKE_SOURCE) / "tests/robustness/runs/small_entry.toml", folder.path(), {3},
                       {"--near-hull", "20mm", "--duration", "0.3s"});
    RunRecord fell = read_record(folder.path() / "ranks_1/sph/record.h5");
    const std::vector<double>& force = fell.table(body_table("box")).column("fz", "N/m").values;
    EXPECT_GT(*std::ranges::max_element(force), 0) << "or it met no water";
}

TEST_F(Ranks, EffectsHaveTheSameBytes) {
    const ScratchFolder folder("ranks_effects");
    const fs::path scene = folder.path() / "scene.toml";
    write_text_atomically(scene, column_on_an_obstacle);
    std::vector<std::string> on;
    for (const char* effect : {"viscosity", "no_slip", "turbulence", "surface_tension", "ventilation", "cavitation",
                               "acoustic_damping", "forcing_zones"})
        on.insert(on.end(), {"--effect", std::string(effect) + "=on"});
    on.insert(on.end(), {"--duration", "0.1s"});
    same_for_any_ranks(scene, folder.path(), {3}, on);
}

TEST_F(Ranks, WaterAndAirHaveTheSameBytes) {
    const ScratchFolder folder("ranks_air");
    const fs::path scene = folder.path() / "scene.toml";
    write_text_atomically(scene, column_on_an_obstacle);
    // of three ranks one has no water at first
    same_for_any_ranks(scene, folder.path(), {3}, {"--effect", "air=on", "--near-hull", "40mm", "--duration", "0.04s"});
}

TEST_F(Ranks, APlateThatBendsHasTheSameBytes) {
    const ScratchFolder folder("ranks_plate");
    same_for_any_ranks(fs::path(TWINWAKE_SOURCE) / "studies/elastic_gate.toml", folder.path(), {3},
                       {"--near-hull", "2mm", "--duration", "2ms"});
}

TEST_F(Ranks, AHullWithTwoSizesOfParticlesHasTheSameBytes) {
    const ScratchFolder folder("ranks_two_sizes");
    const fs::path scene = folder.path() / "scene.toml";
    std::string text = text_of("small_planing.toml");
    for (const auto& [what, by] : {std::pair{R"(ahead  = "0.4 m")", R"(ahead  = "1.3 m")"},
                                   {R"(side   = "0.5 m")", R"(side   = "0.9 m")"},
                                   {R"(below  = "0.4 m")", R"(below  = "0.6 m")"},
                                   {"spacing   = \"0.05 m\"\n", ""}})
        text = with(text, what, by);
    write_text_atomically(scene, text + "[sph]\nlevels = 2\nzone = 8\n");
    same_for_any_ranks(scene, folder.path(), {3}, {"--duration", "0.1s"});
    EXPECT_GT(last(folder.path() / "ranks_1/sph", 1, "births"), 100);
}

TEST_F(Ranks, ThreeSizesRoundABodyThatFallsHaveTheSameBytes) {
    const ScratchFolder folder("ranks_three_sizes");
    const fs::path scene = folder.path() / "scene.toml";
    std::string text = text_of("small_entry.toml");
    for (const auto& [what, by] : {std::pair{"size = [1, 0.01, 0.8]", "size = [2, 0.01, 0.96]"},
                                   {"max = [1, 0.01, 0.4]", "max = [2, 0.01, 0.48]"},
                                   {"draft    = -0.45", "draft    = -0.53"},
                                   {"position = [0.5, 0]", "position = [1, 0]"}})
        text = with(text, what, by);
    write_text_atomically(scene, text + "[sph]\nlevels = 3\nzone = 8\n");
    // in which parents come back to children that are there still
    same_for_any_ranks(scene, folder.path(), {2}, {"--duration", "0.5s"});
    const fs::path one = folder.path() / "ranks_1/sph";
    for (const int k : {1, 2}) EXPECT_GT(last(one, k, "births"), 10) << k;
    EXPECT_GT(last(one, 2, "deaths"), 10);
}

TEST_F(Ranks, ARunWithTwoSizesGoesOnWithAnotherNumberOfRanks) {
    const ScratchFolder folder("ranks_resume_sizes");
    goes_on_with_another_number_of_ranks(column_and_fine_particles(), folder);
    for (const char* of : {"births", "spray"}) EXPECT_GT(last(folder.path() / "ranks_1/sph", 1, of), 10) << of;
}

/// What the gate takes is found in the water of all ranks: a block in the air, which stands in the pencils of several.
TEST_F(Ranks, TheSprayGateTakesTheSameBytes) {
    const ScratchFolder folder("ranks_gate");
    const fs::path scene = folder.path() / "scene.toml";
    write_text_atomically(scene, with(text_of("small_spray.toml"), "0.46, 0.06, 0.4]\nmax = [0.52, 0.14,",
                                      "0.32, 0, 0.4]\nmax = [0.52, 0.2,"));
    same_for_any_ranks(scene, folder.path(), {2, 4}, {"--near-hull", "30mm", "--duration", "0.2s"});
    EXPECT_GT(taken_by_gate(folder.path() / "ranks_1/sph"), 50);
}

/// A lump across the edge of two sizes goes with the guards and parents that stand for it; saved and resumed.
TEST_F(Ranks, TheSprayGateTakesTwoSizesTheSame) {
    const ScratchFolder folder("ranks_gate_sizes");
    const std::string lump = "[[water_block]]\nmin = [0.4, 0.08, 0.32]\nmax = [0.72, 0.16, 0.36]\n[[obstacle]]";
    goes_on_with_another_number_of_ranks(with(column_and_fine_particles(), "[[obstacle]]", lump) +
                                             "gate_point = [0.42, 0, 0.25]\ngate_normal = [1, 0, 1]\ngate_link = 1.7\n",
                                         folder);
    EXPECT_GT(taken_by_gate(folder.path() / "ranks_1/sph"), 20);
}

TEST_F(Ranks, ARunGoesOnWithAnotherNumberOfRanks) {
    const ScratchFolder folder("ranks_resume");
    goes_on_with_another_number_of_ranks(column_on_an_obstacle, folder);
}

/// The processes that a process has started and that still run.
/// Parent and state of a process, as in /proc; nothing: it is not there.
std::optional<std::pair<pid_t, std::string>> process(const std::string& pid) {
    std::ifstream file("/proc/" + pid + "/stat");
    std::string stat, state;
    if (!std::getline(file, stat)) return {};
    std::istringstream after_name(stat.substr(stat.rfind(')') + 1));
    pid_t parent = 0;
    if (!(after_name >> state >> parent)) return {};
    return std::pair(parent, state);
}
/// A zombie that nobody has asked after is not.
bool is_alive(pid_t pid) {
    const auto found = process(std::to_string(pid));
    return found && found->second != "Z";
}
std::vector<pid_t> children_of(pid_t parent) {
    std::vector<pid_t> children;
    for (const auto& entry : fs::directory_iterator("/proc")) {
        const std::string name = entry.path().filename().string();
        if (name.find_first_not_of("0123456789") != std::string::npos) continue;
        if (const auto found = process(name); found && found->first == parent && found->second != "Z")
            children.push_back(std::stoi(name));
    }
    return children;
}

TEST_F(Ranks, AKilledRankEndsAllAndTheRunGoesOn) {
    const ScratchFolder folder("ranks_killed");
    const fs::path scene = folder.path() / "scene.toml";
    write_text_atomically(scene, column_on_an_obstacle);
    const fs::path out = folder.path() / "killed";
    const std::vector<std::string> coarse{"--near-hull", "27mm"};
    std::vector<std::string> words = command(scene, out, 3);
    words.insert(words.end(), coarse.begin(), coarse.end());
    Program program(words, folder.path());
    ASSERT_TRUE(wait_until([&] { return fs::exists(out / "sph/checkpoint.h5") || !program.running(); }, 60));
    ASSERT_TRUE(program.running()) << program.output();
    const std::vector<pid_t> mpirun = children_of(program.pid());
    ASSERT_EQ(mpirun.size(), 1u);
    const std::vector<pid_t> ranks = children_of(mpirun.front());
    ASSERT_EQ(ranks.size(), 3u);
    kill(ranks.back(), SIGKILL);
    ASSERT_TRUE(wait_until([&] { return !program.running(); }, 30)) << "the other ranks wait for it";
    EXPECT_NE(program.wait(), 0);
    EXPECT_TRUE(wait_until([&] { return std::ranges::none_of(ranks, is_alive); }, 10)) << "a rank is left";
    words.emplace_back("--resume");
    Program rest(words, folder.path());
    ASSERT_EQ(rest.wait(), 0) << rest.output();
    expect_same(run(scene, folder.path(), 1, coarse), out / "sph", "killed and gone on");
}

TEST_F(Ranks, AnMpirunThatDoesNothingIsNotBelieved) {
    const ScratchFolder folder("ranks_of_nobody");
    const fs::path scene = folder.path() / "scene.toml", mpirun = folder.path() / "bin/mpirun";
    write_text_atomically(scene, column_on_an_obstacle);
    fs::create_directories(mpirun.parent_path());
    write_text_atomically(mpirun, "#!/bin/sh\nexit 0\n");
    fs::permissions(mpirun, fs::perms::owner_all);
    const std::string path = getenv("PATH");
    setenv("PATH", (mpirun.parent_path().string() + ":" + path).c_str(), 1);
    Program program(command(scene, folder.path() / "out", 2), folder.path());
    const int status = program.wait();
    setenv("PATH", path.c_str(), 1);
    EXPECT_EQ(status, 3);
    EXPECT_NE(program.output().find("the run was not made"), std::string::npos) << program.output();
}

/// The words behind `env` of a run on so many ranks that take a file which may not grow for an error, as of a full
/// disk, and not for a signal.
std::vector<std::string> command_without_signal(std::vector<std::string> of_twinwake, int ranks) {
    of_twinwake.insert(of_twinwake.begin(),
                       {"OMPI_ALLOW_RUN_AS_ROOT=1", "OMPI_ALLOW_RUN_AS_ROOT_CONFIRM=1", "mpirun", "-n",
                        std::to_string(ranks), "--oversubscribe", "--bind-to", "none", "--quiet", "sh", "-c",
                        "trap '' XFSZ; exec \"$0\" \"$@\"", TWINWAKE_PROGRAM});
    return of_twinwake;
}
/// No file of the rank may grow beyond 20 kB from now on.
void fill_disk_of(pid_t rank) {
    const rlimit limit{20'000, 20'000};
    ASSERT_EQ(prlimit(rank, RLIMIT_FSIZE, &limit, nullptr), 0);
}
/// Of the process, as mpirun has told it.
int rank_of(pid_t process) {
    const std::string all = read_text(fs::path("/proc") / std::to_string(process) / "environ"),
                      name = "OMPI_COMM_WORLD_RANK=";
    const std::size_t at = all.find(name);
    return at == std::string::npos ? -1 : std::atoi(all.c_str() + at + name.size());
}

/// The first rank writes; the others have nothing on a disk, and theirs may be full.
TEST_F(Ranks, AFullDiskOfOneRankEndsAllAndTheRunGoesOn) {
    const ScratchFolder folder("ranks_full");
    const fs::path scene = folder.path() / "scene.toml";
    write_text_atomically(scene, column_on_an_obstacle);
    const fs::path out = folder.path() / "full";
    const std::vector<std::string> coarse{"--near-hull", "27mm"};
    std::vector<std::string> words = command_without_signal(command(scene, out, 1), 3);
    words.insert(words.end(), coarse.begin(), coarse.end());
    Program program(words, folder.path(), 0, "/usr/bin/env");
    ASSERT_TRUE(wait_until([&] { return fs::exists(out / "sph/checkpoint.h5") || !program.running(); }, 60));
    ASSERT_TRUE(program.running()) << program.output();
    const std::vector<pid_t> ranks = children_of(program.pid());
    ASSERT_EQ(ranks.size(), 3u);
    const auto first = std::ranges::find(ranks, 0, rank_of);
    ASSERT_NE(first, ranks.end());
    fill_disk_of(*first);
    ASSERT_TRUE(wait_until([&] { return !program.running(); }, 30)) << "the other ranks wait for it";
    EXPECT_EQ(program.wait(), 3);
    EXPECT_NE(program.output().find(".h5: cannot be written: File too large"), std::string::npos) << program.output();
    EXPECT_TRUE(std::ranges::none_of(ranks, is_alive)) << "a rank is left";
    for (const auto& entry : fs::recursive_directory_iterator(out))
        EXPECT_NE(entry.path().extension(), ".tmp") << "left behind: " << entry.path();

    words.emplace_back("--resume");
    Program rest(words, folder.path(), 0, "/usr/bin/env");
    const auto begun = [&] { return rest.output().find("3 ranks, results in") != std::string::npos; };
    ASSERT_TRUE(wait_until([&] { return begun() || !rest.running(); }, 60));
    for (const pid_t rank : children_of(rest.pid()))
        if (rank_of(rank) > 0) fill_disk_of(rank);
    ASSERT_EQ(rest.wait(), 0) << rest.output();
    expect_same(run(scene, folder.path(), 1, coarse), out / "sph", "a full disk, and gone on");
}

/// As on two nodes: ranks that reach each other by TCP alone, and have another name and folder for temporary files.
TEST_F(Ranks, OfTwoNetworkNamespacesHaveTheSameBytes) {
    const fs::path two_nodes = fs::path(TWINWAKE_SOURCE) / "tools/two_nodes.sh";
    const ScratchFolder folder("ranks_nodes");
    Program names({"1", "hostname"}, folder.path(), 0, two_nodes);
    if (names.wait() == 77) GTEST_SKIP() << names.output();
    for (const char* node : {"node1", "node2"}) EXPECT_NE(names.output().find(node), std::string::npos);
    const fs::path scene = folder.path() / "scene.toml", out = folder.path() / "nodes";
    write_text_atomically(scene, column_on_an_obstacle);
    std::vector<std::string> words = command(scene, out, 1);
    words.insert(words.begin(), {"2", TWINWAKE_PROGRAM});
    const std::vector<std::string> coarse{"--near-hull", "40mm", "--duration", "0.2s"};
    words.insert(words.end(), coarse.begin(), coarse.end());
    Program nodes(words, folder.path(), 0, two_nodes);
    ASSERT_EQ(nodes.wait(), 0) << nodes.output();
    EXPECT_EQ(read_record(out / "sph/record.h5").attributes["ranks"], "4");
    expect_same(run(scene, folder.path(), 1, coarse), out / "sph", "two nodes");
}

/// `[run] ranks` of a scene; the option goes before it.
TEST_F(Ranks, ASceneAsksForThem) {
    const ScratchFolder folder("ranks_key");
    const fs::path scene = folder.path() / "scene.toml";
    write_text_atomically(scene, with(column_on_an_obstacle, "[run]", "[run]\nranks = 2"));
    const std::vector<std::string> coarse{"--near-hull", "40mm", "--duration", "0.1s"};
    const auto ranks_of = [&](const char* name, const std::vector<std::string>& more) {
        std::vector<std::string> words = command(scene, folder.path() / name, 1);
        words.insert(words.end(), coarse.begin(), coarse.end());
        words.insert(words.end(), more.begin(), more.end());
        Program program(words, folder.path());
        EXPECT_EQ(program.wait(), 0) << program.output();
        return read_record(folder.path() / name / "sph/record.h5").attributes["ranks"];
    };
    EXPECT_EQ(ranks_of("key", {}), "2");
    EXPECT_EQ(ranks_of("more", {"--ranks", "3"}), "3");
    EXPECT_EQ(ranks_of("one", {"--ranks", "1"}), "");
    for (const char* many : {"key", "more"}) expect_same(folder.path() / "one/sph", folder.path() / many / "sph", many);
}

/// Each of the runs of a command is made by as many processes, and the numbers are those of one.
TEST_F(Ranks, TwinsHaveThemToo) {
    const ScratchFolder folder("ranks_twins");
    const fs::path scene = folder.path() / "scene.toml";
    write_text_atomically(scene, column_on_an_obstacle);
    const auto made = [&](const std::string& name, const std::vector<std::string>& more) {
        std::vector<std::string> words{
            "run", scene.string(), "--method", "sph",        "--out", (folder.path() / name).string(), "--threads",
            "1",   "--near-hull",  "24mm",     "--duration", "0.15s"};
        words.insert(words.end(), more.begin(), more.end());
        Program program(words, folder.path());
        EXPECT_EQ(program.wait(), 0) << program.output();
        return program.output();
    };
    made("one", {});
    const std::string said = made("two", {"--ranks", "2"});
    EXPECT_NE(said.find("discretisation error"), std::string::npos) << said;
    std::vector<fs::path> runs{"sph"};
    for (const auto& twin : fs::directory_iterator(folder.path() / "one/twins"))
        runs.push_back("twins" / twin.path().filename() / "sph");
    EXPECT_GE(runs.size(), 3u);
    for (const fs::path& of : runs) {
        EXPECT_EQ(read_record(folder.path() / "two" / of / "record.h5").attributes["ranks"], "2") << of;
        expect_same(folder.path() / "one" / of, folder.path() / "two" / of, of.string());
    }
}

/// What `check` says of the ranks; what it has refused, `run` does not begin.
TEST_F(Ranks, CheckSaysWhatEachTakes) {
    const ScratchFolder folder("ranks_check");
    const fs::path scene = folder.path() / "scene.toml", facts = folder.path() / "facts.json";
    write_text_atomically(scene, with(column_on_an_obstacle, "[run]", "[run]\nranks = 2\nthreads = 1"));
    const auto check = [&](const std::vector<std::string>& more, int status) {
        std::vector<std::string> words{"check", scene.string(), "--json", facts.string()};
        words.insert(words.end(), more.begin(), more.end());
        Program program(words, folder.path());
        EXPECT_EQ(program.wait(), status) << program.output();
        return program.output();
    };
    const auto fact = [&](const std::string& name) {
        const std::string text = read_text(facts), key = "\"" + name + "\": ";
        const std::size_t of_ranks = text.find("\"ranks\": {"), at = text.find(key, of_ranks);
        EXPECT_NE(at, std::string::npos) << name;
        return at == std::string::npos ? 0 : std::atof(text.c_str() + at + key.size());
    };
    EXPECT_NE(check({}, 0).find("ranks: 2; the largest has "), std::string::npos);
    const double two = fact("particles"), two_bytes = fact("bytes"), two_seconds = fact("seconds");
    EXPECT_NEAR(two, 0.5 * 15 * 12 * 15, 0.05 * two);  // of 2700
    EXPECT_GT(fact("copies"), 0.05 * two);
    check({"--ranks", "4"}, 0);
    EXPECT_NEAR(fact("particles"), 0.5 * two, 0.1 * two);
    EXPECT_LT(fact("bytes"), two_bytes);
    EXPECT_GT(fact("bytes_at_start"), 2700 * 50);  // places and velocities of all
    EXPECT_LT(fact("seconds"), 0.85 * two_seconds);  // each rank has a start of its own
    check({"--ranks", "1"}, 0);
    EXPECT_EQ(fact("number"), 1);

    const auto refused = [&](const std::vector<std::string>& more, const std::string& words) {
        const std::string said = check(more, 2);
        EXPECT_NE(said.find(words), std::string::npos) << said;
    };
    refused({"--ranks", "500"}, "--ranks 500: the water stands in ");
    write_text_atomically(scene, with(column_on_an_obstacle, "[run]", "[run]\nranks = 500"));
    refused({}, "scene.toml:23:9: [run] ranks = 500: the water stands in ");
}

TEST(RanksRefused, WithTheReason) {
    const ScratchFolder folder("ranks_refused");
    const fs::path scene = folder.path() / "scene.toml";
    const auto refused = [&](const std::string& text, std::vector<std::string> words) {
        write_text_atomically(scene, text);
        words.insert(words.begin(), {"run", scene.string(), "--out", (folder.path() / "out").string()});
        Program program(words, folder.path());
        EXPECT_EQ(program.wait(), 2) << program.output();
        EXPECT_FALSE(fs::exists(folder.path() / "out" / "sph" / "record.h5"));
        return program.output();
    };
    const auto has = [](const std::string& text, const char* words) {
        EXPECT_NE(text.find(words), std::string::npos) << text;
    };
    const std::vector<std::string> two{"--ranks", "2", "--method", "sph", "--no-twins"};
    has(refused(column_on_an_obstacle, {"--ranks", "0", "--method", "sph", "--no-twins"}), "--ranks");
    has(refused(column_on_an_obstacle, {"--ranks", "2", "--method", "fvm"}), "--ranks 2: 2 ranks share a run of the");
    const std::string with_key = with(column_on_an_obstacle, "[run]", "[run]\nranks = 2");
    const std::string place = "scene.toml:23:9: [run] ranks = 2: ";
    has(refused(with_key, {"--method", "fvm"}), (place + "2 ranks share a run of the").c_str());
    has(refused(with(column_on_an_obstacle, "[run]", "[run]\nranks = 0"), {}), "ranks = 0");
    if (!Comm::built_with_mpi()) {
        has(refused(column_on_an_obstacle, two), "built without MPI");
        return;
    }
    setenv("LSAN_OPTIONS", "exitcode=0", 1);
    has(refused(column_on_an_obstacle, {"--ranks", "5", "--method", "sph", "--no-twins", "--near-hull", "80mm"}),
        "take fewer");
}

}  // namespace ranks_test
}  // namespace tw::test
