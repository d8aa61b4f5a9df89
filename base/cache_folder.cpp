#include "base/cache_folder.h"

#include <cstdlib>

namespace tw {

std::filesystem::path cache_folder() {
    if (const char* cache = std::getenv("XDG_CACHE_HOME"); cache && *cache)
        return std::filesystem::path(cache) / "twinwake";
    if (const char* home = std::getenv("HOME"); home && *home) return std::filesystem::path(home) / ".cache/twinwake";
    return {};
}

}  // namespace tw
