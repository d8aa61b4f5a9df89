#include <fmt/format.h>

#include <algorithm>

#include "base/errors.h"
#include "meshes/query.h"
#include "scene/check_scene.h"
#include "scene/mesh_motion.h"

namespace tw {
namespace {

/// Whether two closed surfaces come nearer to each other than `gap` [m], judged at corners and middles of triangles.
bool meet(const Surface& a, const Surface& b, double gap) {
    const Box at = a.bounds(), other = b.bounds();
    if (((at.min - other.max).array() > gap).any() || ((other.min - at.max).array() > gap).any()) return false;
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

std::string where_key(const Section& s) { return s.has("position") ? "position" : s.has("draft") ? "draft" : "name"; }

void check_domain(const MovingBody& body, const Scene& scene, Section& s) {
    static constexpr const char* axes[] = {"x", "y", "z"};
    const Box at = body.surface.bounds(), &domain = scene.domain.box;
    for (int a = 0; a < 3; ++a) {
        if (a == 1 && scene.domain.dimensions == 2) continue;
        if (at.min[a] > domain.min[a] && at.max[a] < domain.max[a]) continue;
        s.fail(where_key(s), fmt::format("body {} starts in a wall of the tank or outside it: in {} it spans {:.6g} to "
                                         "{:.6g} m, the tank {:.6g} to {:.6g} m",
                                         body.name, axes[a], at.min[a], at.max[a], domain.min[a], domain.max[a]));
    }
}

}  // namespace

void refuse_unsolved(const Scene& scene, const std::string& method) {
    if (method == "fvm") mesh_motion(scene);
}

void check_elastic(const Scene& scene, Sections& s) {
    for (std::size_t b = 0; b < scene.bodies.size(); ++b) {
        if (!scene.bodies[b].elastic) continue;
        if (scene.sph.scheme != "kick_drift_kick")
            s.sph.fail("scheme", "elastic bodies are advanced with the water; expected \"kick_drift_kick\"");
        if (scene.sph.levels > 1) s.sph.fail("levels", "elastic bodies need particles of one size; expected 1");
        if (scene.effect_on("no_slip"))
            s.effects.fail("no_slip", "friction is not handed over to elastic bodies; expected \"off\"");
    }
}

void check_bodies(Scene& scene, Sections& s) {
    if (scene.bodies.empty()) return;
    if (scene.motion.kind == Motion::Kind::stream)
        s.motion.fail("kind", "bodies that move are solved in tanks alone; expected kind = \"none\"");
    if (scene.hull)
        s.hull.fail("shape", "a fixed hull beside bodies that move is an [[obstacle]]; remove this section");
    if (scene.sph.scheme != "kick_drift_kick" && scene.sph.scheme != "symplectic_euler")
        s.sph.fail("scheme", "bodies that move need a time step of one evaluation; expected \"kick_drift_kick\"");
    const double gap = scene.resolution.near_hull / 2;
    for (std::size_t i = 0; i < scene.bodies.size(); ++i) {
        MovingBody& body = scene.bodies[i];
        Section& section = s.bodies[i];
        const bool supported = body.elastic && body.motion.law;  // then its ends may stand in what holds it
        if (!supported) check_domain(body, scene, section);
        const auto refuse = [&](const std::string& other) {
            section.fail(where_key(section),
                         fmt::format("body {} starts in {} or within half a particle of it", body.name, other));
        };
        for (const Obstacle& o : scene.obstacles)
            if (!supported && meet(body.surface, o.surface, gap)) refuse("obstacle " + o.name);
        for (std::size_t j = 0; j < i; ++j)
            if (meet(body.surface, scene.bodies[j].surface, gap)) refuse("body " + scene.bodies[j].name);
        if (SurfaceQuery(body.surface).nearest(body.motion.mass.centre).distance > 0)
            body.findings.push_back({Finding::Level::warning, "centre_outside",
                                     fmt::format("the centre of mass of body {} lies outside its surface", body.name),
                                     body.motion.mass.centre});
        const Vec3 size = body.surface.bounds().size();
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
