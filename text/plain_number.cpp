#include "text/plain_number.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <cstdlib>
#include <string>

namespace tw {

std::string plain_number(double value, int digits) {
    const std::string short_form = fmt::format("{:.{}g}", value, digits);
    const double rounded = std::isfinite(value) ? std::strtod(short_form.c_str(), nullptr) : 0,
                 size = std::abs(rounded);
    if (!(size >= 1e-6 && size < 1e9)) return short_form;
    const int places = std::max(0, digits - 1 - static_cast<int>(std::floor(std::log10(size))));
    std::string text = fmt::format("{:.{}f}", rounded, places);
    if (places > 0) text.erase(text.find_last_not_of('0') + 1);
    if (text.back() == '.') text.pop_back();
    return text;
}

}  // namespace tw
