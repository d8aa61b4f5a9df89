#include <unistd.h>

#include <cstdlib>
#include <cstring>

#include "app/arguments/output.h"
#include "app/terminal/foreground.h"
#include "foam_cases/doctor.h"
#include "foam_cases/own_openfoam.h"

namespace tw::app {
namespace {

namespace fs = std::filesystem;

/// Whether the environment of a release other than the distribution's package is loaded: its solver is its vendor's,
/// and only the libraries are built.
bool release_is_loaded() {
    const char* project = std::getenv("WM_PROJECT_DIR");
    return project != nullptr && *project != '\0' && std::strcmp(project, "/usr/share/openfoam") != 0;
}

}  // namespace

int run_setup_openfoam(const SetupOpenfoamCommand& command, const Common& common) {
    const bool own = !command.folder.empty();
    const fs::path folder = own ? command.folder : setup_folder(command.for_all_users);
    const bool loaded = release_is_loaded();
    if (loaded && !command.solvers.empty())
        throw InputError(
            "setup-openfoam: the environment of an OpenFOAM release is loaded (WM_PROJECT_DIR), whose solvers are its "
            "own; expected no names of solvers");
    std::vector<std::string> words = command.solvers;
    words.insert(words.begin(), folder.string());
    if (command.jobs > 0) setenv("JOBS", std::to_string(command.jobs).c_str(), 1);
    const fs::path script = setup_script(loaded ? "build_openfoam_walls.sh" : "build_openfoam_solvers.sh");
    if (::access(script.c_str(), X_OK) != 0)
        throw InputError("setup-openfoam: " + script.string() +
                         " is not there; install twinwake whole (its package, or cmake --install)");
    if (run_in_foreground(script, std::move(words)) != 0) {
        complain("setup-openfoam: not done, for the reason above; remove it and give the same command again");
        return bad_input;
    }
    const fs::path bin = folder / "bin";
    if (own) setenv("TWINWAKE_OPENFOAM_BIN", bin.c_str(), 1);
    const OpenFoam found = sound_openfoam();
    say(common, "sound: " + found.command() + ": " + found.verdict + "\n");
    if (own)
        say(common, "for twinwake to find it in this folder: export TWINWAKE_OPENFOAM_BIN=" +
                        fs::absolute(bin).string() + "\n");
    return done;
}

}  // namespace tw::app
