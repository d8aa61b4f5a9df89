#pragma once
#include <filesystem>

namespace tw {

/// Where the program keeps what it has learned of this machine: $XDG_CACHE_HOME/twinwake or ~/.cache/twinwake; empty
/// where there is neither.
std::filesystem::path cache_folder();

}  // namespace tw
