#pragma once
#include <unistd.h>

#include <string>
#include <vector>

namespace tw::app {

/// This process's environment, "NAME=value" each, for its children.
inline std::vector<std::string> environment_here() {
    std::vector<std::string> all;
    for (char** entry = environ; *entry; ++entry) all.emplace_back(*entry);
    return all;
}

}  // namespace tw::app
