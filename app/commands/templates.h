#pragma once
#include <string_view>
#include <vector>

namespace tw::app {

/// A scene file to start from.
struct Template {
    std::string_view name;
    std::string_view about;  ///< what it solves, in a few words
    std::string_view text;
};
/// All of them, the one for a hull of the user's own first.
const std::vector<Template>& templates();

}  // namespace tw::app
