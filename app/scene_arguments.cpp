#include <fmt/format.h>

#include <limits>

#include "app/commands.h"
#include "base/errors.h"
#include "scene/units.h"

namespace tw::app {

namespace {

void read(const std::string& option, const std::string& text, const char* unit, std::optional<double>& value) {
    if (text.empty()) return;
    try {
        value = quantity(text, unit);
    } catch (const UnitError& e) { throw InputError(fmt::format("{} {}: {}", option, text, e.what())); }
}

}  // namespace

double LadderCommand::budget_seconds() const {
    std::optional<double> seconds;
    read("--budget", budget, "s", seconds);
    if (seconds && !(*seconds > 0))
        throw InputError(fmt::format("--budget {}: expected a time above 0, e.g. 2h", budget));
    return seconds.value_or(std::numeric_limits<double>::infinity());
}

SceneOverrides SceneArguments::overrides() const {
    SceneOverrides o;
    if (!hull.empty()) o.hull_file = hull;
    read("--speed", speed, "m/s", o.speed);
    read("--trim", trim, "rad", o.trim);
    read("--spacing", spacing, "m", o.spacing);
    read("--near-hull", near_hull, "m", o.near_hull);
    read("--scale", scale, "", o.scale_resolution);
    if (o.scale_resolution && !(*o.scale_resolution > 0))
        throw InputError(
            fmt::format("--scale {}: expected a number above 0, e.g. 1.4142 for coarser, 0.7071 for finer", scale));
    read("--duration", duration, "s", o.duration);
    return o;
}

}  // namespace tw::app
