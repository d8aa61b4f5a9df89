#include "app/commands/scene_text.h"

#include <cmath>

namespace tw::app {

std::string quoted(const std::string& text) {
    std::string out = "\"";
    for (const char c : text) {
        if (c == '"' || c == '\\') out += '\\';
        out += c;
    }
    return out + '"';
}

std::string seen_from(const std::filesystem::path& scene, const std::filesystem::path& file) {
    const std::filesystem::path folder = std::filesystem::absolute(scene).parent_path();
    return std::filesystem::absolute(file).lexically_proximate(folder).generic_string();
}

double step_of(double value) { return std::pow(10, std::floor(std::log10(value)) - 1); }
double rounded_up(double value, double step) { return std::ceil(value / step - 1e-9) * step; }

}  // namespace tw::app
