#include <unistd.h>

#include <cstdlib>

#include "app/arguments/output.h"
#include "app/terminal/foreground.h"
#include "foam_cases/run/environment.h"

namespace tw::app {
namespace {

namespace fs = std::filesystem;

/// The folder of the Python package: of the checkout that the program was built in, or installed with it.
fs::path python_folder() {
    std::error_code none;
    const fs::path prefix = fs::read_symlink("/proc/self/exe", none).parent_path().parent_path();
    for (const char* place : {"python", "lib/python3/dist-packages"})
        if (fs::exists(prefix / place / "twinwake/film.py", none)) return prefix / place;
    throw InputError("film: the Python package is neither in " + (prefix / "python").string() + " nor in " +
                     (prefix / "lib/python3/dist-packages").string() +
                     "; install twinwake whole (its package, or cmake --install)");
}

/// The first Python that has what films need: the shell's, else the distribution's.
fs::path python_with_plots() {
    const char* path = std::getenv("PATH");
    std::string seen;
    for (const fs::path& python : {find_program({std::string("PATH=") + (path == nullptr ? "" : path)}, "python3"),
                                   fs::path("/usr/bin/python3")}) {
        if (::access(python.c_str(), X_OK) != 0) continue;
        if (run_in_foreground(python, {"-c", "import h5py, numpy, matplotlib"}, true) == 0) return python;
        seen += (seen.empty() ? "" : ", ") + python.string();
    }
    throw InputError(
        "film: " + (seen.empty() ? "there is no python3" : "none of " + seen + " has h5py and matplotlib") +
        "; Debian, Ubuntu: sudo apt-get install python3-h5py python3-matplotlib python3-pil ffmpeg");
}

}  // namespace

int run_film(const FilmCommand& command, const Common& common) {
    const fs::path package = python_folder();
    const char* others = std::getenv("PYTHONPATH");
    const bool alone = others == nullptr || *others == '\0';
    setenv("PYTHONPATH", (package.string() + (alone ? "" : std::string(":") + others)).c_str(), 1);
    std::vector<std::string> words{"-m", "twinwake.film", command.run.string()};
    if (!command.out.empty()) words.insert(words.end(), {"--out", command.out.string()});
    if (command.seconds > 0) words.insert(words.end(), {"--seconds", std::to_string(command.seconds)});
    if (command.overwrite) words.push_back("--overwrite");
    if (common.quiet) words.push_back("--quiet");
    return run_in_foreground(python_with_plots(), std::move(words)) == 0 ? done : bad_input;
}

}  // namespace tw::app
