#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "app/arguments/commands.h"
#include "base/errors.h"
#include "scene/effects/registry.h"
#include "scene/read/read.h"
#include "text/did_you_mean.h"
#include "text/units.h"

namespace tw::app {

namespace {

void read(const std::string& option, const std::string& text, const char* unit, std::optional<double>& value) {
    if (text.empty()) return;
    try {
        value = quantity(text, unit);
    } catch (const UnitError& e) { throw InputError(fmt::format("{} {}: {}", option, text, e.what())); }
}

/// "NAME=on" or "NAME=off".
void read_effect(const std::string& text, std::map<std::string, bool>& effects) {
    const auto equals = text.find('=');
    const std::string name = present_name(text.substr(0, equals)),
                      value = equals == text.npos ? "" : text.substr(equals + 1);
    refuse_unknown_effect("--effect " + text, name);
    if (value != "on" && value != "off")
        throw InputError(fmt::format("--effect {}: expected {}=on or {}=off", text, name, name));
    effects[name] = value == "on";
}

}  // namespace

void refuse_unknown_effect(const std::string& option, const std::string& name) {
    const std::vector<std::string> known = effect_names();
    if (std::ranges::find(known, name) != known.end()) return;
    throw InputError(fmt::format("{}: there is no effect '{}'; expected one of: {}{}", option, name,
                                 fmt::join(known, ", "), did_you_mean(name, known)));
}

SceneOverrides SceneArguments::overrides() const {
    SceneOverrides o;
    if (!hull.empty()) o.hull_file = hull;
    read("--speed", speed, "m/s", o.speed);
    read("--trim", trim, "rad", o.trim);
    if (o.trim && std::abs(*o.trim) > largest_plain_angle && !has_unit(trim))
        throw InputError(
            fmt::format("--trim {}: a number without a unit is in radians, and this is {:.3g} degrees, more than 15; "
                        "expected \"{} deg\", or \"{} rad\" where that is meant",
                        trim, *o.trim / degree, trim, trim));
    read("--wave-length", wave_length, "m", o.wave_length);
    read("--spacing", spacing, "m", o.spacing);
    read("--near-hull", near_hull, "m", o.near_hull);
    read("--scale", scale, "", o.scale_resolution);
    if (o.scale_resolution && !(*o.scale_resolution > 0))
        throw InputError(
            fmt::format("--scale {}: expected a number above 0, e.g. 1.4142 for coarser, 0.7071 for finer", scale));
    read("--duration", duration, "s", o.duration);
    o.device = device;
    for (const std::string& effect : effects) read_effect(effect, o.effects);
    return o;
}

}  // namespace tw::app
