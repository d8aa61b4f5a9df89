// `twinwake run` of a free body in a wave: the same run without the body, and the response over the wave there.
#include <cmath>
#include <nlohmann/json.hpp>

#include "program.h"

namespace tw::test {
namespace wave_twin_test {

bool has(const std::string& text, const std::string& part) { return text.find(part) != std::string::npos; }

/// Three waves of 0.8 s with four particles in their height, which have not come to rest: as many as it takes.
std::string box_in_waves(const std::string& wave = "") {
    return "[tank]\nmin = [-2, 0, -0.24]\nmax = [1.6, 0.02, 0.14]\n[domain]\ndimensions = 2\n[wave]\nheight = 0.08\n"
           "length = 1\n" +
           wave +
           "[[body]]\nname = \"box\"\nshape = \"box\"\nlength = 0.2\nbeam = 1\nheight = 0.12\nposition = [0.05, 0]\n"
           "draft = 0.06\ndensity = 500\nlocked = [\"surge\", \"pitch\"]\n[motion]\nkind = \"none\"\n"
           "[resolution]\nnear_hull = 0.02\n[run]\nduration = 3.3\nmethods = [\"sph\"]\n[sampling]\nmean_from = 0.8\n";
}

nlohmann::json quantity_in(const fs::path& json, const std::string& name) {
    const auto facts = nlohmann::json::parse(content(json));
    for (const auto& q : facts["quantities"])
        if (q["name"] == name) return q;
    return {};
}
double value_of(const nlohmann::json& quantity) { return quantity["values"][0]; }

TEST_F(Command, ABodyInAWaveHasItsResponseOverTheWaveOfTheRunWithoutIt) {
    write("box.toml", box_in_waves());
    const Outcome o = twinwake({"run", "box.toml", "--no-twins", "--out", "out"});
    ASSERT_EQ(o.status, 0) << o.err;
    EXPECT_TRUE(fs::exists(folder_ / "out/without_bodies/sph/record.h5")) << o.out;
    const fs::path report = folder_ / "out/report.json";
    const nlohmann::json over_wave = quantity_in(report, "heave_over_wave:box"),
                         asked = quantity_in(report, "heave_response:box"),
                         wave = quantity_in(report, "wave_without:box");
    ASSERT_FALSE(over_wave.is_null() || asked.is_null() || wave.is_null()) << content(report);
    // near to each other: over each period's own wave, and over the mean of all
    EXPECT_NEAR(value_of(over_wave), value_of(asked) * 0.08 / value_of(wave), 0.1 * value_of(asked));
    EXPECT_GT(value_of(wave), 0.03);
    EXPECT_FALSE(has(asked["definition"], "no run without the body"));

    // of another size it does not count, and the report says why
    ASSERT_EQ(twinwake({"run", "box.toml", "--no-twins", "--near-hull", "18 mm", "--out", "finer", "--duration",
                        "0.02 s", "-q"})
                  .status,
              0);
    fs::copy_file(folder_ / "finer/without_bodies/sph/record.h5", folder_ / "out/without_bodies/sph/record.h5",
                  fs::copy_options::overwrite_existing);
    ASSERT_EQ(twinwake({"compare", "out", "--out", "again", "-q"}).status, 0);
    const fs::path again = folder_ / "again/report.json";
    EXPECT_TRUE(quantity_in(again, "heave_over_wave:box").is_null());
    EXPECT_TRUE(has(quantity_in(again, "heave_response:box")["definition"],
                    "no run without the body counts (SPH: it has near_hull = 0.018 m and the run with bodies 0.02 m)"))
        << quantity_in(again, "heave_response:box");
}

TEST_F(Command, ASceneMaySayThatABodyInAWaveIsNotRunWithoutIt) {
    write("box.toml", box_in_waves("empty_twin = \"off\"\n"));
    ASSERT_EQ(twinwake({"run", "box.toml", "--no-twins", "--duration", "0.02 s", "--out", "out", "-q"}).status, 0);
    EXPECT_FALSE(fs::exists(folder_ / "out/without_bodies"));
    write("empty.toml", with(box_in_waves("empty_twin = \"on\"\n"), "[\"surge\", \"pitch\"]",
                             "[\"surge\", \"pitch\"]\n[[probe]]\nname = \"without_box\"\nheight = [0.4, 0]"));
    const Outcome taken = twinwake({"run", "empty.toml", "--no-twins", "--out", "b", "-q"});
    EXPECT_EQ(taken.status, 2);
    EXPECT_TRUE(has(taken.err, "a height gauge is named without_box")) << taken.err;
}

}  // namespace wave_twin_test
}  // namespace tw::test
