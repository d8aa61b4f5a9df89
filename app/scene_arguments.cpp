#include <fmt/format.h>

#include "app/commands.h"
#include "base/errors.h"
#include "scene/units.h"

namespace tw::app {

SceneOverrides SceneArguments::overrides() const {
    SceneOverrides o;
    const auto read = [](const std::string& option, const std::string& text, const char* unit,
                         std::optional<double>& value) {
        if (text.empty()) return;
        try {
            value = quantity(text, unit);
        } catch (const UnitError& e) { throw InputError(fmt::format("{} {}: {}", option, text, e.what())); }
    };
    if (!hull.empty()) o.hull_file = hull;
    read("--speed", speed, "m/s", o.speed);
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
