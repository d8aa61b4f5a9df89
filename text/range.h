#pragma once
#include <limits>
#include <string>
#include <string_view>

namespace tw {

/// Closed range of SI values that a key accepts; `open_min`: the lower end itself is refused.
struct Range {
    double min = -std::numeric_limits<double>::infinity(), max = std::numeric_limits<double>::infinity();  ///< [SI]
    bool open_min = false;
};
inline constexpr Range any_value{};
inline constexpr Range positive{0, std::numeric_limits<double>::infinity(), true};
inline constexpr Range not_negative{0, std::numeric_limits<double>::infinity(), false};

/// What any number of a text file may be in size, in SI units, where it is not 0: beyond lies no quantity of a flow of
/// water, and products of several such numbers are still finite.
inline constexpr double smallest_number = 1e-18, largest_number = 1e18;

/// "1000 m/s"; angles in degrees.
std::string value_text(double si, std::string_view unit);
/// "greater than 0 m/s and at most 1000 m/s"; empty: any value.
std::string range_text(const Range& range, std::string_view unit);

}  // namespace tw
