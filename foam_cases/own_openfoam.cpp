#include "foam_cases/own_openfoam.h"

#include <cstdlib>

#include "base/errors.h"
#include "foam_cases/run/environment.h"

namespace tw {
namespace fs = std::filesystem;

namespace {

fs::path this_program() {
    std::error_code none;
    return fs::read_symlink("/proc/self/exe", none);
}

/// The checkout in whose build folder the program lies; empty: it is installed, or a program of the tests.
fs::path checkout() {
    const fs::path root = this_program().parent_path().parent_path();
    std::error_code none;
    return !root.empty() && fs::exists(root / "tools/build_openfoam_solvers.sh", none) ? root : fs::path();
}

fs::path folder_of_user() {
    const char* home = std::getenv("HOME");
    return home == nullptr || *home == '\0' ? fs::path() : fs::path(home) / ".local/share/twinwake/openfoam";
}

const fs::path folder_of_machine = "/usr/local/lib/twinwake/openfoam";

}  // namespace

std::vector<fs::path> own_openfoam_folders() {
    std::vector<fs::path> out;
    if (const char* bin = std::getenv("TWINWAKE_OPENFOAM_BIN"); bin != nullptr && *bin != '\0')
        out.push_back(fs::path(bin).parent_path());
    if (const fs::path self = this_program(); !self.empty())
        out.push_back(self.parent_path().parent_path() / ".openfoam");
    if (const fs::path users = folder_of_user(); !users.empty()) out.push_back(users);
    out.push_back(folder_of_machine);
    return out;
}

fs::path setup_folder(bool for_all_users) {
    if (for_all_users) return folder_of_machine;
    if (const fs::path root = checkout(); !root.empty()) return root / ".openfoam";
    const fs::path users = folder_of_user();
    if (users.empty())
        throw InputError(
            "setup-openfoam: HOME is not set, so there is no user's folder to build in; expected --folder "
            "FOLDER, or --for-all-users for " +
            folder_of_machine.string());
    return users;
}

fs::path setup_script(const std::string& name) {
    const fs::path root = checkout();
    if (!root.empty()) return root / "tools" / name;
    return this_program().parent_path().parent_path() / "share/twinwake/tools" / name;
}

std::string setup_command() {
    const fs::path self = this_program();
    if (self.filename() != "twinwake") return "twinwake setup-openfoam";  // a program that has the same rooms
    const char* path = std::getenv("PATH");
    std::error_code none;
    const fs::path found = find_program({std::string("PATH=") + (path == nullptr ? "" : path)}, "twinwake");
    const bool by_name = !found.empty() && fs::equivalent(found, self, none);
    return (by_name ? std::string("twinwake") : self.string()) + " setup-openfoam";
}

}  // namespace tw
