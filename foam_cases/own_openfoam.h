#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace tw {

// Twinwake's own builds for OpenFOAM: a sound solver for Debian's and Ubuntu's package, and its libraries of walls,
// zones and held hulls. `twinwake setup-openfoam` makes them with the scripts of tools/.

/// Folders that may hold them, in the order in which they are looked at: the one above $TWINWAKE_OPENFOAM_BIN,
/// .openfoam beside the program's folder (a checkout), the user's (~/.local/share/twinwake/openfoam), and the machine's
/// (/usr/local/lib/twinwake/openfoam). Each has bin/, lib/ and walls/ of one release each.
std::vector<std::filesystem::path> own_openfoam_folders();

/// Where setup-openfoam builds unless it is told: .openfoam of a checkout, else the user's folder, or for all users the
/// machine's. Throws InputError: the user has no home folder.
std::filesystem::path setup_folder(bool for_all_users);

/// A script of tools/ of the checkout that the program was built in, or installed with it (share/twinwake/tools); where
/// neither is there, its place in the latter.
std::filesystem::path setup_script(const std::string& name);

/// "twinwake setup-openfoam", or with the program's whole path where the shell would not find it by its name.
std::string setup_command();

}  // namespace tw
