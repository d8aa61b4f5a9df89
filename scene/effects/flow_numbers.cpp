#include "scene/effects/flow_numbers.h"

#include <fmt/format.h>

#include <algorithm>

#include "meshes/below_water.h"
#include "scene/water/dry_floor.h"
#include "scene/water/water_blocks.h"
#include "text/plain_number.h"

namespace tw {
namespace {

/// Area below still water that the stream along x can rub on [m2]: each triangle's wet part, less as it faces the
/// stream.
double friction_area(const Surface& surface) {
    double total = 0;
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
        const Vec3 twice = surface.area_vector2(static_cast<int>(t));
        const double area = 0.5 * twice.norm();
        if (area == 0) continue;
        const double normal_x = twice.x() / twice.norm();
        total +=
            share_below_water(surface, static_cast<int>(t)) * area * std::sqrt(std::max(0.0, 1 - normal_x * normal_x));
    }
    return total;
}

/// Length, speed and wetted area that the dimensionless numbers are made of.
struct Scales {
    double length, speed, wetted_area;
};

Scales scales_of(const Scene& scene) {
    const double fall = std::sqrt(2 * scene.water.gravity * water_height(scene));
    const double speed = scene.motion.kind == Motion::Kind::stream ? scene.motion.speed : fall;
    if (!scene.hull) return {water_height(scene), speed, 0};
    return {std::max(scene.hull->still.wet_bounds.size().x(), 1e-9), speed, friction_area(scene.hull->surface)};
}

}  // namespace

FlowNumbers flow_numbers(const Scene& scene) {
    const Scales scales = scales_of(scene);
    const Water& w = scene.water;
    FlowNumbers n{scales.length, scales.speed, scales.wetted_area, 0.5 * w.density * scales.speed * scales.speed};
    const double inertia = w.density * n.speed * n.speed;
    if (w.kinematic_viscosity > 0) n.reynolds = n.speed * n.length / w.kinematic_viscosity;
    if (w.surface_tension > 0) {
        n.weber = inertia * n.length / w.surface_tension;
        n.weber_dp = inertia * scene.resolution.near_hull / w.surface_tension;
        n.bond = w.density * w.gravity * n.length * n.length / w.surface_tension;
    }
    n.froude = n.speed / std::sqrt(w.gravity * n.length);
    n.mach = n.speed / scene.sph.c0;
    if (scene.motion.kind != Motion::Kind::stream) n.released = released_height(scene);
    if (n.released > 0) n.dry_floor = dry_floor(scene);
    const double depth = scene.hull ? scene.hull->draft : water_height(scene);
    n.cavitation = (w.atmospheric_pressure + w.density * w.gravity * std::max(0.0, depth) - w.vapour_pressure) / n.head;
    return n;
}

double ittc57(double reynolds) {
    if (reynolds <= 1e4) return 0;
    const double l = std::log10(reynolds) - 2;
    return 0.075 / (l * l);
}

std::string reynolds_text(const FlowNumbers& n) {
    return std::isfinite(n.reynolds) ? fmt::format("Re = {:.3g}", n.reynolds) : "the water has no viscosity";
}

std::string per_cent(double share) { return plain_number(100 * share, 2) + " %"; }

}  // namespace tw
