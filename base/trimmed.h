#pragma once
#include <string_view>

namespace tw {

/// Without blanks, tabs and carriage returns at both ends.
inline std::string_view trimmed(std::string_view s) {
    const std::size_t first = s.find_first_not_of(" \t\r");
    return first == std::string_view::npos ? "" : s.substr(first, s.find_last_not_of(" \t\r") - first + 1);
}

}  // namespace tw
