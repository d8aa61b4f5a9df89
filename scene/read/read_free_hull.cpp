#include <algorithm>

#include "scene/read/read.h"

namespace tw {
namespace {

/// Whether the hull is free in the motion of this name.
bool names(const std::vector<std::string>& free, const char* motion) {
    return std::ranges::find(free, motion) != free.end();
}

/// The lowest corner in the hull's last hundredth: the keel at the transom, in the hull's own axes [m].
Vec3 transom_keel_of(const Surface& own) {
    const Box box = own.bounds();
    const double from = box.max.x() - 0.01 * box.size().x();
    Vec3 lowest(box.max.x(), 0, box.max.z());
    for (const Vec3& p : own.points)
        if (p.x() >= from && p.z() < lowest.z()) lowest = p;
    return lowest;
}

}  // namespace

std::optional<FreeHullOptions> read_free_hull(SceneSection& s) {
    const auto free = s.choices("free");
    if (!free || free->empty()) {
        for (const char* of_free : {"mass", "lcg", "vcg", "pitch_gyradius", "release"})
            if (s.has(of_free))
                s.fail(of_free,
                       "is for a hull that is free; expected also free = [\"heave\", \"pitch\"], or remove this key");
        return {};
    }
    FreeHullOptions o;
    o.free.along = {false, false, names(*free, "heave")};
    o.free.about = {false, names(*free, "pitch"), false};
    const auto mass = s.number("mass");
    if (!mass) s.fail("mass", "missing; a free hull needs the mass of the whole hull");
    o.mass = *mass;
    o.lcg = s.number("lcg");
    o.vcg = s.number("vcg");
    o.gyradius = s.number("pitch_gyradius");
    o.release = s.number("release");
    for (const char* key : {"lcg", "vcg"})
        if (names(*free, "pitch") && !s.has(key))
            s.fail(key,
                   "missing; a hull free in pitch needs lcg, ahead of its aftmost point, and vcg, above its lowest "
                   "point at zero trim");
    return o;
}

void stand_free_hull(HullOptions& o, double water_density) {
    const FreeHullOptions& given = *o.free;
    const Box own = o.as_read.bounds();
    const Eigen::Matrix3d turn = turn_of(o.pose);
    const Vec3 shift = posed(o.as_read, o.pose).points.front() - turn * o.as_read.points.front();
    const auto standing = [&](const Vec3& in_own_axes) -> Vec3 { return turn * in_own_axes + shift; };
    const Vec3 middle = 0.5 * (own.min + own.max);

    FreeHull& free = o.hull.free.emplace();
    RigidMass& mass = free.motion.mass;
    mass.mass = given.mass;
    mass.centre = standing({given.lcg ? own.max.x() - *given.lcg : middle.x(), middle.y(),
                            given.vcg ? own.min.z() + *given.vcg : middle.z()});
    const double gyradius = given.gyradius.value_or(0.25 * own.size().x());
    // of the three moments the one about y alone counts
    mass.inertia = mass.mass * gyradius * gyradius * Eigen::Matrix3d::Identity();
    free.motion.free = given.free;
    free.transom_keel = standing(transom_keel_of(o.as_read));
    free.at_rest = floating_attitude(o.hull.surface, mass.mass / water_density, mass.centre, given.free);
}

}  // namespace tw
