#include "app/commands/scene_of_bodies.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <string>
#include <vector>

#include "app/commands/scene_text.h"
#include "meshes/read/solids_of_file.h"
#include "meshes/surface.h"

namespace tw::app {
namespace {

/// As the scene's identifiers are: letters, digits and '_', a letter first, at most 40 of them; none twice.
std::string new_identifier(const std::string& name, const std::vector<std::string>& taken) {
    constexpr std::size_t longest = 36;  // leaves room for a number
    const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    std::string word;
    for (const char c : name)
        if (letter(c) || (c >= '0' && c <= '9'))
            word += c;
        else if (!word.empty() && word.back() != '_')
            word += '_';
    while (!word.empty() && word.back() == '_') word.pop_back();
    if (word.empty() || !letter(word[0])) word = "body_" + word;
    word.resize(std::min(word.size(), longest));
    std::string unique = word;
    for (int n = 2; std::ranges::find(taken, unique) != taken.end(); ++n) unique = fmt::format("{}_{}", word, n);
    return unique;
}

std::string corner(Vec3 at) { return fmt::format("[{:.6g}, {:.6g}, {:.6g}]", at.x(), at.y(), at.z()); }

}  // namespace

std::string scene_of_bodies(const std::filesystem::path& surface_file, const std::string& unit, const std::string& axes,
                            const std::filesystem::path& scene) {
    const std::vector<std::string> names = names_of_bodies(solids_of_file(surface_file));
    const std::string source = seen_from(scene, surface_file);
    std::string bodies;
    std::vector<std::string> taken;
    Box all;
    double thinnest = 0;
    for (std::size_t n = 0; n < std::max<std::size_t>(names.size(), 1); ++n) {
        const std::string mark = names.empty() ? "" : "#" + names[n];
        const Box box = read_surface(surface_file.string() + mark, unit, axes).bounds();
        all = n == 0 ? box : Box{all.min.cwiseMin(box.min), all.max.cwiseMax(box.max)};
        thinnest = n == 0 ? box.size().minCoeff() : std::min(thinnest, box.size().minCoeff());
        taken.push_back(new_identifier(names.empty() ? surface_file.stem().string() : names[n], taken));
        bodies += fmt::format("[[body]]\nname    = \"{}\"\nfile    = {}\n", taken.back(), quoted(source + mark));
        if (unit != "m") bodies += fmt::format("unit    = \"{}\"\n", unit);
        if (axes != "xyz") bodies += fmt::format("axes    = \"{}\"\n", axes);
        bodies += fmt::format("density = \"500 kg/m3\"       # of the whole solid; or: mass = \"80 kg\"\n\n");
    }
    const double room = std::max(0.5 * all.size().maxCoeff(), 1e-9), step = step_of(room);
    const Vec3 reach(room, room, room);
    Vec3 low = all.min - reach, high = all.max + reach;
    low.z() = std::min(all.min.z(), 0.0) - room, high.z() = std::max(all.max.z(), 0.0) + room;
    for (int a = 0; a < 3; ++a) low[a] = -rounded_up(-low[a], step), high[a] = rounded_up(high[a], step);
    // Five sizes across the thinnest body, but no more than some 300 000 in the water.
    const double water = (high.x() - low.x()) * (high.y() - low.y()) * -low.z();
    const double wanted = std::max(thinnest / 5, std::cbrt(water / 300'000)),
                 size = rounded_up(wanted, step_of(wanted));
    const std::string methods =
        names.size() > 1
            ? "methods  = [\"sph\"]          # interFoam needs some cells between bodies: check says whether "
              "it can, with \"fvm\"\n"
            : "";
    return fmt::format(R"(title = {}

# Axes: x to the stern, z up, still water at z = 0. The bodies lie where they lie in their file.
[tank]
min = {}
max = {}

{}[motion]
kind = "none"

[resolution]
near_hull = "{:.6g} m"       # particles, and cells at the wetted bodies

[run]
duration = "1 s"
{})",
                       quoted("Bodies of " + surface_file.filename().string()), corner(low), corner(high), bodies, size,
                       methods);
}

}  // namespace tw::app
