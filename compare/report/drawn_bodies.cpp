#include "compare/report/drawn_bodies.h"

#include <algorithm>

#include "record/record_numbers.h"
#include "compare/report/view3d_mesh.h"
#include "meshes/section.h"
#include "record/hull_motion.h"
#include "record/raster_grid.h"

namespace tw {
namespace {

bool is_known(const RunRecord& record, const BodyShape& body) {
    return !body.surface.triangles.empty() && body_pose(record, body, 0).has_value();
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

}  // namespace tw
