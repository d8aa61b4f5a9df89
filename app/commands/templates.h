#pragma once
#include <string_view>
#include <vector>

namespace tw::app {

struct Template {
    std::string_view name, text;
};
/// Scene files to start from.
const std::vector<Template>& templates();

}  // namespace tw::app
