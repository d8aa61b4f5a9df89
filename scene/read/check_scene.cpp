#include "scene/read/check_scene.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/errors.h"
#include "base/numbers.h"
#include "meshes/section.h"
#include "meshes/symmetric.h"
#include "scene/defaults.h"
#include "scene/refined_places.h"
#include "scene/solids/hull_axes.h"

namespace tw {

void check_health(HullOptions& o, double particle_spacing, SceneSection& s) {
    Hull& hull = o.hull;
    hull.findings = check_surface(o.as_read, particle_spacing);
    if (o.repair) {
        Repaired repaired = repair_surface(o.as_read);
        hull.repairs = std::move(repaired.done);
        o.as_read = std::move(repaired.surface);
        hull.surface = posed(o.as_read, o.pose);
        hull.findings = check_surface(o.as_read, particle_spacing);
    }
    refuse_unsound(hull.findings, s, hull.source, o.key, [&](const Finding& f) {
        return o.repair ? " (repair = true could not repair it)" : f.mendable ? "; repair = true repairs it" : "";
    });
    for (const std::vector<Finding>& more : {o.notes, check_axes(o.as_read)})
        hull.findings.insert(hull.findings.end(), more.begin(), more.end());
    if (const auto solids = solids_note(hull.findings, s, hull.source)) hull.findings.push_back(*solids);
}

namespace {

/// A hull of one side of y = 0, or one that is symmetric about a plane beside it: one hull of a catamaran, or a whole one
/// whose file has another origin.
bool lies_beside(const Hull& hull, double limit) {
    const Box box = hull.surface.bounds();
    if (box.min.y() >= -limit || box.max.y() <= limit) return true;
    Surface in_the_middle = hull.surface;
    for (Vec3& p : in_the_middle.points) p.y() -= 0.5 * (box.min.y() + box.max.y());
    return asymmetry(in_the_middle).distance <= limit;
}

/// What would turn a hull upright whose file has other axes; empty where its upper and lower half differ, as a hull's do.
std::string turn_of_upright(const Hull& hull) {
    for (const Finding& f : hull.findings)
        if (f.name == "lying" || f.name == "across") return f.message;
    if (hull.trim != 0 || hull.heel != 0) return {};
    const Box box = hull.surface.bounds();
    Surface on_its_side = hull.surface;  // height in place of breadth
    for (Vec3& p : on_its_side.points) p = Vec3(p.x(), p.z() - 0.5 * (box.min.z() + box.max.z()), p.y());
    for (auto& t : on_its_side.triangles) std::swap(t[1], t[2]);
    Surface in_the_middle = hull.surface;
    for (Vec3& p : in_the_middle.points) p.y() -= 0.5 * (box.min.y() + box.max.y());
    const double limit = 1e-3 * box.size().minCoeff();
    if (asymmetry(on_its_side).distance > limit || asymmetry(in_the_middle).distance <= limit) return {};
    return "its upper and lower half are alike, and its two sides differ: it lies on its side, or its file has y up; "
           "axes = "
           "\"x-zy\" sets it upright";
}

}  // namespace

void make_halves_alike(Hull& hull, const Resolution& resolution, SceneSection& s) {
    const Asymmetry off = asymmetry(hull.surface);
    const double rounding = 1e-6 * hull.length;
    if (off.distance <= rounding) return;
    const double limit = std::max(0.1 * resolution.near_hull / resolution.scale, 1e-3 * hull.beam);
    const std::string where = fmt::format("near ({:.4g}, {:.4g}, {:.4g}) m the two sides differ by {:.3g} m",
                                          off.place.x(), off.place.y(), off.place.z(), off.distance);
    if (off.distance <= limit) {
        Surface alike = made_symmetric(hull.surface, off.distance);
        if (usable(check_surface(alike))) {
            hull.surface = std::move(alike);
            hull.findings.push_back(
                {Finding::Level::note, "made_symmetric",
                 where + ", less than a tenth of near_hull or a thousandth of the beam; both sides were "
                         "made from the side at y > 0",
                 off.place});
            return;
        }
    }
    const std::string not_symmetric = "the hull is not symmetric about y = 0: " + where;
    if (const std::string turn = turn_of_upright(hull); !turn.empty()) s.fail("half", not_symmetric + "; " + turn);
    const Box box = hull.surface.bounds();
    if (const double middle = 0.5 * (box.min.y() + box.max.y()); std::abs(middle) > limit && lies_beside(hull, limit))
        s.fail("half",
               fmt::format(
                   "the hull lies beside y = 0, from {:.4g} to {:.4g} m, and half = true mirrors what lies at y > 0 "
                   "about y = 0. Expected of a catamaran a file with both hulls, one on each side of y = 0; of a "
                   "hull alone one whose middle is at y = 0, here by position = [x, y] with {:.6g} m taken off y",
                   box.min.y(), box.max.y(), middle));
    s.fail("half", not_symmetric + "; set half = false");
}

void take_section(HullOptions& o, SceneSection& s) {
    Hull& hull = o.hull;
    try {
        hull.surface = section_prism(hull.surface);
    } catch (const InputError& e) {
        s.fail(o.key, fmt::format("two dimensions are the plane y = 0, and {}; move the hull with position = [x, y]",
                                  e.what()));
    }
    hull.draft = -hull.surface.bounds().min.z();
}

void check_hull_place(const Scene& scene, Sections& s, const std::string& key) {
    const Hull& hull = *scene.hull;
    const Box bounds = hull.surface.bounds();
    if (hull.still.volume <= 0)
        s.hull.fail(
            "draft",
            fmt::format("the hull displaces no water at draft {:.6g} m; expected it to reach below z = 0", hull.draft));
    const Box& domain = scene.domain.box;
    const double room = 4 * scene.resolution.near_hull;
    static constexpr const char* axis_names[] = {"x", "y", "z"};
    static constexpr const char* low_keys[] = {"ahead", "side", "below"};
    static constexpr const char* high_keys[] = {"behind", "side", "above"};
    for (int axis = 0; axis < 3; ++axis) {
        if (axis == 1 && hull.section) continue;
        const bool mirrored = axis == 1 && hull.half;
        const bool low = !mirrored && bounds.min[axis] < domain.min[axis] + room;
        if (!low && bounds.max[axis] <= domain.max[axis] - room) continue;
        const auto a = static_cast<std::size_t>(axis);
        const bool beyond = bounds.max[axis] > domain.max[axis] || (!mirrored && bounds.min[axis] < domain.min[axis]);
        const std::string message = fmt::format(
            "the hull {} the domain: in {} it spans {:.6g} to {:.6g} m, the domain {:.6g} to {:.6g} m; "
            "expected at least {:.3g} m (four particles) between them",
            beyond ? "is larger than" : "comes too close to a side of", axis_names[a], bounds.min[axis],
            bounds.max[axis], domain.min[axis], domain.max[axis], room);
        if (s.tank.present()) s.tank.fail(s.tank.has("size") ? "size" : "max", message);
        const std::string nearest = s.domain.has(axis_names[a]) ? axis_names[a] : low ? low_keys[a] : high_keys[a];
        if (s.domain.has(nearest)) s.domain.fail(nearest, message);
        if (axis == 2 && low && s.water.has("depth")) s.water.fail("depth", message);
        s.hull.fail(key, message);
    }
}

void check_places(Scene& scene, Sections& s) {
    const Box& box = scene.domain.box;
    const auto outside = [&](const Vec3& p, double slack) {
        return !Box{(box.min.array() - slack).matrix(), (box.max.array() + slack).matrix()}.contains(p);
    };
    const std::string range = fmt::format("the domain spans ({:.6g}, {:.6g}, {:.6g}) to ({:.6g}, {:.6g}, {:.6g}) m",
                                          box.min.x(), box.min.y(), box.min.z(), box.max.x(), box.max.y(), box.max.z());
    const double slack = 1e-6 * box.size().maxCoeff();
    for (std::size_t i = 0; i < scene.water_blocks.size(); ++i) {
        Box& block = scene.water_blocks[i];
        if (scene.domain.dimensions == 2) {
            block.min.y() = box.min.y();
            block.max.y() = box.max.y();
        }
        for (const char* key : {"min", "max"})
            if (outside(key == std::string("min") ? block.min : block.max, slack))
                s.water_blocks[i].fail(key, "outside the domain; " + range);
    }
    for (std::size_t i = 0; i < scene.obstacles.size(); ++i) {
        Obstacle& o = scene.obstacles[i];
        if (scene.domain.dimensions == 2 && s.obstacles[i].has("min")) {  // a box reaches through the whole thickness
            const double high = o.surface.bounds().max.y();
            for (Vec3& p : o.surface.points) p.y() = p.y() == high ? box.max.y() : box.min.y();
        }
        const Box at = o.surface.bounds();
        if (((at.max - box.min).array() <= 0).any() || ((box.max - at.min).array() <= 0).any())
            s.obstacles[i].fail(s.obstacles[i].has("min") ? "min" : "position",
                                "the obstacle lies outside the domain; " + range);
    }
    for (std::size_t i = 0; i < scene.sampling.volumes.size(); ++i) {
        Box& at = scene.sampling.volumes[i].box;
        if (scene.domain.dimensions == 2) at.min.y() = -infinite, at.max.y() = infinite;
        if (((at.max - box.min).array() <= 0).any() || ((box.max - at.min).array() <= 0).any())
            s.volumes[i].fail("min", "the box lies outside the domain; " + range);
    }
    std::size_t pressure = 0, height = 0;
    for (SceneSection& probe : s.probes) {
        for (const char* event : {"slam", "deck"})
            if (probe.has(event) && !s.wave.present())
                probe.fail(event, "events are counted by the periods of waves; expected [wave], or remove this key");
        if (probe.has("pressure")) {
            Vec3& place = scene.sampling.pressure[pressure++].place;
            if (scene.domain.dimensions == 2) place.y() = 0.5 * (box.min.y() + box.max.y());
            if (outside(place, slack)) probe.fail("pressure", "outside the domain; " + range);
        } else {
            HeightProbe& place = scene.sampling.height[height++];
            if (scene.domain.dimensions == 2) place.y = 0.5 * (box.min.y() + box.max.y());
            if (outside({place.x, place.y, box.min.z()}, slack)) probe.fail("height", "outside the domain; " + range);
        }
    }
}

void check_gate(const Scene& scene, const SceneSection& sph) {
    const SphOptions& o = scene.sph;
    if (o.gate_point.empty() && o.gate_normal.empty()) return;
    const char* key = o.gate_point.empty() ? "gate_normal" : "gate_point";
    if (o.gate_point.empty() || o.gate_normal.empty()) sph.fail(key, "a plane needs both gate_point and gate_normal");
    for (const auto& [name, values] : {std::pair{"gate_point", &o.gate_point}, {"gate_normal", &o.gate_normal}})
        if (values->size() != 3) sph.fail(name, fmt::format("{} numbers; expected three, [x, y, z]", values->size()));
    if (!(Vec3(o.gate_normal.data()).norm() > 0)) sph.fail("gate_normal", "expected a direction, e.g. [0, 0, 1]");
    if (scene.domain.dimensions == 2) sph.fail(key, "droplets need three dimensions; remove this key");
    if (scene.effect_on("air")) sph.fail(key, "the effect air would be left with holes; switch one of the two off");
}

void check_sound_speed(const Scene& scene) {
    const double fastest = 0.1 * default_sound_speed(scene);
    if (scene.sph.c0 <= fastest)
        throw InputError(
            fmt::format("{}: not above the speed of the water, {:.4g} m/s; expected about {:.4g} m/s, ten "
                        "times that speed",
                        scene.place_of("sph.c0"), fastest, 10 * fastest));
}

}  // namespace tw
