#pragma once
#include <cstdlib>
#include <filesystem>
#include <string>
#include <system_error>

#include "base/errors.h"

namespace tw {

/// A folder that vanishes with this object. Throws RunError where none can be made.
struct TemporaryFolder {
    std::filesystem::path path;
    TemporaryFolder() {
        std::string name = (std::filesystem::temp_directory_path() / "twinwake-XXXXXX").string();
        if (::mkdtemp(name.data()) == nullptr) throw RunError(name + ": no temporary folder could be made");
        path = name;
    }
    ~TemporaryFolder() {
        std::error_code none;
        std::filesystem::remove_all(path, none);
    }
    TemporaryFolder(const TemporaryFolder&) = delete;
    TemporaryFolder& operator=(const TemporaryFolder&) = delete;
};

}  // namespace tw
