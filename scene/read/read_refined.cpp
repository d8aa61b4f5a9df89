#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <optional>

#include "base/numbers.h"
#include "scene/read/read.h"
#include "scene/refined_places.h"
#include "scene/solids/hull_bottom.h"

namespace tw {

namespace {

constexpr int most_sizes_below = 3;
constexpr int slices = 16;  ///< of the hull, along which the spray root is followed

Box grown(const Box& box, double by) { return {box.min - Vec3::Constant(by), box.max + Vec3::Constant(by)}; }

/// Where jets leave the hull's bottom: between still water and the height to which it rises on a wedge that enters it,
/// (pi/2 - 1) of the local draft (Wagner 1932, ZAMM 12, 193), slice by slice; of a section, whose jet runs ahead of it,
/// as high everywhere as that of its largest draft.
std::vector<Box> spray_root(const Hull& hull, double width) {
    constexpr double rise = std::numbers::pi / 2 - 1;
    const Box bounds = hull.surface.bounds();
    const int count = hull.section ? 1 : slices;
    const double step = bounds.size().x() / count;
    std::vector<Box> boxes;
    for (int s = 0; s < count; ++s) {
        Box slice{Vec3(bounds.min.x() + s * step, -infinite, -infinite),
                  Vec3(bounds.min.x() + (s + 1) * step, infinite, infinite)};
        const std::optional<Box> bottom = bottom_within(hull.surface, slice);
        if (!bottom || bottom->min.z() >= 0) continue;
        slice.min.z() = 0;
        slice.max.z() = -rise * bottom->min.z();
        for (const bool port : {false, true}) {
            if (port && (hull.half || hull.section)) continue;
            Box side = slice;
            if (!hull.section) (port ? side.max : side.min).y() = 0;
            if (const auto root = bottom_within(hull.surface, side)) boxes.push_back(grown(*root, width));
        }
    }
    return boxes;
}

Box free_surface(const Scene& scene, double width) {
    const Box& all = scene.domain.box;
    return {Vec3(all.min.x(), all.min.y(), -width), Vec3(all.max.x(), all.max.y(), width)};
}

std::vector<Box> boxes_of(SceneSection& s, RefinedPlace& place, const Scene& scene, double size) {
    using Around = RefinedPlace::Around;
    const std::string around = s.choice("around").value_or("box");
    const auto refuse = [&](const char* key, bool there) {
        if (there) s.fail(key, fmt::format("does not belong to around = \"{}\"; leave it out", around));
    };
    place.width = s.number("width");
    place.length = s.number("length");
    refuse("length", place.length && around != "wake");
    if (around == "box") {
        refuse("width", place.width.has_value());
        return {read_box(s)};
    }
    refuse("min", s.has("min"));
    refuse("max", s.has("max"));
    const double width = place.width.value_or(width_of_place * size);
    if (around == "spray_root") {
        place.around = Around::spray_root;
        std::vector<Box> boxes = spray_root(*scene.hull, width);
        if (boxes.empty()) s.fail("around", "no part of the hull's bottom crosses still water: there is no spray root");
        return boxes;
    }
    if (scene.hull->section) s.fail("around", "of a section only its spray root and boxes are refined");
    place.around = around == "wake" ? Around::wake : Around::free_surface;
    return {around == "wake" ? wake_of(scene, width, place.length) : free_surface(scene, width)};
}

}  // namespace

std::vector<RefinedPlace> read_refined(std::vector<SceneSection>& sections, const Scene& scene) {
    std::vector<RefinedPlace> places;
    for (SceneSection& s : sections) {
        if (!scene.hull || scene.motion.kind != Motion::Kind::stream)
            s.fail("around", "finer places are for a hull in a stream so far; remove [[refine]]");
        RefinedPlace place;
        place.name = s.identifier("name", fmt::format("refine{}", places.size() + 1));
        const double near_hull = scene.resolution.near_hull / scene.resolution.scale;
        const double size = s.number("spacing").value_or(near_hull);
        place.halvings_short = static_cast<int>(std::floor(std::log2(size / near_hull) + 1e-9));
        if (place.halvings_short < -most_sizes_below)
            s.fail("spacing", fmt::format("{} times finer than near_hull = {:.6g} m; expected at most {} times",
                                          1 << -place.halvings_short, near_hull, 1 << most_sizes_below));
        if (place.halvings_short < 0 && scene.hull->free)
            s.fail("spacing", fmt::format("finer than near_hull = {:.6g} m beside a hull that moves; expected at "
                                          "least that",
                                          near_hull));
        place.boxes = boxes_of(s, place, scene, std::ldexp(scene.resolution.near_hull, place.halvings_short));
        const Box& domain = scene.domain.box;
        if (std::ranges::all_of(place.boxes, [&](const Box& box) {
                return ((box.max - domain.min).array() <= 0).any() || ((domain.max - box.min).array() <= 0).any();
            }))
            s.fail("min", fmt::format("outside the domain, which spans ({:.6g}, {:.6g}, {:.6g}) to ({:.6g}, {:.6g}, "
                                      "{:.6g}) m",
                                      domain.min.x(), domain.min.y(), domain.min.z(), domain.max.x(), domain.max.y(),
                                      domain.max.z()));
        places.push_back(place);
        s.finish();
    }
    return places;
}

}  // namespace tw
