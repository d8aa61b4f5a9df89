#include "scene/water/quiet_layer.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "meshes/mass_properties.h"
#include "scene/refined_places.h"
#include "scene/water/water_blocks.h"

namespace tw {
namespace {

double surface_of(const Scene& scene) { return scene.water_blocks.empty() ? 0 : scene.water_blocks.front().max.z(); }

/// Of all solids [m]; nothing where there is none.
double highest_solid(const Scene& scene) {
    double top = -HUGE_VAL;
    for (const Obstacle& o : scene.obstacles) top = std::max(top, o.surface.bounds().max.z());
    for (const MovingBody& b : scene.bodies) top = std::max(top, b.surface.bounds().max.z());
    return top;
}

bool fills_the_tank(const Scene& scene) {
    if (scene.water_blocks.empty()) return true;
    if (scene.water_blocks.size() > 1) return false;
    const Box &water = scene.water_blocks.front(), &tank = scene.domain.box;
    const double slack = 1e-6 * tank.size().maxCoeff();
    for (int a = 0; a < 3; ++a) {
        if (a == 1 && scene.domain.dimensions == 2) continue;
        if (water.min[a] > tank.min[a] + slack || (a < 2 && water.max[a] < tank.max[a] - slack)) return false;
    }
    return true;
}

/// Whether a solid touches or goes through a face of the box, so that no water is there for Archimedes' force.
bool stands_in_a_wall(const Surface& solid, const Scene& scene) {
    const Box at = solid.bounds(), &tank = scene.domain.box;
    for (int a = 0; a < 3; ++a) {
        if (a == 1 && scene.domain.dimensions == 2) continue;
        if (at.min[a] <= tank.min[a] || at.max[a] >= tank.max[a]) return true;
    }
    return false;
}

double smoothing_length(const Scene& scene) { return scene.sph.h_over_dp * scene.resolution.near_hull; }

double thickness(const Scene& scene) {
    const double over = surface_of(scene) - highest_solid(scene);
    return std::max(8 * smoothing_length(scene), std::min(over / 2, water_height(scene) / 8));
}

/// A hull that a slow stream passes deep under water: nothing takes the weight of the water from the particles there.
void warn_of_slow_hull(Scene& scene) {
    if (!scene.hull || scene.motion.kind != Motion::Kind::stream || !(scene.water.gravity > 0)) return;
    Hull& hull = *scene.hull;
    const Box at = hull.surface.bounds();
    if (!(at.max.z() < 0)) return;
    MovingBody as_body{.name = "the hull", .source = {}, .surface = hull.surface, .motion = {}, .findings = {}};
    as_body.motion.law = MotionLaw{.kind = MotionLaw::Kind::constant, .rate = scene.motion.speed};
    const SlowBody s = slow_body(scene, as_body);
    if (s.reynolds > slow_up_to || s.hydrostatic <= 10 * s.dynamic) return;
    hull.findings.push_back(
        {Finding::Level::warning, "slow_body",
         fmt::format("Re = {:.2g}, and {:.2g} Pa of still water over it where the stream makes {:.2g} Pa: its drag is "
                     "not predicted by the particles, because the error of their forces is proportional to the whole "
                     "pressure; [effects] gravity = \"off\" leaves out the weight of the water, which does not act on "
                     "a body deep under water",
                     s.reynolds, s.hydrostatic, s.dynamic),
         at.min});
}

}  // namespace

std::string no_quiet_layer(const Scene& scene) {
    if (scene.motion.kind != Motion::Kind::none || scene.hull || scene.tank_motion)
        return "it is for bodies in a tank at rest, without a hull or a stream";
    if (!(scene.water.gravity > 0)) return "there is no gravity, so no pressure of water at rest";
    if (!fills_the_tank(scene)) return "the water does not fill the tank to one level";
    if (sizes_of_particles(scene) > 1) return "it needs particles of one size; set [sph] levels = 1";
    if (scene.bodies.empty()) return "there is no body that moves";
    for (const MovingBody& b : scene.bodies) {
        if (b.elastic) return fmt::format("body {} is elastic", b.name);
        if (stands_in_a_wall(b.surface, scene)) return fmt::format("body {} touches a wall", b.name);
    }
    for (const Obstacle& o : scene.obstacles)
        if (stands_in_a_wall(o.surface, scene)) return fmt::format("the obstacle {} touches a wall", o.name);
    const double over = surface_of(scene) - highest_solid(scene), needed = 12 * smoothing_length(scene);
    if (over < needed)
        return fmt::format(
            "the water over the highest solid is {:.3g} m deep; expected {:.3g} m, twelve smoothing lengths", over,
            needed);
    return "";
}

QuietLayer quiet_layer(const Scene& scene) {
    const double surface = surface_of(scene), t = thickness(scene);
    return {surface, surface - t / 2, surface - t};
}

namespace {

/// Diameter of the circle or sphere of a volume [m].
double size_of(double volume, bool flat) {
    return flat ? 2 * std::sqrt(volume / std::numbers::pi) : std::cbrt(6 * volume / std::numbers::pi);
}

}  // namespace

BodyDrag drag_of(const Scene& scene, const MovingBody& body) {
    using std::numbers::pi;
    const bool flat = scene.domain.dimensions == 2;
    const double rho = scene.water.density, mu = rho * scene.water.kinematic_viscosity,
                 D = size_of(mass_properties(body.surface).volume, flat);
    return flat ? BodyDrag{4 * pi * mu, rho * D / 2} : BodyDrag{3 * pi * mu * D, 0.4 * pi / 8 * rho * D * D};
}

SlowBody slow_body(const Scene& scene, const MovingBody& body) {
    const bool flat = scene.domain.dimensions == 2;
    const double rho = scene.water.density, mu = rho * scene.water.kinematic_viscosity;
    const MassProperties solid = mass_properties(body.surface);
    const double volume = solid.volume;  // two dimensions: of a metre of span
    SlowBody s;
    s.size = size_of(volume, flat);
    if (body.motion.law) {
        const double arm = (body.surface.bounds().size().norm()) / 2;
        s.speed = body.motion.law->fastest() * (body.motion.law->turns ? arm : 1);
    } else {
        const double pull = std::abs(body.motion.mass.mass - rho * volume) * scene.water.gravity;
        const auto [viscous, inertial] = drag_of(scene, body);
        // inertial U^2 + viscous U = pull, in the form that keeps its digits where one of them is small
        s.speed = pull > 0 ? 2 * pull / (viscous + std::sqrt(viscous * viscous + 4 * inertial * pull)) : 0;
        s.speed = std::max(s.speed, body.motion.velocity.norm());
    }
    s.reynolds = mu > 0 ? rho * s.speed * s.size / mu : HUGE_VAL;
    s.dynamic = rho * s.speed * s.speed + mu * s.speed / s.size;
    s.hydrostatic = rho * scene.water.gravity * std::max(0.0, surface_of(scene) - solid.centroid.z());
    return s;
}

const MovingBody* slowest_in_deep_water(const Scene& scene) {
    const MovingBody* slowest = nullptr;
    double least = slow_up_to;
    for (const MovingBody& body : scene.bodies) {
        if (body.elastic) continue;
        const SlowBody s = slow_body(scene, body);
        if (s.speed > 0 && s.reynolds < least && s.hydrostatic > 10 * s.dynamic) slowest = &body, least = s.reynolds;
    }
    return slowest;
}

double excess_of_drag(const SlowBody& body) { return std::min(1.0, 0.003 * body.hydrostatic / body.dynamic); }

void warn_of_slow_bodies(Scene& scene) {
    if (!scene.effect_on("viscosity")) return;
    warn_of_slow_hull(scene);
    for (MovingBody& body : scene.bodies) {
        if (body.elastic) continue;
        const SlowBody s = slow_body(scene, body);
        if (!(s.speed > 0) || s.reynolds > slow_up_to) continue;
        const auto warn = [&](const std::string& text) {
            body.findings.push_back(
                {Finding::Level::warning, "slow_body",
                 fmt::format("{} moves at about {:.2g} m/s, Re = {:.2g}: {}", body.name, s.speed, s.reynolds, text),
                 body.motion.mass.centre});
        };
        // five in the layer of 1.2 D/sqrt(Re) where the water meets it, as vortex_shedding.h asks for
        const double spacings = std::max(10.0, 5 / 1.2 * std::sqrt(s.reynolds)),
                     across = s.size / scene.resolution.near_hull;
        if (across < 0.95 * spacings)  // facets take a little
            warn(fmt::format(
                "its drag needs ten spacings in its diameter and five in its boundary layer, {:.2g} m or less "
                "(here {:.2g} m)",
                s.size / spacings, scene.resolution.near_hull));
        if (scene.effect_on("dynamic_pressure") || s.hydrostatic <= 10 * s.dynamic) continue;
        const std::string why = no_quiet_layer(scene);
        warn(fmt::format(
            "under {:.2g} Pa of still water the particles will give it a drag about {:.0f} % too large, because "
            "they carry the whole pressure; {}",
            s.hydrostatic, 100 * excess_of_drag(s),
            why.empty() ? "leave [effects] dynamic_pressure at \"auto\""
                        : "[effects] dynamic_pressure would remove this error, but " + why +
                              "; the mesh method does not have this error"));
    }
}

}  // namespace tw
