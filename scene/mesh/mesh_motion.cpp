#include "scene/mesh/mesh_motion.h"

#include <Eigen/Geometry>

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>
#include <numbers>

#include "base/errors.h"
#include "base/gap.h"
#include "meshes/query.h"
#include "scene/solids/walls_met.h"

namespace tw {
namespace {

/// Buoyancy of the body, by how far it has come down from where it starts: `count` places `step` apart from `from` on.
struct Buoyancy {
    double from = 0, step = 1;
    std::vector<double> force;  ///< [N], of a section per metre of span

    double at(double lowered) const {
        const double place = std::clamp((lowered - from) / step, 0.0, static_cast<double>(force.size()) - 1.001);
        const auto k = static_cast<std::size_t>(place);
        return force[k] + (place - static_cast<double>(k)) * (force[k + 1] - force[k]);
    }
};

Buoyancy buoyancy_of(const MovingBody& body, const Water& water) {
    const Box box = body.surface.bounds();
    constexpr int count = 60;
    Buoyancy b;
    b.from = std::min(0.0, box.min.z());  // lowered by less it is dry, by more than the highest point it is drowned
    b.step = std::max(box.max.z() - b.from, 1e-9) / (count - 1);
    for (int k = 0; k < count; ++k) {
        Surface lowered = body.surface;
        for (Vec3& p : lowered.points) p.z() -= b.from + k * b.step;
        b.force.push_back(water.density * water.gravity * hydrostatics(lowered).volume);
    }
    return b;
}

/// The way that a free body takes up and down under its weight and its buoyancy alone: water takes energy from it and
/// gives none, so that it does not go farther.
void fall_freely(const MovingBody& body, const Scene& scene, MeshMotion& m) {
    const Buoyancy buoyancy = buoyancy_of(body, scene.water);
    const double mass = body.motion.mass.mass, g = scene.water.gravity, T = scene.run.duration;
    constexpr int steps = 20000;
    double lowered = 0, speed = -body.motion.velocity.z();
    const double dt = T / steps;
    for (int i = 0; i < steps; ++i) {
        speed += dt * (g - buoyancy.at(lowered) / mass);
        lowered += dt * speed;
        m.down = std::max(m.down, lowered);
        m.up = std::max(m.up, -lowered);
    }
}

double reach_of(const MovingBody& body, bool flat) {
    double reach = 0;
    for (const Vec3& p : body.surface.points) {
        Vec3 arm = p - body.motion.mass.centre;
        if (flat) arm.y() = 0;
        reach = std::max(reach, arm.norm());
    }
    return reach;
}

void bound_travel(const MovingBody& body, const Scene& scene, MeshMotion& m) {
    const double T = scene.run.duration, reach = reach_of(body, scene.domain.dimensions == 2);
    if (body.motion.law) {
        const MotionLaw& law = *body.motion.law;
        for (int i = 0; i <= 2000; ++i) {
            const double path = law.at(T * i / 2000).path;
            if (law.turns) {
                m.aside = std::max(m.aside, std::min(std::abs(path), 2.0) * reach);
            } else {
                m.down = std::max(m.down, -path * law.axis.z());
                m.up = std::max(m.up, path * law.axis.z());
                m.aside = std::max(m.aside, std::abs(path) * law.axis.head<2>().norm());
            }
        }
        return;
    }
    if (body.motion.free.along[2]) fall_freely(body, scene, m);
    m.aside = body.motion.velocity.head<2>().norm() * T + std::min(body.motion.spin.norm() * T, 2.0) * reach;
    if (scene.motion.kind == Motion::Kind::stream && body.motion.free.along[0]) m.aside += scene.motion.speed * T;
}

/// Up and down only: the mesh slides along the tank's vertical sides.
bool moves_vertically(const MovingBody& body) {
    if (const auto& law = body.motion.law) return !law->turns && law->axis.head<2>().norm() < 1e-12;
    const DegreesOfFreedom& f = body.motion.free;
    return !f.along[0] && !f.along[1] && !f.about[0] && !f.about[1] && !f.about[2];
}

/// A solid whose distances to others are asked for. Its tree is built when it is needed: of many solids few come near
/// another.
class Solid {
public:
    explicit Solid(const Surface& surface) : surface_(surface), bounds_(surface.bounds()) {}
    const Surface& surface() const { return surface_; }
    const Box& bounds() const { return bounds_; }
    const SurfaceQuery& query() const {
        if (!query_) query_ = std::make_unique<SurfaceQuery>(surface_);
        return *query_;
    }

private:
    const Surface& surface_;
    Box bounds_;
    mutable std::unique_ptr<SurfaceQuery> query_;
};

/// From the corners of either surface to the other one [m]; infinite where their boxes are `most` or more apart.
double gap_between(const Solid& a, const Solid& b, double most) {
    double nearest = HUGE_VAL;
    if (gap_of_boxes(a.bounds(), b.bounds()) >= most) return nearest;
    const auto look = [&](const Solid& from, const Solid& to) {
        for (const Vec3& p : from.surface().points) nearest = std::min(nearest, to.query().nearest(p).distance);
    };
    look(a, b);
    look(b, a);
    return nearest;
}

/// Distance from the body to what stays where it is while the mesh is morphed: floor, top, obstacles, inlet and outlet,
/// and, unless the body moves along them, the sides [m].
double clearance_of(const MovingBody& body, const Solid& solid, const std::vector<Solid>& at_rest, const Scene& scene) {
    const Box &at = solid.bounds(), &box = scene.domain.box;
    double nearest = std::min(at.min.z() - box.min.z(), box.max.z() - at.max.z());
    const bool along_walls = moves_vertically(body);
    if (!along_walls || scene.motion.kind == Motion::Kind::stream)
        nearest = std::min({nearest, at.min.x() - box.min.x(), box.max.x() - at.max.x()});
    if (!along_walls && scene.domain.dimensions == 3) {
        nearest = std::min(nearest, box.max.y() - at.max.y());
        if (scene.domain.y_min != Side::symmetry) nearest = std::min(nearest, at.min.y() - box.min.y());
    }
    for (const Solid& other : at_rest) nearest = std::min(nearest, gap_between(solid, other, nearest));
    return nearest;
}

/// Obstacles, and the hull unless it is free.
std::vector<Solid> solids_at_rest(const Scene& scene) {
    std::vector<Solid> solids;
    for (const Obstacle& o : scene.obstacles) solids.emplace_back(o.surface);
    if (scene.hull && !scene.hull->free) solids.emplace_back(scene.hull->surface);
    return solids;
}

[[noreturn]] void refuse(const Scene& scene, const std::string& key, const std::string& why) {
    throw InputError(fmt::format("{}: {}", scene.place_of(key), why));
}

}  // namespace

double MeshMotion::follows_by(double share) const {
    return outer - (outer - inner) * std::acos(1 - 2 * share) / std::numbers::pi;
}

std::string MeshMotion::sentence() const {
    switch (kind) {
        case MeshMotion::Kind::none: return {};
        case MeshMotion::Kind::morphing:
            return fmt::format(
                "the mesh is morphed between the body and the walls, which stay where they are; the body "
                "may move by {:.3g} m; gauges nearer to it than {:.2g} m and a cell or two double the time of a step, "
                "since their cells are sought anew",
                stretch(), follows_by(0.02));
        case MeshMotion::Kind::sliding:
            return "the whole mesh moves up and down with the body, along the tank's sides: there is no floor, the "
                   "water "
                   "below the body stays as deep as it was at the start";
        case MeshMotion::Kind::open_water: break;
    }
    return "the whole mesh moves and turns with the body: there are no walls and no floor, all sides are open to water "
           "at rest";
}

std::vector<MovingBody> followed_by_mesh(const Scene& scene) {
    if (scene.hull_is_free())
        return {MovingBody{
            .name = "hull",
            .source = scene.hull->source,
            .surface = scene.hull->surface,
            .motion = scene.hull->free->motion,
            .findings = {},
        }};
    return scene.bodies;
}

namespace {

/// What the mesh method cannot move however the mesh follows.
void check_body(const MovingBody& body, const Scene& scene) {
    if (body.tyre())
        refuse(scene, "run.methods",
               fmt::format(
                   "body {} is a tyre that is pressed on the floor, which the mesh method does not solve; expected "
                   "methods = [\"sph\"], or --method sph",
                   body.name));
    if (body.elastic && body.motion.law)
        refuse(scene, "run.methods",
               fmt::format("body {} is held at its edges and bends, which the mesh method does not solve; expected "
                           "methods = [\"sph\"], or --method sph",
                           body.name));
    for (const MetWall& wall : walls_touched(body, scene))
        refuse(
            scene, "run.methods",
            fmt::format("body {} stands on {} of the tank: the mesh method has no contact between a body and a wall, "
                        "and its mesh can neither open nor close the gap between them; expected methods = [\"sph\"], "
                        "--method sph, or a body that starts more than four cells ({:.3g} m) clear of the wall",
                        body.name, wall.name, 4 * scene.resolution.near_hull));
    const DegreesOfFreedom& f = body.motion.free;
    if (!body.motion.law && f.about[0] + f.about[1] + f.about[2] == 2)
        refuse(scene, "run.methods",
               fmt::format("body {} is free to turn about two of the three axes, which OpenFOAM has no constraint for; "
                           "lock one more of roll, pitch and yaw, or free the third",
                           body.name));
}

/// A mesh that turns with the body has sides that are open to water at rest and a top that is open to air. Where its
/// floor comes out of the water, or its top goes under, water leaves through the one and air comes in through the
/// other: the volume fraction leaves its range from there on (decision 032).
void check_turn(const MovingBody& body, const Scene& scene) {
    const auto& law = body.motion.law;
    if (!law || !law->turns) return;
    constexpr int moments = 2000;
    const Box& box = scene.domain.box;
    for (int i = 0; i <= moments; ++i) {
        const double t = scene.run.duration * i / moments, path = law->at(t).path;
        const Eigen::AngleAxisd turn(path, law->axis);
        for (int corner = 0; corner < 8; ++corner) {
            const auto of = [&](int a) { return (corner >> a & 1) ? box.max[a] : box.min[a]; };
            const Vec3 &centre = body.motion.mass.centre, at = centre + turn * (Vec3(of(0), of(1), of(2)) - centre);
            const bool top = corner >> 2;
            if (top ? at.z() > 0 : at.z() < 0) continue;
            refuse(scene,
                   scene.places.contains("run.methods") ? "run.methods"
                   : top                                ? "tank.max"
                                                        : "tank.min",
                   fmt::format("body {} turns the whole mesh with it, and at t = {:.3g} s, turned by {:.3g} deg, a "
                               "corner of the mesh's {} still water: the mesh method does not solve such turns; "
                               "expected methods = [\"sph\"], --method sph, a smaller turn, or a shorter duration",
                               body.name, t, std::abs(path) * 180 / std::numbers::pi,
                               top ? "top goes below" : "floor comes above"));
        }
    }
}

/// Several free bodies: morphed regions that do not overlap, alike round all of them.
MeshMotion motion_of_several(const std::vector<MovingBody>& bodies, const Scene& scene) {
    MeshMotion m;
    m.kind = MeshMotion::Kind::morphing;
    double room = HUGE_VAL, way = 0;
    std::string tightest, between, farthest;
    const auto limit = [&](double to, const std::string& name, const std::string& what) {
        if (to < room) room = to, tightest = name, between = what;
    };
    const std::vector<Solid> at_rest = solids_at_rest(scene);
    std::vector<Solid> solids;
    for (const MovingBody& body : bodies) {
        const Solid& solid = solids.emplace_back(body.surface);
        if (body.motion.law)
            refuse(scene, "run.methods",
                   fmt::format("body {} has a prescribed motion beside another body, and the mesh method moves several "
                               "bodies only where all are free; expected motion = \"free\", one body, or methods = "
                               "[\"sph\"]",
                               body.name));
        MeshMotion own;
        bound_travel(body, scene, own);
        const double most = std::hypot(std::max(own.down, own.up), own.aside);
        if (most >= way) way = most, farthest = body.name;
        limit(clearance_of(body, solid, at_rest, scene), body.name, "what stays where it is");
        for (std::size_t j = 0; j + 1 < solids.size(); ++j)
            if (const double gap = gap_between(solid, solids[j], 2 * room); gap < 2 * room)
                limit(gap / 2, body.name, "the middle between it and body " + bodies[j].name);
    }
    m.outer = 0.98 * room;
    m.inner = 0.05 * m.outer;
    if (scene.fvm.body_mesh == "whole")
        refuse(scene, "fvm.body_mesh",
               "a mesh that moves as a whole follows one body, and there are several; expected \"morphing\"");
    if (!(m.outer > 4 * scene.resolution.near_hull))
        refuse(
            scene, "run.methods",
            fmt::format("body {} stands {:.3g} m from {}; a mesh is morphed over four cells ({:.3g} m) or more: move "
                        "the bodies apart, make the cells smaller, or expected methods = [\"sph\"]",
                        tightest, room, between, 4 * scene.resolution.near_hull));
    if (scene.fvm.body_mesh == "auto" && way > 0.5 * (m.outer - m.inner))
        refuse(scene, "run.methods",
               fmt::format(
                   "body {} may move by {:.3g} m, and round several bodies the mesh is morphed, here within {:.3g} "
                   "m of each, which tolerates half of that; move bodies and walls apart, shorten the run, expected "
                   "methods = [\"sph\"], or body_mesh = \"morphing\", whose run is stopped where a body comes "
                   "too far",
                   farthest, way, m.outer));
    return m;
}

}  // namespace

MeshMotion mesh_motion(const Scene& scene) {
    MeshMotion m;
    const std::vector<MovingBody> followed = followed_by_mesh(scene);
    for (const MovingBody& body : followed) check_body(body, scene);
    if (followed.empty()) return m;
    const bool free_hull = scene.hull_is_free(), stream = scene.motion.kind == Motion::Kind::stream;
    if (scene.fvm.captures_geometrically())
        refuse(scene, "fvm.interface",
               fmt::format("body {} moves, and interIsoFoam is used with meshes at rest alone; expected \"mules\"",
                           followed.front().name));
    if (scene.tank_motion)
        refuse(scene, "run.methods",
               fmt::format("body {} moves in a tank that moves, and OpenFOAM's force of such a tank acts on the water "
                           "alone; expected methods = [\"sph\"], or --method sph",
                           followed.front().name));
    if (free_hull && !scene.bodies.empty())
        refuse(scene, "run.methods",
               fmt::format("body {} moves beside a hull that is free, and the mesh of a stream follows one of them; "
                           "expected methods = [\"sph\"], or --method sph",
                           scene.bodies.front().name));
    if (followed.size() > 1) return motion_of_several(followed, scene);
    const MovingBody& body = followed.front();
    if (!free_hull) bound_travel(body, scene, m);  // what a stream makes of a hull is what the run is for
    const double clearance = clearance_of(body, Solid(body.surface), solids_at_rest(scene), scene);
    m.outer = 0.98 * clearance;
    m.inner = 0.05 * m.outer;
    const std::string& asked = scene.fvm.body_mesh;
    const double way = std::hypot(std::max(m.down, m.up), m.aside);
    const bool room = m.outer > 4 * scene.resolution.near_hull;
    if (stream && asked == "whole")
        refuse(scene, "fvm.body_mesh",
               "a mesh that moves as a whole would take the inlet with it; expected \"morphing\"");
    if (stream && !free_hull && asked == "auto" && way > 0.5 * (m.outer - m.inner))
        refuse(scene, "run.methods",
               fmt::format(
                   "body {} may move by {:.3g} m in the stream, and the mesh is morphed within {:.3g} m of it, "
                   "which tolerates half of that; shorten the run, lock its surge, expected methods = [\"sph\"], or "
                   "body_mesh = \"morphing\", whose run is stopped where the body comes too far",
                   body.name, way, m.outer));
    if (stream || asked == "morphing" || (asked == "auto" && room && way <= 0.5 * (m.outer - m.inner))) {
        if (!room)
            refuse(scene, "fvm.body_mesh",
                   fmt::format("body {} stands {:.3g} m from what stays where it is; a mesh is morphed over four cells "
                               "({:.3g} m) or more",
                               body.name, clearance, 4 * scene.resolution.near_hull));
        m.kind = MeshMotion::Kind::morphing;
        return m;
    }
    m.kind = moves_vertically(body) ? MeshMotion::Kind::sliding : MeshMotion::Kind::open_water;
    if (!scene.obstacles.empty() || !scene.water_blocks.empty())
        refuse(scene, "fvm.body_mesh",
               fmt::format("body {} may move by {:.3g} m, more than half of the {:.3g} m to the nearest wall, so the "
                           "whole mesh has to move with it, and {}; expected methods = [\"sph\"], or body_mesh = "
                           "\"morphing\", whose run is stopped where the body comes too far",
                           body.name, way, clearance,
                           scene.obstacles.empty() ? "blocks of water cannot: it is open to water at rest"
                                                   : "the obstacle " + scene.obstacles.front().name + " with it"));
    check_turn(body, scene);
    return m;
}

}  // namespace tw
