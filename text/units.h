#pragma once
#include <stdexcept>
#include <string>
#include <string_view>

namespace tw {

/// Exponents of the base units metre, kilogram, second and radian (an angle is a dimension of its own here, so that
/// "5 deg" cannot pass for a plain number).
struct Dimension {
    int m = 0, kg = 0, s = 0, rad = 0;
    bool operator==(const Dimension&) const = default;
};

/// The error in a quantity, without its place: "unknown unit 'kmh'; ...".
struct UnitError : std::runtime_error {
    using std::runtime_error::runtime_error;
};

/// Dimension and SI factor of a unit expression: symbols with integer powers, joined by '*', '.', blank or '/', e.g.
/// "m/s", "kg/m^3", "m2/s", "N/m", "-" (none). Throws UnitError for an unknown symbol.
struct Unit {
    double factor = 1;  ///< to SI [-]
    Dimension dimension;
};
Unit parse_unit(std::string_view text);

/// The SI value of `text` ("30 m/s", "5 deg", "12") where a quantity measured in `si_unit` is expected. A number
/// without a unit is taken as SI. Throws UnitError: not a finite number, unknown unit, other dimension.
double quantity(std::string_view text, std::string_view si_unit);

/// Whether something follows the number in `text`.
bool has_unit(std::string_view text);

/// The unit behind the number in `text`, without blanks around it; "-" where nothing does.
std::string unit_after_number(std::string_view text);

/// A time for people: "45 s", "12 min", "3.5 h", "8.2 days", "2.1 years".
std::string time_in_words(double seconds);

/// Symbols that measure the same thing as `si_unit`, for messages: "m, mm, cm, ...".
std::string units_like(std::string_view si_unit);

}  // namespace tw
