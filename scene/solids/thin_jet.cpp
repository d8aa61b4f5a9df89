#include "scene/solids/thin_jet.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <span>
#include <vector>

#include "base/numbers.h"
#include "record/planing_plate.h"
#include "scene/solids/hull_bottom.h"

namespace tw {

namespace {

constexpr int stations = 128;
constexpr double thin = 1e-4;  ///< of a station, over the hull's length: the keel's depth changes little along it

/// One bottom of a cross section: of a catamaran each hull has one.
struct Keel {
    double y = 0;                ///< its lowest place, the middle of a flat one
    double left = 0, right = 0;  ///< how far it reaches to the sides, at most to the middle between two bottoms
};

/// Of what lies under still water in the slice.
std::vector<Keel> keels_of(const Hull& hull, std::span<const std::size_t> triangles, Box slice) {
    slice.max.z() = 0;
    std::vector<Keel> keels;
    const std::vector<Breadth> wet = breadths_within(hull.surface, triangles, slice, thin * hull.length);
    for (std::size_t k = 0; k < wet.size(); ++k) {
        Keel keel{0, k > 0 ? 0.5 * (wet[k - 1].max + wet[k].min) : -infinite,
                  k + 1 < wet.size() ? 0.5 * (wet[k].max + wet[k + 1].min) : infinite};
        Box part = slice;
        part.min.y() = keel.left, part.max.y() = keel.right;
        const std::optional<Box> bottom = bottom_within(hull.surface, triangles, part);
        if (!bottom) continue;
        part.max.z() = bottom->min.z() + 0.01 * thin * hull.length;
        if (const std::optional<Box> lowest = bottom_within(hull.surface, triangles, part))
            keel.y = 0.5 * (lowest->min.y() + lowest->max.y());
        keels.push_back(keel);
    }
    return keels;
}

/// Of one side of a bottom in the slice, of those triangles; 0 where it is dry.
double of_wedge(const Hull& hull, Box part, std::span<const std::size_t> triangles, const Keel& keel, bool port,
                double flattest) {
    using std::numbers::pi;
    part.min.y() = port ? keel.left : keel.y;
    part.max.y() = port ? keel.y : keel.right;
    const std::optional<Box> bottom = bottom_within(hull.surface, triangles, part);
    if (!bottom || bottom->min.z() >= 0) return 0;
    part.max.z() = (1 - pi / 2) * bottom->min.z();  // to where the water rises
    const std::optional<Box> wet = bottom_within(hull.surface, triangles, part);
    if (!wet) return 0;
    const double c = port ? keel.y - wet->min.y() : wet->max.y() - keel.y;
    const double tan_beta = c > 0 ? wet->size().z() / c : 0;
    return tan_beta > flattest ? c * tan_beta * tan_beta / (2 * pi) : 0;
}

/// The triangles in each station's slice, so that a fine surface is gone through once and not once a slice.
std::vector<std::vector<std::size_t>> by_station(const Hull& hull, const Box& bounds) {
    std::vector<std::vector<std::size_t>> in(stations);
    const double between = bounds.size().x() / stations;
    for (std::size_t k = 0; k < hull.surface.triangles.size(); ++k) {
        double low = infinite, high = -infinite;
        for (const auto corner : hull.surface.triangles[k]) {
            const double x = hull.surface.points[static_cast<std::size_t>(corner)].x();
            low = std::min(low, x), high = std::max(high, x);
        }
        const auto station = [&](double x) { return (x - bounds.min.x()) / between - 0.5; };
        const int first = std::max(0, static_cast<int>(std::ceil(station(low - thin * hull.length) - 1e-6))),
                  last = std::min(stations - 1, static_cast<int>(std::floor(station(high) + 1e-6)));
        for (int s = first; s <= last; ++s) in[static_cast<std::size_t>(s)].push_back(k);
    }
    return in;
}

/// Of particles and cells where a place of the scene makes them finest.
double size_of_root(const Scene& scene) {
    int halvings = 0;
    for (const RefinedPlace& place : scene.refined)
        if (place.around == RefinedPlace::Around::spray_root) halvings = std::max(halvings, -place.halvings_short);
    return std::ldexp(scene.resolution.near_hull, -halvings);
}

/// Of a section whose wet bottom is one flat face that ends at its lowest point; 0: it is not, or no flow is known.
double of_section(const Scene& scene) {
    const Surface& s = scene.hull->surface;
    constexpr double flat = 0.01;  // [rad]
    const double depth = -scene.domain.box.min.z();
    double alpha = nan, lowest = infinite;
    for (std::size_t k = 0; k < s.triangles.size(); ++k) {
        const Vec3 normal = s.area_vector2(static_cast<int>(k)).normalized();
        double low = infinite;
        for (const auto corner : s.triangles[k]) low = std::min(low, s.points[static_cast<std::size_t>(corner)].z());
        if (low >= 0 || normal.z() > -flat || normal.x() > flat) continue;
        const double here = std::atan2(-normal.x(), -normal.z());
        if (std::abs(here - alpha) > flat) return 0;
        alpha = here, lowest = std::min(lowest, low);
    }
    if (!(alpha > flat) || lowest > s.bounds().min.z() + thin * scene.hull->length) return 0;
    const std::optional<PlaningPlate> plate = planing_plate_at(alpha, lowest / depth);
    return plate ? plate->delta * depth : 0;
}

}  // namespace

std::optional<SprayJet> thin_jet(const Scene& scene) {
    using std::numbers::pi;
    if (!scene.hull || scene.motion.kind != Motion::Kind::stream) return {};
    const Hull& hull = *scene.hull;
    const Box bounds = hull.surface.bounds();
    if (!(bounds.min.z() < 0) || !(bounds.max.z() > 0)) return {};
    if (hull.section) {
        const double exact = of_section(scene);
        return exact > 0 ? std::optional(SprayJet{exact, size_of_root(scene)}) : std::nullopt;
    }
    const double tau = std::max(hull.trim, 0.0), flattest = pi / 2 * std::tan(tau);
    const auto triangles = by_station(hull, bounds);
    double thickness = 0;
    for (int k = 0; k < stations; ++k) {
        const double x = bounds.min.x() + (k + 0.5) / stations * bounds.size().x();
        const Box slice{Vec3(x, -infinite, -infinite), Vec3(x + thin * hull.length, infinite, infinite)};
        const auto& here = triangles[static_cast<std::size_t>(k)];
        for (const Keel& keel : keels_of(hull, here, slice))
            for (const bool port : {false, true})
                thickness = std::max(thickness, of_wedge(hull, slice, here, keel, port, flattest));
    }
    if (!(thickness > 0)) thickness = pi * hull.still.wet_bounds.size().x() * tau * tau / (4 + 2 * pi * tau);
    if (!(thickness > 0)) return {};
    return SprayJet{thickness, size_of_root(scene)};
}

}  // namespace tw
