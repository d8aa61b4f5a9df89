#include "scene/water/tailwater.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <utility>

#include "base/errors.h"

namespace tw {
namespace {

/// Middle of the highest part of a surface along x [m].
double crest(const Surface& surface) {
    const Box all = surface.bounds();
    const double from = all.max.z() - 0.01 * all.size().z();
    double low = all.max.x(), high = all.min.x();
    for (const Vec3& p : surface.points)
        if (p.z() >= from) low = std::min(low, p.x()), high = std::max(high, p.x());
    return (low + high) / 2;
}

/// Behind what ends the water ahead: a solid that hangs into it before one that stands on the bed.
double beginning(const Scene& scene) {
    const Box& box = scene.domain.as_asked;
    const Obstacle* found = nullptr;
    const auto order = [&](const Obstacle& o) {
        const Box at = o.surface.bounds();
        return std::pair(at.min.z() > box.min.z() + scene.resolution.near_hull, at.max.z());
    };
    for (const Obstacle& o : scene.obstacles)
        if (!found || order(o) > order(*found)) found = &o;
    if (!found) return (box.min.x() + box.max.x()) / 2;
    return std::clamp(crest(found->surface), box.min.x(), box.max.x());
}

}  // namespace

std::optional<Tailwater> tailwater(const Scene& scene) {
    const double behind = scene.zones.downstream, ahead = -scene.domain.as_asked.min.z();
    if (!(behind > 0) || scene.motion.kind != Motion::Kind::stream) return {};
    Tailwater t{.depth = behind, .speed = scene.motion.speed * (ahead / behind), .level = behind - ahead};
    t.begins = beginning(scene);
    t.is_slow = t.speed * t.speed < scene.water.gravity * t.depth;
    return t;
}

double fastest_stream(const Scene& scene) {
    const std::optional<Tailwater> behind = tailwater(scene);
    return std::max(scene.motion.speed, behind ? behind->speed : 0.0);
}

void check_tailwater(const Scene& scene) {
    if (!(scene.zones.downstream > 0)) return;
    const auto refuse = [&](const std::string& why) {
        throw InputError(scene.place_of("domain.downstream") + ": " + why);
    };
    if (scene.motion.kind != Motion::Kind::stream)
        refuse("there is no stream that leaves; remove this key or write kind = \"stream\" in [motion]");
    if (scene.hull) refuse("a hull stands in a stream of one depth; remove this key");
    if (!(scene.water.gravity > 0) || !scene.effect_on("gravity"))
        refuse("without gravity nothing holds a depth; remove this key");
    if (!scene.effect_on("forcing_zones"))
        refuse(
            "the zones that draw the water to it are switched off by forcing_zones = \"off\" in [effects]; remove "
            "one of the two");
    const Tailwater t = *tailwater(scene);
    const Box& box = scene.domain.as_asked;
    const double g = scene.water.gravity, ahead = -box.min.z(), speed = scene.motion.speed;
    if (t.level > box.max.z() - 2 * scene.resolution.near_hull)
        refuse(
            fmt::format("water {:.4g} m deep reaches to z = {:.4g} m, and the domain ends at {:.4g} m; expected a "
                        "higher domain ([domain] z)",
                        t.depth, t.level, box.max.z()));
    if (t.depth < 4 * scene.resolution.near_hull)
        refuse(
            fmt::format("too shallow for particles and cells of {:.4g} m; expected a depth of at least four of them, "
                        "or near_hull at most {:.3g} m",
                        scene.resolution.near_hull, t.depth / 4));
    if (scene.obstacles.empty() && !t.is_slow && speed * speed < g * ahead)
        refuse(
            fmt::format("the stream comes slower than its waves ({:.3g} of {:.3g} m/s) and is to leave faster than "
                        "them, {:.3g} m/s {:.3g} m deep, but no obstacle makes it fast; expected a weir or a gate "
                        "([[obstacle]]), or a depth of more than {:.3g} m",
                        speed, std::sqrt(g * ahead), t.speed, t.depth, std::cbrt(ahead * ahead * speed * speed / g)));
}

}  // namespace tw
