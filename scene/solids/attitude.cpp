#include "scene/solids/attitude.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "meshes/below_water.h"
#include "meshes/check/narrow_faces.h"

namespace tw {
namespace {

using Level = Finding::Level;

/// Area of the surface where the unit normal passes a test, and of its part under still water [m2].
struct Area {
    double all = 0, wet = 0;
    Vec3 lowest = Vec3::Zero();  ///< corner
};
template <class Passes>
Area area_of(const Surface& surface, Passes passes) {
    Area area;
    for (int t = 0; t < static_cast<int>(surface.triangles.size()); ++t) {
        const Vec3 twice = surface.area_vector2(t);
        const double norm = twice.norm();
        if (norm == 0 || !passes(Vec3(twice / norm))) continue;
        area.all += 0.5 * norm;
        area.wet += 0.5 * norm * share_below_water(surface, t);
        for (int k = 0; k < 3; ++k)
            if (surface.corner(t, k).z() < area.lowest.z()) area.lowest = surface.corner(t, k);
    }
    return area;
}

/// The narrowest riser of a step, flat of a chine or rail of the bottom, up to where a planing hull wets its sides, where it
/// is finer than the size at the hull.
std::optional<Finding> narrow_part_of(const Scene& scene) {
    const Hull& hull = *scene.hull;
    if (hull.section) return {};
    const double size = scene.resolution.near_hull;
    Box wet = hull.surface.bounds();
    wet.max.z() = std::min(wet.max.z(), 0.5 * hull.draft);
    const std::vector<NarrowFace> narrow = narrow_faces(hull.surface, wet, size * (1 - 1e-9));
    if (narrow.empty()) return {};
    const NarrowFace& n = narrow.front();
    return Finding{
        Level::warning, "narrow_part",
        fmt::format("a step, chine or rail near ({:.4g}, {:.4g}, {:.4g}) m is {:.3g} m wide, {:.2g} spacings of "
                    "near_hull = {:.3g} m{}: it is hardly resolved; [resolution] near_hull = {:.2g} m would "
                    "resolve it by three, or a [[refine]] box round it",
                    n.middle.x(), n.middle.y(), n.middle.z(), n.width, n.width / size, size,
                    narrow.size() > 1 ? fmt::format(" (the narrowest of {})", narrow.size()) : "", n.width / 3),
        n.middle};
}

}  // namespace

std::vector<Finding> check_attitude(const Scene& scene) {
    const Hull& hull = *scene.hull;
    const double particle_spacing = scene.resolution.near_hull;
    std::vector<Finding> findings;
    const Surface& surface = hull.surface;
    const Box bounds = surface.bounds();
    const Area deck = area_of(surface, [](const Vec3& n) { return n.z() > 0.7; });
    if (bounds.max.z() <= 0) {
        findings.push_back(
            {Level::warning, "submerged",
             fmt::format(
                 "the whole hull lies under water, its highest point {:.3g} m below the surface; "
                 "reduce draft unless this is meant. Without friction its drag is nearly zero: what a run gives is "
                 "mostly the resolution's",
                 -bounds.max.z()),
             bounds.max});
    } else if (deck.wet > 0.05 * deck.all) {
        findings.push_back({Level::warning, "swamped",
                            fmt::format("{:.0f} % of the deck (surfaces that face up) lies under still water, down to "
                                        "{:.3g} m near ({:.4g}, {:.4g}, {:.4g}) m; reduce draft or trim unless this is "
                                        "meant",
                                        100 * deck.wet / deck.all, -deck.lowest.z(), deck.lowest.x(), deck.lowest.y(),
                                        deck.lowest.z()),
                            deck.lowest});
    }
    const Vec3 wet = hull.still.wet_bounds.size();
    for (int axis = 0; axis < 3; ++axis) {
        if (wet[axis] >= particle_spacing || (axis == 1 && hull.section)) continue;
        static constexpr const char* sizes[] = {"long", "wide", "deep"};
        findings.push_back(
            {Level::warning, "barely_wet",
             fmt::format("the part under still water is only {:.3g} m {}, less than one particle spacing "
                         "of {:.3g} m, so the particles hardly resolve it; increase draft or refine "
                         "[resolution] near_hull",
                         wet[axis], sizes[axis], particle_spacing),
             hull.still.wet_bounds.min});
        break;
    }
    if (const auto narrow = narrow_part_of(scene)) findings.push_back(*narrow);
    if (scene.motion.kind != Motion::Kind::stream) return findings;
    // A transom is flat and faces the stern, above the water too; a bow is sharp or round.
    const Area ahead = area_of(surface, [](const Vec3& n) { return n.x() < -0.95; });
    const Area astern = area_of(surface, [](const Vec3& n) { return n.x() > 0.95; });
    const double section = bounds.size().y() * bounds.size().z(), wet_section = wet.y() * wet.z();
    if ((ahead.wet > 0.3 * wet_section && ahead.wet > 3 * astern.wet) ||
        (ahead.all > 0.3 * section && ahead.all > 3 * astern.all))
        findings.push_back(
            {Level::warning, "stern_first",
             fmt::format(
                 "{:.3g} m2 of flat surface face the stream and {:.3g} m2 face away from it ({:.3g} and {:.3g} m2 "
                 "of them below still water): the hull may lie with its stern to the stream, which runs along "
                 "+x; turn it with axes, e.g. \"-x-yz\"",
                 ahead.all, astern.all, ahead.wet, astern.wet),
             ahead.lowest});
    return findings;
}

}  // namespace tw
