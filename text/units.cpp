#include "text/units.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>
#include <utility>

#include "base/numbers.h"
#include "base/trimmed.h"

namespace tw {
namespace {

struct Symbol {
    std::string_view name;
    double factor;
    Dimension dimension;
    bool another = false;  ///< another spelling, or seldom used: read, and not listed in messages
};

constexpr double pound = 0.45359237;        // [kg], exact by definition
constexpr double foot = 0.3048;             // [m], exact by definition
constexpr double nautical_mile = 1852.0;    // [m], exact by definition
constexpr double g0 = 9.80665;              // [m/s2], standard gravity, for pound-force and kilogram-force
constexpr double slug = pound * g0 / foot;  // [kg]: a pound-force gives it a foot per second squared
constexpr Dimension length{1, 0, 0, 0}, mass{0, 1, 0, 0}, time{0, 0, 1, 0}, angle{0, 0, 0, 1}, speed{1, 0, -1, 0},
    force{1, 1, -2, 0}, pressure{-1, 1, -2, 0}, energy{2, 1, -2, 0}, power{2, 1, -3, 0}, frequency{0, 0, -1, 0},
    volume{3, 0, 0, 0}, kinematic{2, 0, -1, 0}, dynamic{-1, 1, -1, 0}, none{};

// The whole table: nothing else in the project knows a unit by its name.
constexpr auto symbols = std::to_array<Symbol>({
    {"m", 1, length},
    {"mm", 1e-3, length},
    {"cm", 1e-2, length},
    {"dm", 1e-1, length, true},
    {"um", 1e-6, length},
    {"µm", 1e-6, length, true},
    {"km", 1e3, length},
    {"ft", foot, length},
    {"feet", foot, length, true},
    {"foot", foot, length, true},
    {"in", foot / 12, length},
    {"inch", foot / 12, length, true},
    {"inches", foot / 12, length, true},
    {"yd", 3 * foot, length},
    {"mi", 5280 * foot, length, true},
    {"nmi", nautical_mile, length},
    {"l", 1e-3, volume, true},
    {"L", 1e-3, volume, true},
    {"s", 1, time},
    {"sec", 1, time, true},
    {"ms", 1e-3, time},
    {"us", 1e-6, time},
    {"min", 60, time},
    {"h", 3600, time},
    {"hr", 3600, time, true},
    {"kg", 1, mass},
    {"g", 1e-3, mass},
    {"t", 1e3, mass},
    {"lb", pound, mass},
    {"lbs", pound, mass, true},
    {"lbm", pound, mass, true},
    {"slug", slug, mass},
    {"slugs", slug, mass, true},
    {"rad", 1, angle},
    {"deg", degree, angle},
    {"°", degree, angle},
    {"degree", degree, angle, true},
    {"degrees", degree, angle, true},
    {"mrad", 1e-3, angle},
    {"kn", nautical_mile / 3600, speed},
    {"kt", nautical_mile / 3600, speed},
    {"kts", nautical_mile / 3600, speed, true},
    {"knot", nautical_mile / 3600, speed, true},
    {"knots", nautical_mile / 3600, speed, true},
    {"mph", 5280 * foot / 3600, speed},
    {"kph", 1 / 3.6, speed, true},
    {"kmh", 1 / 3.6, speed, true},
    {"fps", foot, speed, true},
    {"N", 1, force},
    {"mN", 1e-3, force},
    {"kN", 1e3, force},
    {"MN", 1e6, force},
    {"lbf", pound* g0, force},
    {"kgf", g0, force, true},
    {"Pa", 1, pressure},
    {"mPa", 1e-3, pressure, true},
    {"hPa", 1e2, pressure},
    {"kPa", 1e3, pressure},
    {"MPa", 1e6, pressure},
    {"GPa", 1e9, pressure},
    {"bar", 1e5, pressure},
    {"mbar", 1e2, pressure, true},
    {"atm", 101325, pressure, true},
    {"psi", pound* g0 / (foot / 12) / (foot / 12), pressure},
    {"psf", pound* g0 / foot / foot, pressure, true},
    {"St", 1e-4, kinematic, true},
    {"cSt", 1e-6, kinematic},
    {"P", 0.1, dynamic, true},
    {"cP", 1e-3, dynamic},
    {"J", 1, energy},
    {"kJ", 1e3, energy},
    {"W", 1, power},
    {"kW", 1e3, power},
    {"Hz", 1, frequency},
    {"kHz", 1e3, frequency},
    {"rpm", 2 * pi / 60, {0, 0, -1, 1}},
    {"%", 1e-2, none},
});

/// What has no key of its own on many keyboards, as the table and parse_unit have it.
constexpr auto written_otherwise = std::to_array<std::pair<std::string_view, std::string_view>>({
    {"²", "^2"}, {"³", "^3"}, {"·", "*"}, {"⋅", "*"}, {"μ", "µ"},  // the Greek letter for the sign
});

std::string plain_powers(std::string_view text) {
    std::string out;
    while (!text.empty()) {
        const auto found = std::find_if(written_otherwise.begin(), written_otherwise.end(),
                                        [&](const auto& w) { return text.starts_with(w.first); });
        const bool other = found != written_otherwise.end();
        out += other ? found->second : text.substr(0, 1);
        text.remove_prefix(other ? found->first.size() : 1);
    }
    return out;
}

bool is_digit(char c) { return c >= '0' && c <= '9'; }
bool is_symbol(char c) {
    return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '%' || static_cast<unsigned char>(c) >= 0x80;
}

const Symbol& find_symbol(std::string_view name) {
    for (const Symbol& s : symbols)
        if (s.name == name) return s;
    std::string known;
    for (const Symbol& s : symbols) {
        if (s.another) continue;
        if (!known.empty()) known += ' ';
        known += s.name;
    }
    throw UnitError(fmt::format("unknown unit '{}'; known units: {} (and products such as m/s, kg/m^3)", name, known));
}

}  // namespace

Unit parse_unit(std::string_view original) {
    const std::string plain = plain_powers(original);
    std::string_view text = trimmed(plain);
    Unit unit;
    if (text == "-" || text.empty()) return unit;
    int sign = 1;
    while (true) {
        std::size_t n = 0;
        while (n < text.size() && is_symbol(text[n])) ++n;
        if (n == 0) throw UnitError(fmt::format("'{}' is not a unit", original));
        const Symbol& symbol = find_symbol(text.substr(0, n));
        text.remove_prefix(n);
        const bool raised = !text.empty() && text.front() == '^';
        if (raised) text.remove_prefix(1);
        int power = 1;
        if (raised || (!text.empty() && (is_digit(text.front()) || text.front() == '-'))) {
            const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), power);
            if (error != std::errc{} || std::abs(power) > 9)
                throw UnitError(fmt::format("'{}' is not a unit", original));
            text.remove_prefix(static_cast<std::size_t>(end - text.data()));
        }
        power *= sign;
        unit.factor *= std::pow(symbol.factor, power);
        unit.dimension.m += power * symbol.dimension.m;
        unit.dimension.kg += power * symbol.dimension.kg;
        unit.dimension.s += power * symbol.dimension.s;
        unit.dimension.rad += power * symbol.dimension.rad;
        text = trimmed(text);
        if (text.empty()) return unit;
        sign = 1;
        if (text.front() == '/' || text.front() == '*' || text.front() == '.') {
            sign = text.front() == '/' ? -1 : 1;
            text.remove_prefix(1);
        }
        text = trimmed(text);
    }
}

std::string unit_after_number(std::string_view text) {
    text = trimmed(text);
    if (text.starts_with('+')) text.remove_prefix(1);
    double number = 0;
    const auto [end, error] = std::from_chars(text.data(), text.data() + text.size(), number);
    const std::string_view rest = trimmed(text.substr(static_cast<std::size_t>(end - text.data())));
    return rest.empty() ? "-" : std::string(rest);
}

bool has_unit(std::string_view text) {
    text = trimmed(text);
    const std::size_t last = text.find_last_not_of(" \t\r");
    return last != std::string_view::npos && !is_digit(text[last]) && text[last] != '.';
}

std::string time_in_words(double seconds) {
    constexpr double day = 86400, year = 365.25 * day;
    if (seconds < 120) return fmt::format("{:.0f} s", seconds);
    if (seconds < 7200) return fmt::format("{:.0f} min", seconds / 60);
    if (seconds < 2 * day) return fmt::format("{:.1f} h", seconds / 3600);
    if (seconds < 2 * year) return fmt::format("{:.1f} days", seconds / day);
    return fmt::format("{:.2g} years", seconds / year);
}

std::string units_like(std::string_view si_unit) {
    const Dimension wanted = parse_unit(si_unit).dimension;
    std::string list(si_unit);
    for (const Symbol& s : symbols) {
        if (s.dimension != wanted || s.another || s.name == si_unit || s.name == "°") continue;
        list += ", ";
        list += s.name;
    }
    return list;
}

double quantity(std::string_view original, std::string_view si_unit) {
    const std::string_view text = trimmed(original);
    double value = 0;
    // from_chars: the same answer in any locale; it takes no leading '+'.
    const char* begin = text.data() + (text.starts_with('+') ? 1 : 0);
    const auto [end, error] = std::from_chars(begin, text.data() + text.size(), value);
    if (error != std::errc{} || !std::isfinite(value))
        throw UnitError(
            fmt::format("'{}' does not begin with a finite number; expected e.g. \"1.5 {}\"", original, si_unit));
    const std::string_view rest = trimmed(text.substr(static_cast<std::size_t>(end - text.data())));
    if (rest.empty()) return value;
    const Unit unit = parse_unit(rest);
    if (unit.dimension != parse_unit(si_unit).dimension) {
        if (unit.dimension == dynamic && parse_unit(si_unit).dimension == kinematic)
            throw UnitError(fmt::format(
                "'{}' is a unit of the dynamic viscosity mu; expected the kinematic one, nu = mu / density, in "
                "{}: of water 1e-6 m2/s, with mu = 1e-3 Pa s and 1000 kg/m3",
                rest, units_like(si_unit)));
        if (si_unit == "-") throw UnitError(fmt::format("'{}' has a unit; expected a plain number", original));
        throw UnitError(
            fmt::format("'{}' does not measure the right thing; expected a unit like {}", rest, units_like(si_unit)));
    }
    return value * unit.factor;
}

}  // namespace tw
