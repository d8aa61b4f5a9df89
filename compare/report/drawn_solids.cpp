#include "compare/report/drawn_solids.h"

#include <algorithm>
#include <cmath>

#include "compare/report/escape.h"
#include "compare/report/view3d.h"
#include "meshes/query/bvh.h"
#include "meshes/query/predicates.h"
#include "meshes/section.h"
#include "record/hull_motion.h"
#include "record/raster_grid.h"
#include "record/record_numbers.h"

namespace tw {
namespace {

bool is_known(const RunRecord& record, const BodyShape& body) {
    return !body.surface.triangles.empty() && body_pose(record, body, 0).has_value();
}

/// The triangle next to a place among those whose normals are within 90 degrees of `area_vector`; -1: there is none.
int nearest_facing(const Bvh& tree, const Vec3& place, const Vec3& area_vector) {
    int nearest = -1;
    double least = HUGE_VAL;
    tree.visit_nearest(place, least, [&](const Bvh::Corners& t) {
        const double distance2 = (nearest_on_triangle(place, t.a, t.b, t.c).point - place).squaredNorm();
        if (distance2 < least && (t.b - t.a).cross(t.c - t.a).dot(area_vector) > 0)
            least = distance2, nearest = t.triangle;
        return least;
    });
    return nearest;
}

}  // namespace

Surface drawn_body(const RunRecord& record, const BodyShape& body) {
    const RasterGrid grid(record.raster);
    if (number_of(record, "dimensions", 3) != 2 || grid.empty()) return body.surface;
    const double width = 0.2 * grid.nx * grid.spec.voxel;  // as in water_surface
    Surface slab = with_span(body.surface, width);
    for (Vec3& p : slab.points) p.y() += grid.y(0) + width / 2;
    return slab;
}

std::vector<Surface> bodies_at(const RunRecord& record, double time) {
    std::vector<Surface> bodies;
    for (const BodyShape& body : record.bodies)
        if (body.table != hull_motion_table && is_known(record, body))
            if (const auto pose = body_pose(record, body, time)) bodies.push_back((*pose)(drawn_body(record, body)));
    return bodies;
}

bool DrawnSolid::is_body() const { return moves() && motions.front()->table != hull_motion_table; }

std::vector<DrawnSolid> drawn_solids(const Comparison& c, std::size_t most_triangles) {
    std::vector<DrawnSolid> hulls, bodies;
    std::vector<std::string> hull_keys, body_keys;
    const auto add = [&](std::vector<DrawnSolid>& solids, std::vector<std::string>& keys, const std::string& key,
                         std::size_t source, const Surface& surface, const BodyShape* motion) {
        auto same = std::ranges::find(keys, key);
        if (same == keys.end()) {
            Surface light = light_surface(surface, most_triangles);
            if (light.triangles.empty()) return;
            keys.push_back(key);
            solids.push_back({std::move(light), {}, {}});
            same = keys.end() - 1;
        }
        DrawnSolid& solid = solids[static_cast<std::size_t>(same - keys.begin())];
        solid.sources.push_back(source);
        solid.motions.push_back(motion);
    };
    for (std::size_t s = 0; s < c.sources.size(); ++s) {
        const RunRecord& r = c.sources[s];
        bool free_hull = false;
        for (const BodyShape& body : r.bodies) {
            if (!is_known(r, body)) continue;
            const bool is_hull = body.table == hull_motion_table;
            free_hull = free_hull || is_hull;
            add(is_hull ? hulls : bodies, is_hull ? hull_keys : body_keys,
                body.table + " " + surface_hash(body.surface), s, drawn_body(r, body), &body);
        }
        if (!free_hull && !r.hull.triangles.empty())
            add(hulls, hull_keys, "at rest " + text_of(r, "hull_hash"), s, r.hull, nullptr);
    }
    std::ranges::move(bodies, std::back_inserter(hulls));
    return hulls;
}

std::optional<double> wet_pressure(const RunRecord& record, std::size_t triangle) {
    if (triangle >= record.hull_pressure.size() || !std::isfinite(record.hull_pressure[triangle])) return {};
    if (triangle < record.hull_wet.size() && !(record.hull_wet[triangle] > 0.05f)) return {};
    return record.hull_pressure[triangle];
}

std::optional<PressureRange> pressure_range(const Comparison& comparison) {
    std::vector<double> values;
    for (const RunRecord& r : comparison.sources)
        for (std::size_t t = 0; t < r.hull_pressure.size(); ++t)
            if (const auto p = wet_pressure(r, t)) values.push_back(*p);
    if (values.empty()) return {};
    std::ranges::sort(values);
    const std::size_t cut = values.size() / 100;
    PressureRange range{std::min(0.0, values[cut]), values[values.size() - 1 - cut]};
    if (!(range.high > range.low)) range.high = range.low + 1;
    return range;
}

std::string packed_pressures(const RunRecord& record, const Surface& recorded, const Surface& drawn,
                             const PressureRange& range) {
    const Bvh tree(recorded);
    std::string bytes;
    bytes.reserve(drawn.triangles.size());
    for (int t = 0; t < static_cast<int>(drawn.triangles.size()); ++t) {
        const Vec3 middle = (drawn.corner(t, 0) + drawn.corner(t, 1) + drawn.corner(t, 2)) / 3;
        const int nearest = nearest_facing(tree, middle, drawn.area_vector2(t));
        const auto pressure =
            nearest < 0 ? std::optional<double>() : wet_pressure(record, static_cast<std::size_t>(nearest));
        const double share = pressure ? (*pressure - range.low) / (range.high - range.low) : 0;
        bytes += static_cast<char>(pressure ? std::lround(254 * std::clamp(share, 0.0, 1.0)) : 255);
    }
    return base64(bytes);
}

}  // namespace tw
