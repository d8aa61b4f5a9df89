#include "scene/mesh/mesh_cells.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <iterator>
#include <set>

#include "base/errors.h"
#include "meshes/mass_properties.h"
#include "scene/mesh/edge_refinement.h"
#include "scene/mesh/mesh_motion.h"
#include "scene/refined_places.h"

namespace tw {
namespace {

constexpr double transition_cells = 1.05;  // layers between levels and hull edges, less the hull's inside
// Cells halved along the outline of a section, for each length near_hull of it: 13 to 17 of dropped wedges, an entering
// cylinder and a floating box.
constexpr double cells_per_cell_of_outline = 15;
// One halving along the chine and transom of half a prism, meshes of 6 to 33 thousand cells: 68, 89 and 65 further
// cells for each cell's length of edge.
constexpr double cells_per_shedding_cell = 75;

double cell_at(const Scene& scene, int level) { return std::ldexp(background_cell(scene), -level); }

/// A box with what snappyHexMesh puts between it and the background: layers of each size.
void add_graded(RefinementBox box, const Scene& scene, std::vector<RefinementBox>& boxes) {
    for (boxes.push_back(box); --box.level > 0; boxes.push_back(box)) {
        const double layers = cells_between_levels * cell_at(scene, box.level);
        box.box.min -= Vec3::Constant(layers);
        box.box.max += Vec3::Constant(layers);
    }
}

/// By how much a piece of an axis has fewer cells, because they grow in zones, as a length in cells that do not [m].
double saved_by_zones(const std::vector<ForcingZone>& zones, double cell, int axis, double low, double high) {
    double saved = 0;
    for (const ForcingZone& zone : zones) {
        if (zone.axis != axis) continue;
        const double way = zone.high ? 1 : -1, width = std::abs(zone.end - zone.begin);
        const auto into = [&](double place) { return std::clamp(way * (place - zone.begin), 0.0, width); };
        const double from = std::min(into(low), into(high)), to = std::max(into(low), into(high));
        saved += to - from - cell * (cells_along_zone(to, cell) - cells_along_zone(from, cell));
    }
    return saved;
}

/// Nested boxes: every piece of space counts at the finest level that covers it.
double cells_in_boxes(const Scene& scene, const std::vector<RefinementBox>& boxes) {
    std::array<std::set<double>, 3> cuts;
    const Box& domain = scene.domain.box;
    for (int a = 0; a < 3; ++a) {
        auto& c = cuts[static_cast<std::size_t>(a)];
        c = {domain.min[a], domain.max[a]};
        for (const RefinementBox& r : boxes)
            for (const double face : {r.box.min[a], r.box.max[a]})
                c.insert(std::clamp(face, domain.min[a], domain.max[a]));
    }
    const std::vector<ForcingZone> zones = grown_zones(scene);
    const auto between = [&](int axis, double low, double high) {
        return high - low - saved_by_zones(zones, background_cell(scene), axis, low, high);
    };
    double cells = 0;
    const auto each = [](const std::set<double>& c, auto&& use) {
        for (auto low = c.begin(); std::next(low) != c.end(); ++low) use(*low, *std::next(low));
    };
    each(cuts[0], [&](double x0, double x1) {
        each(cuts[1], [&](double y0, double y1) {
            each(cuts[2], [&](double z0, double z1) {
                const Vec3 middle(0.5 * (x0 + x1), 0.5 * (y0 + y1), 0.5 * (z0 + z1));
                int level = 0;
                for (const RefinementBox& r : boxes)
                    if (r.box.contains(middle)) level = std::max(level, r.level);
                const double volume = between(0, x0, x1) * between(1, y0, y1) * (z1 - z0);
                const double edge = cell_at(scene, level);
                cells += volume / (scene.domain.dimensions == 2 ? edge * edge * (domain.max.y() - domain.min.y())
                                                                : edge * edge * edge);
            });
        });
    });
    return cells * (scene.refinement.empty() ? 1 : transition_cells);
}

}  // namespace

double background_cell(const Scene& scene) {
    const bool uniform =
        scene.domain.dimensions == 2 || (!scene.hull && scene.bodies.empty() && scene.refinement.empty());
    return uniform ? scene.resolution.near_hull : scene.resolution.spacing;
}

int finest_halvings(const Scene& scene) {
    const double ratio = background_cell(scene) / scene.resolution.near_hull;
    return ratio > 1 ? static_cast<int>(std::lround(std::log2(ratio))) : 0;
}

double finest_cell(const Scene& scene) {
    const bool section = scene.domain.dimensions == 2 && (scene.hull || !scene.bodies.empty());
    return std::ldexp(finest_spacing(scene), section ? -section_levels : 0);
}

std::vector<ForcingZone> grown_zones(const Scene& scene) {
    if (scene.motion.kind != Motion::Kind::stream) return {};
    std::vector<ForcingZone> zones = forcing_zones(scene).zones;
    std::erase_if(zones, [](const ForcingZone& zone) { return zone.makes_wave; });
    return zones;
}

double cells_along_zone(double width, double cell) {
    return std::log1p((growth_in_zones - 1) * width / cell) / std::log(growth_in_zones);
}

std::vector<RefinementBox> boxes_round_bodies(const Scene& scene) {
    std::vector<RefinementBox> boxes;
    const int level = finest_halvings(scene);
    if (scene.domain.dimensions == 2 || level == 0) return boxes;
    for (const MovingBody& body : scene.bodies) {
        RefinementBox near{body.name, body.surface.bounds(), level};
        const Vec3 size = near.box.size();
        const double width = std::min(size.x(), size.y());
        near.box.min -= Vec3::Constant(width);
        near.box.max += Vec3(width, width, 2.5 * width);
        boxes.push_back(near);
    }
    return boxes;
}

/// What is halved along the outlines of hull and bodies in two dimensions, less what is in them.
double cells_along_sections(const Scene& scene) {
    if (scene.domain.dimensions != 2) return 0;
    const double dp = scene.resolution.near_hull;
    double cells = 0;
    const auto add = [&](const Surface& surface) {
        double sides = 0;
        for (int t = 0; t < static_cast<int>(surface.triangles.size()); ++t) {
            const Vec3 part =
                (surface.corner(t, 1) - surface.corner(t, 0)).cross(surface.corner(t, 2) - surface.corner(t, 0)) / 2;
            if (std::abs(part.y()) < 0.5 * part.norm()) sides += part.norm();
        }
        const double span = surface.bounds().size().y();
        if (!(span > 0)) return;
        const double area = mass_properties(surface).volume / span;
        cells += std::max(0.0, cells_per_cell_of_outline * sides / span / dp - area / (dp * dp));
    };
    if (scene.hull) add(scene.hull->surface);
    for (const MovingBody& body : scene.bodies) add(body.surface);
    return cells;
}

/// Of a mesh that comes down with its body: air above the tank's top for that way, in cells that grow to four times
/// their size (foam_cases/plan_case.cpp).
double cells_for_the_way_down(const Scene& scene) {
    if (scene.bodies.size() != 1) return 0;
    MeshMotion motion;
    try {
        motion = mesh_motion(scene);
    } catch (const InputError&) { return 0; }  // the mesh method refuses the scene
    const double cell = background_cell(scene),
                 below = scene.bodies.front().surface.bounds().min.z() - scene.domain.box.min.z(),
                 more = std::min(motion.down, below);
    if (!motion.whole_mesh() || more < cell) return 0;
    const double growth = std::clamp(more / cell, 1.0, 4.0), mean = growth > 1.01 ? (growth - 1) / std::log(growth) : 1;
    const Vec3 size = scene.domain.box.size();
    return more / (mean * cell) * size.x() / cell * (scene.domain.dimensions == 2 ? 1 : size.y() / cell);
}

double predicted_cells(const Scene& scene) {
    std::vector<RefinementBox> boxes = scene.refinement;
    for (const RefinementBox& near : boxes_round_bodies(scene)) add_graded(near, scene, boxes);
    const EdgeRefinement shedding = edge_refinement(scene);
    return cells_in_boxes(scene, boxes) + cells_along_sections(scene) + cells_for_the_way_down(scene) +
           shedding.halvings * cells_per_shedding_cell * length_of(shedding.edges) / scene.resolution.near_hull;
}

}  // namespace tw
