#include "foam_cases/run/wrapper.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <chrono>
#include <cstdlib>
#include <map>
#include <sstream>
#include <thread>

#include "base/atomic_file.h"
#include "base/errors.h"
#include "foam_cases/flavour.h"
#include "foam_cases/run/environment.h"
#include "foam_cases/run/temporary_folder.h"

namespace tw {
namespace {

constexpr int patience = 120;  // [s]; an image may have to be fetched from a slow disk

/// Of the environment behind the prefix, as printenv writes it.
std::map<std::string, std::string> variables_behind(const OpenFoam& found) {
    const TemporaryFolder folder;
    const std::vector<std::string> environment = environment_of(found, folder.path);
    const std::filesystem::path log = folder.path / "printenv";
    ChildProcess child(behind(found.prefix, "printenv", {}, environment), environment, folder.path, log);
    const double until = wall_clock() + patience;
    std::optional<Ended> ended;
    while (!(ended = child.poll()) && wall_clock() < until) std::this_thread::sleep_for(std::chrono::milliseconds(20));
    if (!ended) throw RunError(fmt::format("printenv behind it did not end within {} s", patience));
    const std::string text = read_text(log);
    if (!ended->ok()) {
        const std::size_t last = text.find_last_of('\n', text.size() < 2 ? 0 : text.size() - 2);
        throw RunError(fmt::format("printenv behind it failed (exit status {}): {}", ended->status,
                                   text.substr(last == std::string::npos ? 0 : last + 1)));
    }
    std::map<std::string, std::string> variables;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);)
        if (const std::size_t equals = line.find('='); equals != std::string::npos)
            variables[line.substr(0, equals)] = line.substr(equals + 1);
    return variables;
}

}  // namespace

std::vector<std::string> openfoam_prefix() {
    const char* value = std::getenv("TWINWAKE_OPENFOAM_PREFIX");
    std::istringstream text(value == nullptr ? "" : value);
    std::vector<std::string> words;
    for (std::string word; text >> word;) words.push_back(word);
    return words;
}

Command behind(const std::vector<std::string>& prefix, const std::string& program,
               const std::vector<std::string>& arguments, const std::vector<std::string>& environment) {
    std::filesystem::path first = prefix.front();
    if (!first.has_parent_path()) first = find_program(environment, prefix.front());
    if (first.empty())
        throw RunError(
            fmt::format("'{}', the first word of TWINWAKE_OPENFOAM_PREFIX, is not on the PATH", prefix.front()));
    Command command{first, {prefix.begin() + 1, prefix.end()}};
    command.arguments.push_back(program);
    command.arguments.insert(command.arguments.end(), arguments.begin(), arguments.end());
    return command;
}

OpenFoam openfoam_behind(const std::vector<std::string>& prefix) {
    OpenFoam found;
    found.prefix = prefix;
    found.solver = "interFoam";
    const auto unusable = [&](const std::string& why) {
        found.verdict = fmt::format("TWINWAKE_OPENFOAM_PREFIX = \"{}\", unusable: {}", fmt::join(prefix, " "), why);
        return found;
    };
    try {
        const std::map<std::string, std::string> variables = variables_behind(found);
        const auto value = [&](const char* name) {
            const auto at = variables.find(name);
            return at == variables.end() ? std::string() : at->second;
        };
        found.project_dir = value("WM_PROJECT_DIR");
        found.version = value("WM_PROJECT_VERSION");
        found.bin = value("FOAM_APPBIN");
        if (found.project_dir.empty() || found.version.empty() || found.bin.empty())
            return unusable(
                "no OpenFOAM's environment is loaded behind it (WM_PROJECT_DIR, WM_PROJECT_VERSION, FOAM_APPBIN); "
                "expected words after which a program runs in it, for instance \"apptainer exec of.sif openfoam2506\" "
                "or a script of "
                "your own that sources etc/bashrc and ends with exec \"$@\"");
        found.vendor = vendor_of(found.version);
        // By its full path: on the PATH another release's may come first.
        found.solver = found.bin / Flavour::from_version(found.vendor, found.version).solver_program();
    } catch (const std::exception& e) { return unusable(e.what()); }
    return found;
}

}  // namespace tw
