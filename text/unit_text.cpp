#include "text/unit_text.h"

namespace tw {

std::string unit_text(const std::string& unit) {
    const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    std::string out;
    for (std::size_t i = 0; i < unit.size(); ++i) {
        const bool ends = i + 1 == unit.size() || (!letter(unit[i + 1]) && (unit[i + 1] < '0' || unit[i + 1] > '9'));
        const bool power = i > 0 && letter(unit[i - 1]) && ends;
        out += power && unit[i] == '2' ? "²" : power && unit[i] == '3' ? "³" : std::string(1, unit[i]);
    }
    return out;
}

}  // namespace tw
