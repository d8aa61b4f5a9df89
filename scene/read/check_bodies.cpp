#include <Eigen/Geometry>

#include <fmt/format.h>

#include <algorithm>

#include "base/errors.h"
#include "base/gap.h"
#include "meshes/query.h"
#include "methods/names.h"
#include "scene/mesh/mesh_motion.h"
#include "scene/read/check_scene.h"
#include "scene/solids/walls_met.h"

namespace tw {
namespace {

/// Whether two closed surfaces come nearer to each other than `gap` [m], judged at corners and middles of triangles.
bool meet(const Surface& a, const Surface& b, double gap) {
    const auto reaches = [gap](const Surface& from, const Surface& to) {
        const SurfaceQuery query(to);
        const auto within = [&](const Vec3& p) { return query.nearest(p, 2 * gap).distance < gap; };
        if (std::ranges::any_of(from.points, within)) return true;
        for (int t = 0; t < static_cast<int>(from.triangles.size()); ++t) {
            const Vec3 p = from.corner(t, 0), q = from.corner(t, 1), r = from.corner(t, 2);
            if (within((p + q + r) / 3) || within((p + q) / 2) || within((q + r) / 2) || within((r + p) / 2))
                return true;
        }
        return false;
    };
    return reaches(a, b) || reaches(b, a);
}

std::string where_key(const SceneSection& s) {
    return s.has("position") ? "position" : s.has("draft") ? "draft" : "name";
}

void check_domain(const MovingBody& body, const Scene& scene, SceneSection& s) {
    static constexpr const char* axes[] = {"x", "y", "z"};
    const Box at = body.surface.bounds(), &domain = scene.domain.box;
    Box within = domain;
    for (const MetWall& wall : walls_met(body, scene))
        (wall.high ? within.max : within.min)[wall.axis] += (wall.high ? 1 : -1) * touching(scene);
    for (int a = 0; a < 3; ++a) {
        if (a == 1 && scene.domain.dimensions == 2) continue;
        if (at.min[a] > within.min[a] && at.max[a] < within.max[a]) continue;
        s.fail(where_key(s), fmt::format("body {} starts in a wall of the tank or outside it: in {} it spans {:.6g} to "
                                         "{:.6g} m, the tank {:.6g} to {:.6g} m",
                                         body.name, axes[a], at.min[a], at.max[a], domain.min[a], domain.max[a]));
    }
}

/// A prescribed motion is known beforehand, and so is where it leaves the tank.
void check_way(const MovingBody& body, const Scene& scene, SceneSection& s) {
    if (!body.motion.law || body.elastic) return;
    const MotionLaw& law = *body.motion.law;
    const Vec3& centre = body.motion.mass.centre;
    constexpr int moments = 400;
    for (int k = 1; k <= moments; ++k) {
        const double t = scene.run.duration * k / moments, path = law.at(t).path;
        const Eigen::AngleAxisd turn(law.turns ? path : 0, law.axis);
        const Vec3 shift = law.turns ? Vec3::Zero() : Vec3(path * law.axis);
        for (const Vec3& p : body.surface.points) {
            const Vec3 at = centre + turn * (p - centre) + shift;
            for (int a = 0; a < 3; ++a) {
                if (a == 1 && scene.domain.dimensions == 2) continue;
                if (at[a] > scene.domain.box.min[a] && at[a] < scene.domain.box.max[a]) continue;
                s.fail("law",
                       fmt::format("takes body {} out of the tank: at {:.4g} s it reaches {} = {:.4g} m, the tank "
                                   "{:.4g} to {:.4g} m; expected a shorter way, or a shorter [run] duration",
                                   body.name, t, "xyz"[a], at[a], scene.domain.box.min[a], scene.domain.box.max[a]));
            }
        }
    }
}

/// Water gets under the end of a plate that stops where the tank's floor or side begins: its dummies do not overlap the
/// images there, and go away from them when it bends.
void warn_of_end_at_wall(MovingBody& body, const Scene& scene) {
    static constexpr const char* walls[3][2] = {
        {"side at low x", "side at high x"}, {"side at low y", "side at high y"}, {"floor", "top"}};
    const Box at = body.surface.bounds(), &box = scene.domain.box;
    const double spacing = scene.resolution.near_hull;
    for (int a = 0; a < 3; ++a) {
        if (a == 1 && scene.domain.dimensions == 2) continue;
        for (const bool high : {false, true}) {
            const double beyond = high ? at.max[a] - box.max[a] : box.min[a] - at.min[a];
            if (std::abs(beyond) >= spacing || (a == 2 && high)) continue;
            body.findings.push_back(
                {Finding::Level::warning, "ends_at_wall",
                 fmt::format(
                     "plate {} ends at the tank's {}, where water can get in under it as it bends; let it reach "
                     "{:.3g} m (four spacings) farther, into the wall that holds it",
                     body.name, walls[a][high], 4 * spacing),
                 high ? at.max : at.min});
        }
    }
}

void check_scheme(const Scene& scene, SceneSection& s) {
    if (scene.sph.scheme != "kick_drift_kick" && scene.sph.scheme != "symplectic_euler")
        s.fail("scheme",
               "the added mass of free bodies is taken into account once a step; expected "
               "\"kick_drift_kick\"");
}

void note_centre(const std::string& whose, const Surface& surface, const Vec3& centre, std::vector<Finding>& findings) {
    if (SurfaceQuery(surface).nearest(centre).distance > 0)
        findings.push_back({Finding::Level::warning, "centre_outside",
                            fmt::format("the centre of mass of {} lies outside its surface", whose), centre});
}

}  // namespace

void refuse_unmeshable(const Scene& scene) {
    mesh_motion(scene);
    if (scene.hull && scene.hull->section && !scene.refined.empty())
        throw InputError(scene.file.string() +
                         ": the mesh of a section has cells of one size away from the hull; remove [[refine]], or run "
                         "the particles alone (methods = [\"sph\"])");
}

void check_elastic(const Scene& scene, Sections& s) {
    for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
        if (!scene.bodies[b].elastic) continue;
        if (scene.sph.scheme != "kick_drift_kick")
            s.numerics.at(sph_method)
                .fail("scheme", "elastic bodies are advanced with the water; expected \"kick_drift_kick\"");
        if (scene.effect_on("no_slip"))
            s.effects.fail("no_slip", "friction does not act on elastic bodies; expected \"off\"");
    }
}

void check_free_hull(Scene& scene, Sections& s) {
    if (!scene.hull_is_free()) return;
    Hull& hull = *scene.hull;
    const FreeHull& free = *hull.free;
    if (scene.motion.kind != Motion::Kind::stream)
        s.hull.fail("free",
                    "a hull is free in a stream only; in a tank write it as a [[body]], or expected kind = "
                    "\"stream\"");
    check_scheme(scene, s.numerics.at(sph_method));
    if (free.motion.release >= scene.run.duration)
        s.hull.fail("release", fmt::format("the hull would be held to the end of the run, {:.4g} s; expected a time "
                                           "before it, or a longer [run] duration",
                                           scene.run.duration));
    note_centre("the hull", hull.surface, free.motion.mass.centre, hull.findings);
    if (free.at_rest) return;
    hull.findings.push_back(
        {Finding::Level::warning, "does_not_float",
         fmt::format(
             "at rest the hull does not float within 20 degrees of how it stands: it weighs as much as {:.4g} m3 "
             "of water, and all of it has {:.4g} m3; see mass, lcg and vcg",
             free.motion.mass.mass / scene.water.density, hull.mass.volume),
         free.motion.mass.centre});
}

void check_bodies(Scene& scene, Sections& s) {
    if (scene.bodies.empty()) return;
    if (!std::ranges::all_of(scene.bodies, [](const MovingBody& b) { return b.motion.law && !b.elastic; }))
        check_scheme(scene, s.numerics.at(sph_method));
    const double gap = scene.resolution.near_hull / 2;
    std::vector<Box> boxes, of_obstacles;
    for (const MovingBody& b : scene.bodies) boxes.push_back(b.surface.bounds());
    for (const Obstacle& o : scene.obstacles) of_obstacles.push_back(o.surface.bounds());
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        MovingBody& body = scene.bodies[i];
        SceneSection& section = s.bodies[i];
        const bool supported = body.elastic && body.motion.law;  // then its ends may stand in what holds it
        if (!supported) check_domain(body, scene, section);
        if (supported && body.plate()) warn_of_end_at_wall(body, scene);
        check_way(body, scene, section);
        const auto refuse = [&](const std::string& other) {
            section.fail(where_key(section),
                         fmt::format("body {} starts in {} or within half a particle of it", body.name, other));
        };
        const auto meets = [&](const Surface& other, const Box& box) {
            return gap_of_boxes(boxes[i], box) <= gap && meet(body.surface, other, gap);
        };
        for (std::size_t k = 0; k < scene.obstacles.size() && !supported; ++k)
            if (meets(scene.obstacles[k].surface, of_obstacles[k])) refuse("obstacle " + scene.obstacles[k].name);
        if (scene.hull && meets(scene.hull->surface, scene.hull->surface.bounds())) refuse("the hull");
        for (std::size_t j = 0; j < i; ++j)
            if (meets(scene.bodies[j].surface, boxes[j])) refuse("body " + scene.bodies[j].name);
        note_centre("body " + body.name, body.surface, body.motion.mass.centre, body.findings);
        const Vec3 size = boxes[i].size();
        const double smallest = scene.domain.dimensions == 2 ? std::min(size.x(), size.z()) : size.minCoeff();
        if (smallest < 6 * scene.resolution.near_hull)
            body.findings.push_back(
                {Finding::Level::warning, "few_particles",
                 fmt::format("body {} is {:.4g} m wide or high, {:.2g} particle spacings: the water on both sides is "
                             "not shielded by fewer than 6",
                             body.name, smallest, smallest / scene.resolution.near_hull),
                 body.motion.mass.centre});
    }
}

}  // namespace tw
