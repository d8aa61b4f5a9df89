#include "ranks_run.h"

#include <bit>
#include <cstdint>
#include <numeric>
#include <utility>

#include "base/atomic_file.h"
#include "first_difference.h"
#include "record/run_record.h"
#include "record/spray_table.h"
#include "test_paths.h"

namespace tw::test {
namespace ranks_test {

std::vector<std::string> command(const fs::path& scene, const fs::path& out, int ranks) {
    std::vector<std::string> words{"run",   scene.string(), "--no-twins", "--method", "sph",
                                   "--out", out.string(),   "--threads",  "1"};
    if (ranks > 1) words.insert(words.end(), {"--ranks", std::to_string(ranks)});
    return words;
}
fs::path run(const fs::path& scene, const fs::path& folder, int ranks, const std::vector<std::string>& more) {
    const fs::path out = folder / ("ranks_" + std::to_string(ranks));
    std::vector<std::string> words = command(scene, out, ranks);
    words.insert(words.end(), more.begin(), more.end());
    Program program(words, folder);
    EXPECT_EQ(program.wait(), 0) << program.output();
    return out / "sph";
}
void expect_same(const fs::path& one, const fs::path& other, const std::string& what) {
    const RunRecord a = read_record(one / "record.h5"), b = read_record(other / "record.h5");
    EXPECT_EQ(a.state, "finished");
    EXPECT_EQ(first_difference(a, b), "") << what;
    ASSERT_EQ(a.validity_checks.size(), b.validity_checks.size());
    for (std::size_t k = 0; k < a.validity_checks.size(); ++k) {
        EXPECT_EQ(a.validity_checks[k].value, b.validity_checks[k].value) << what << ": " << a.validity_checks[k].name;
        for (int axis = 0; axis < 3; ++axis)  // which may be unknown
            EXPECT_EQ(std::bit_cast<std::uint64_t>(a.validity_checks[k].place[axis]),
                      std::bit_cast<std::uint64_t>(b.validity_checks[k].place[axis]))
                << what << ": " << a.validity_checks[k].name;
    }
    EXPECT_EQ(a.hull_pressure, b.hull_pressure) << what;
    EXPECT_TRUE(read_text(one / "checkpoint.h5") == read_text(other / "checkpoint.h5"))
        << what << ": the checkpoints differ";
}
void same_for_any_ranks(const fs::path& scene, const fs::path& folder, const std::vector<int>& numbers,
                        const std::vector<std::string>& more) {
    const fs::path one = run(scene, folder, 1, more);
    for (const int ranks : numbers) expect_same(one, run(scene, folder, ranks, more), std::to_string(ranks) + " ranks");
}

const char* const column_on_an_obstacle = R"(
[tank]
size = [0.8, 0.24, 0.4]
[motion]
kind = "none"
[[water_block]]
min = [0, 0, 0]
max = [0.3, 0.24, 0.3]
[[obstacle]]
name = "box"
min = [0.46, 0.08, 0]
max = [0.54, 0.16, 0.08]
[resolution]
near_hull = 0.02
[sampling]
interval = 0.05
snapshots = 0.1
[[probe]]
pressure = [0.46, 0.12, 0.02]
[[probe]]
height = [0.2, 0.12]
[run]
methods = ["sph"]
checkpoint = 0.1
duration = 0.3
)";

std::string with(std::string text, const std::string& what, const std::string& by) {
    const std::size_t at = text.find(what);
    EXPECT_NE(at, std::string::npos) << what;
    return at == std::string::npos ? text : text.replace(at, what.size(), by);
}
std::string text_of(const char* file) { return read_text(fs::path(TWINWAKE_SOURCE) / "tests/robustness/runs" / file); }
double last(const fs::path& run, int k, const char* column) {
    RunRecord record = read_record(run / "record.h5");
    const std::vector<double>& values =
        record.table(level_table(static_cast<std::size_t>(k))).column(column, "-").values;
    return values.empty() ? 0 : values.back();
}

double taken_by_gate(const fs::path& run) {
    RunRecord record = read_record(run / "record.h5");
    const std::vector<double>& lumps = record.table(spray_table).column("particles", "-").values;
    return std::accumulate(lumps.begin(), lumps.end(), 0.0);
}

std::string column_and_fine_particles() {
    std::string text = column_on_an_obstacle;
    for (const auto& [what, by] : {std::pair{"[0.8, 0.24, 0.4]", "[1.28, 0.24, 0.4]"},
                                   {"[0.3, 0.24, 0.3]", "[0.4, 0.24, 0.32]"},
                                   {"[0.46, 0.08, 0]", "[0.66, 0.08, 0]"},
                                   {"[0.54, 0.16, 0.08]", "[0.74, 0.16, 0.08]"},
                                   {"[0.46, 0.12, 0.02]", "[0.66, 0.12, 0.02]"}})
        text = with(text, what, by);
    return text + "[sph]\nlevels = 2\nzone = 8\n";
}

void goes_on_with_another_number_of_ranks(const std::string& text, const ScratchFolder& folder,
                                          const std::vector<std::string>& more) {
    const fs::path scene = folder.path() / "scene.toml";
    write_text_atomically(scene, text);
    const auto to = [&](const std::string& end) {
        std::vector<std::string> words{"--duration", end};
        words.insert(words.end(), more.begin(), more.end());
        return words;
    };
    const fs::path whole = run(scene, folder.path(), 1, more), parts = run(scene, folder.path(), 4, to("0.1s"));
    for (const auto& [ranks, end] : {std::pair{1, "0.2s"}, {3, "0.3s"}}) {
        std::vector<std::string> words = command(scene, parts.parent_path(), ranks), rest = to(end);
        words.emplace_back("--resume");
        words.insert(words.end(), rest.begin(), rest.end());
        Program program(words, folder.path());
        ASSERT_EQ(program.wait(), 0) << program.output();
    }
    expect_same(whole, parts, "4, then 1, then 3 ranks");
}

}  // namespace ranks_test
}  // namespace tw::test
