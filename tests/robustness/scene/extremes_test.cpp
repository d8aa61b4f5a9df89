// `twinwake check` at the ends of what every key may say: each number of the table in an otherwise small sound scene.
#include <fcntl.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <cctype>
#include <cstdio>
#include <ctime>
#include <fstream>
#include <set>
#include <stdexcept>

#include "base/errors.h"
#include "meshes/generate.h"
#include "scene/cost/node.h"
#include "scene/keys/keys.h"
#include "test_paths.h"
#include "tests/unit/scene/every_key.h"

namespace tw::test {
namespace extremes_test {

using Kind = SceneKey::Kind;

constexpr double longest_check = 15;  ///< [s] of processor time, on a machine that others share

/// What stands behind `key =` in a section of a scene's text: place and length in it; npos where the key is not written.
struct Place {
    std::size_t at = std::string::npos, length = 0;
};
Place value_of(const std::string& text, const std::string& section, const std::string& key) {
    std::string in;
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        const std::string line = text.substr(at, end - at);
        if (line.starts_with("[")) {
            const std::size_t from = line.find_first_not_of('[');
            in = line.substr(from, line.find(']') - from);
        } else if (const std::size_t equals = line.find('='); equals != std::string::npos && in == section) {
            if (line.substr(0, line.find_first_of(" =")) == key) return {at + equals + 1, end - (at + equals + 1)};
        }
        at = end + 1;
    }
    return {};
}

/// Scenes in which the key is written, by the pair of the table of changes.
std::string scene_with(const SceneKey& key, const Change& change) {
    for (const std::string& text : {change.before, change.after})
        if (value_of(text, key.section, key.name).at != std::string::npos) return text;
    return {};
}

/// What the key is set to: a number at each extreme; of a list each member in turn, and all of them.
std::vector<std::string> extremes(const SceneKey& key, const std::string& now) {
    const std::size_t open = now.find('[');
    std::vector<std::string> items;
    for (std::size_t from = open + 1; open != std::string::npos && from < now.size();) {
        const std::size_t end = now.find_first_of(",]", from);
        items.push_back(now.substr(from, end - from));
        from = end + 1;
    }
    std::set<double> values{0, smallest_number, largest_number};
    if (items.empty()) values.insert({1e-300, 1e-6, 1e9, 1e300});
    if (key.range.min < 0) values.insert({-smallest_number, -largest_number});
    for (const double end : {key.range.min, key.range.max})
        if (std::isfinite(end)) values.insert(end);
    std::vector<std::string> written;
    for (const double value : values) {
        const std::string number = fmt::format("{:.17g}", value);
        if (items.empty()) written.push_back(number);
        for (std::size_t k = 0; k < items.size(); ++k) {
            std::vector<std::string> changed = items;
            changed[k] = number;
            written.push_back(fmt::format("[{}]", fmt::join(changed, ", ")));
        }
        if (!items.empty())
            written.push_back(fmt::format("[{}]", fmt::join(std::vector<std::string>(items.size(), number), ", ")));
    }
    return written;
}

struct Check {
    std::string what, text;  ///< the key with its value, the whole scene
};

/// What `check` says of a scene: its text, or the message of its refusal.
struct Said {
    bool refused = false;
    std::string text;
};

/// Without starting the program. Where this crashes or hangs, the last scene of the test's folder is at fault.
Said read_and_predicted(const std::filesystem::path& file) {
    try {
        const Scene scene = read_scene(file);
        const Prediction prediction = predict(scene);
        refuse_oversize(scene, prediction);
        return {false, to_text(scene, prediction)};
    } catch (const InputError& e) { return {true, e.what()}; }
}

/// Words of the output that are no finite numbers.
std::string not_finite(const std::string& text) {
    std::string word;
    for (const char c : text + " ") {
        if (std::isalnum(static_cast<unsigned char>(c)) || c == '_') {
            word += c;
            continue;
        }
        if (word == "inf" || word == "nan") return word;
        word.clear();
    }
    return {};
}

/// Whether a message begins with the place of a key: file:line:column: [section] key = ...
bool names_its_place(const std::string& message, const std::filesystem::path& file) {
    const std::string name = file.string() + ":";
    if (!message.starts_with(name)) return false;
    int line = 0, column = 0, read = 0;
    const int found = std::sscanf(message.c_str() + name.size(), "%d:%d: [%n", &line, &column, &read);
    return found == 2 && read > 0 && message.size() > name.size() + static_cast<std::size_t>(read);
}

void expect_finite_or_refused(const Said& said, const Check& check, const std::filesystem::path& file) {
    EXPECT_EQ(not_finite(said.text), "") << check.what << "\n" << said.text;
    EXPECT_TRUE(!said.refused || names_its_place(said.text, file)) << check.what << "\n" << said.text;
}

std::filesystem::path file_of(const Check& check) {
    static int number = 0;
    const std::filesystem::path file = scratch() / fmt::format("extreme_{}.toml", ++number);
    std::ofstream(file) << check.text;
    return file;
}

void run(const std::vector<Check>& checks) {
    for (const Check& check : checks) {
        const std::filesystem::path file = file_of(check);
        const std::clock_t begin = std::clock();
        expect_finite_or_refused(read_and_predicted(file), check, file);
        EXPECT_LT(double(std::clock() - begin) / CLOCKS_PER_SEC, longest_check) << check.what;
    }
}

/// The program itself: with it come the costs of coarser members, and what the command line adds.
void run_program(const std::vector<Check>& checks) {
    for (const Check& check : checks) {
        const std::filesystem::path file = file_of(check), out = file.string() + ".out";
        const pid_t child = fork();
        if (child == 0) {
            const int to = open(out.c_str(), O_WRONLY | O_CREAT | O_TRUNC, 0600);
            dup2(to, STDOUT_FILENO);
            dup2(to, STDERR_FILENO);
            const rlimit limit{rlim_t(longest_check), rlim_t(longest_check) + 1};
            setrlimit(RLIMIT_CPU, &limit);
            execl(TWINWAKE_PROGRAM, TWINWAKE_PROGRAM, "check", file.c_str(), nullptr);
            _exit(127);
        }
        int status = 0;
        waitpid(child, &status, 0);
        const std::string text = read_text(out);
        const int ended = WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status);
        EXPECT_TRUE(ended == 0 || ended == 2) << check.what << " ended with " << ended << "\n" << text;
        expect_finite_or_refused({ended == 2, text}, check, file);
    }
}

/// A scene for each extreme of each number of the table.
std::vector<Check> checks_of_all_keys() {
    const auto all = changes();
    std::vector<Check> checks;
    for (const SceneKey& key : scene_keys()) {
        const bool numbers = key.kind == Kind::number || key.kind == Kind::whole || key.kind == Kind::pair ||
                             key.kind == Kind::place2 || key.kind == Kind::place3 || key.kind == Kind::list;
        if (!numbers) continue;
        const std::string name = key.section + "." + key.name, scene = scene_with(key, all.at(name));
        if (scene.empty()) throw std::logic_error(name + " is not written in its scene");
        const Place place = value_of(scene, key.section, key.name);
        for (const std::string& value : extremes(key, scene.substr(place.at, place.length))) {
            std::string changed = scene;
            checks.push_back({name + " = " + value, changed.replace(place.at, place.length, " " + value)});
        }
    }
    return checks;
}

TEST(Extremes, EachNumberOfTheTableIsRefusedOrEndsFinite) {
    const std::vector<Check> checks = checks_of_all_keys();
    EXPECT_GT(checks.size(), 1000u);
    run(checks);
}

TEST(Extremes, TheProgramSaysTheSameOfEveryTwentieth) {
    std::vector<Check> some;
    const std::vector<Check> checks = checks_of_all_keys();
    for (std::size_t k = 0; k < checks.size(); k += 20) some.push_back(checks[k]);
    run_program(some);
}

/// A scene whose hull, body or obstacle has a shape with one of its parameters set.
std::string scene_with_shape(const std::string& section, const std::string& shape, const std::string& line) {
    const std::string solid = "shape = \"" + shape + "\"\n" + line + "\n";
    if (section == "hull")
        return "[hull]\n" + solid +
               "draft = 0.02\n[motion]\nkind = \"stream\"\nspeed = 8\n[resolution]\nnear_hull = 0.2\n";
    const std::string text =
        "[tank]\nmin = [-9, -9, -9]\nmax = [9, 9, 9]\n[resolution]\nnear_hull = 0.1\n[run]\nduration = 1\n";
    if (section == "body") return text + "[[body]]\n" + solid + "draft = 0.02\ndensity = 500\n";
    return text + "[[obstacle]]\n" + solid;
}

/// A scene for each extreme of each shape's parameters; of bodies and obstacles the largest lengths and angles.
std::vector<Check> checks_of_all_shapes() {
    std::vector<Check> checks;
    for (const HullShape& shape : hull_shapes())
        for (const HullParameter& p : shape.parameters) {
            const auto add = [&](const std::string& section, double value) {
                const std::string line = fmt::format("{} = {:.17g}", p.name, value);
                checks.push_back(
                    {section + ": " + shape.name + ", " + line, scene_with_shape(section, shape.name, line)});
            };
            for (const double value : {p.min, p.max, -1.0, 0.0, 1e-300, 1e300}) add("hull", value);
            if (p.kind == "-") continue;
            for (const char* section : {"body", "obstacle"}) add(section, p.max);
        }
    return checks;
}

TEST(Extremes, EachParameterOfAShapeIsRefusedOrEndsFinite) {
    std::vector<Check> checks = checks_of_all_shapes();
    EXPECT_GT(checks.size(), 250u);
    // A thin disc, all of whose domain is near it: of 11 s most went into distances for counting particles.
    const std::string disc = scene_with_shape("hull", "torpedo", "diameter = 50");
    checks.push_back({"a disc", with(with(disc, "near_hull = 0.2", "near_hull = 0.04"), "0.02", "0.1")});
    run(checks);
}

// What hung or printed infinities once.
TEST(Extremes, TheProgramRefusesOrEndsFiniteWhereItFell) {
    const std::string tall = with(planing, "[motion]", "[domain]\nabove = 1e9\n[motion]");
    const auto water = [](const std::string& line) { return planing + "[water]\n" + line + "\n"; };
    run_program({{"domain.above", tall},
                 {"water.viscosity", water("viscosity = 0")},
                 {"water.surface_tension", water("surface_tension = 0")},
                 {"motion.speed", with(planing, "\"8 m/s\"", "1e-300")},
                 {"hull.pitch_gyradius",
                  with(planing, "half     = true",
                       "half     = true\nfree = [\"heave\", \"pitch\"]\nmass = 300\nlcg = 1.6\nvcg = 0.3\n"
                       "pitch_gyradius = 1e300")}});
}

TEST(Extremes, ANumberThatIsNotFiniteAndAMessageWithoutAPlaceAreSeen) {
    EXPECT_EQ(not_finite("influence: Re = 1e+06, banana"), "");
    EXPECT_EQ(not_finite("Re = inf"), "inf");
    EXPECT_EQ(not_finite("-nan N"), "nan");
    EXPECT_TRUE(names_its_place("a.toml:3:1: [hull] draft = 0: found", "a.toml"));
    EXPECT_FALSE(names_its_place("a.toml: [hull] draft: found", "a.toml"));
    EXPECT_FALSE(names_its_place("too large", "a.toml"));
}

}  // namespace extremes_test
}  // namespace tw::test
