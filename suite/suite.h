#pragma once
#include <filesystem>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "compare/truth/reading.h"
#include "compare/truth/validation.h"
#include "scene/scene.h"
#include "scene/uncertain.h"

namespace tw {

/// How much time a case takes, the least first; a tier holds those before it.
const std::vector<std::string>& suite_tiers();  ///< minutes, hour, night, gpu

/// A scene of a case: a scene file and what is changed of it.
struct SuiteScene {
    std::string name;  ///< of its folder of results; empty: the case's only one
    std::filesystem::path file;
    std::string place = {};  ///< "suite.toml:5:9: [case] scene", for messages
    SceneOverrides changes = {};
    std::vector<std::string> methods = {};  ///< empty: the scene's
    int levels = 3;                         ///< sizes, the scene's own and coarser ones
    double ratio = 1.4142135623730951;      ///< of neighbouring sizes [-]
    /// Numbers that are known within an interval, beside those that the scene itself names as such.
    std::optional<UncertainTable> uncertain = {};
};

/// A quantity that a case judges. What a run does not need to be known stands in `judged`: name, label, unit, truth, goal.
struct SuiteQuantity {
    ValidatedQuantity judged;
    std::size_t scene = 0;             ///< place among the case's scenes
    std::optional<Reading> reading;    ///< none: the name is that of a report's quantity
    std::filesystem::path measured;    ///< mapping of an import that holds the truth; empty: it is known
    bool own_uncertainty = false;      ///< the suite says the truth's uncertainty, whatever the measurement says
    std::optional<double> goal_share;  ///< goal over the scale [-], where that follows from a measurement
    std::string place;                 ///< "suite.toml:12:1: [quantity] name", for messages
};

struct SuiteCase {
    std::string name, title, family, tier, why, shows, shows_not;
    std::vector<SuiteScene> scenes;
    std::vector<SuiteQuantity> quantities;
};

/// A folder of cases that a program's results are held against.
struct Suite {
    std::string title;
    std::filesystem::path folder;
    std::vector<SuiteCase> cases;
};

/// Reads FOLDER/suite.toml and every FOLDER/cases/*.toml, in the order of their names; files are relative to the file that
/// names them. Reads no scene. Throws InputError `file:line:column: what was found; what is expected`: there is no
/// suite.toml or no case, not TOML, an unknown or missing key, two cases of one name, a truth that cannot be worked out.
Suite read_suite(const std::filesystem::path& folder);

/// What a suite may look like, for --help.
extern const char* const suite_help;

}  // namespace tw
