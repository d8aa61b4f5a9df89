#include "app/commands/scene_of_hull.h"

#include <fmt/format.h>

#include <cmath>
#include <stdexcept>
#include <string_view>

#include "app/commands/scene_text.h"
#include "meshes/read/solids_of_file.h"
#include "meshes/surface.h"

namespace tw::app {
namespace {

/// Gives the template's `key` another value; what the line says behind it stays in its place where there is room.
void set(std::string& text, std::string_view key, const std::string& value) {
    const std::string start = fmt::format("\n{:<5} = ", key);
    const std::size_t line = text.find(start);
    if (line == std::string::npos) throw std::logic_error(fmt::format("the template has no line of {}", key));
    const std::size_t from = line + start.size(), to = std::min(text.find('#', from), text.find('\n', from));
    const std::size_t room = to - from;
    text.replace(from, room, text[to] == '#' ? fmt::format("{:<{}} ", value, room - 1) : value);
}

std::string metres(double least) { return fmt::format("\"{:.6g} m\"", rounded_up(least, step_of(least))); }

}  // namespace

std::string scene_of_hull(std::string text, const std::filesystem::path& surface_file, const std::string& unit,
                          const std::string& axes, const std::filesystem::path& scene) {
    const Vec3 size = read_surface(surface_file.string(), unit, axes).bounds().size();
    constexpr double gravity = 9.81;                            // [m/s2]
    const double own_wave = std::sqrt(gravity * size.x());      // [m/s] Froude number 1 by the hull's length
    const double speed = rounded_up(own_wave, step_of(own_wave));
    text.replace(0, text.find('\n'), fmt::format("title = {}", quoted(fmt::format("{} at {:.6g} m/s",
                                                                                  surface_file.stem().string(), speed))));
    set(text, "file", quoted(seen_from(scene, surface_file)));
    set(text, "unit", quoted(unit));
    set(text, "axes", quoted(axes));
    set(text, "draft", metres(size.z() / 3));
    set(text, "speed", fmt::format("\"{:.6g} m/s\"", speed));
    set(text, "near_hull", metres(size.y() / 15));
    return text;
}

}  // namespace tw::app
