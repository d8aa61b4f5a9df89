#include "scene/solids/hull_axes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "meshes/check/edges.h"
#include "meshes/mass_properties.h"
#include "meshes/symmetric.h"

namespace tw {
namespace {

constexpr double flush = 1e-3;  // of the width: this near to the plane is in it

/// How far the centre of volume lies from the middle along an axis, as a share of the size.
double off_middle(const Surface& surface, const Vec3& centre, int axis) {
    const Box box = surface.bounds();
    return (centre[axis] - 0.5 * (box.min[axis] + box.max[axis])) / box.size()[axis];
}
bool in_the_middle(double off) { return std::abs(off) < 2e-3; }
bool beside_it(double off) { return std::abs(off) > 2e-2; }

/// Area of faces whose normal is along `direction` within 18 degrees [m2].
double facing(const Surface& surface, const Vec3& direction) {
    double area = 0;
    for (int t = 0; t < static_cast<int>(surface.triangles.size()); ++t) {
        const Vec3 twice = surface.area_vector2(t);
        if (twice.dot(direction) > 0.95 * twice.norm()) area += 0.5 * twice.norm();
    }
    return area;
}

Surface at_positive_y(const Surface& surface) {
    const Box box = surface.bounds();
    if (box.max.y() > -box.min.y()) return surface;
    Surface turned = surface;
    for (Vec3& p : turned.points) p.y() = -p.y();
    for (auto& t : turned.triangles) std::swap(t[1], t[2]);
    return turned;
}

}  // namespace

bool is_half(const Surface& surface) {
    if (surface.triangles.empty()) return false;
    const Surface s = at_positive_y(surface);
    const Box box = s.bounds();
    const double width = box.max.y(), near = flush * width;
    if (!(width > 0) || std::abs(box.min.y()) > near) return false;
    const auto in_plane = [&](int corner) { return s.points[static_cast<std::size_t>(corner)].y() <= near; };
    const Edges edges = find_edges(s);
    for (const Edge& e : edges.edges)
        if (edges.open(e) && in_plane(edges.uses[e.begin].low) && in_plane(edges.uses[e.begin].high)) return true;
    double face = 0;
    for (int t = 0; t < static_cast<int>(s.triangles.size()); ++t) {
        const auto& corners = s.triangles[static_cast<std::size_t>(t)];
        if (std::ranges::all_of(corners, in_plane)) face += 0.5 * s.area_vector2(t).norm();
    }
    return face > 0.3 * box.size().x() * box.size().z() && beside_it(off_middle(s, mass_properties(s).centroid, 1));
}

std::optional<Finding> mirror_half(Surface& surface) {
    if (!is_half(surface)) return {};
    const Box box = surface.bounds();
    const bool port = box.max.y() <= -box.min.y();
    const Surface s = at_positive_y(surface);
    surface = made_symmetric(s, flush * s.bounds().max.y());
    return Finding{
        Finding::Level::note, "mirrored",
        fmt::format("the surface is half a hull, at y {} 0: the other half is its mirror image about y = 0, and the "
                    "hull is {:.4g} m wide",
                    port ? "<" : ">", 2 * std::max(box.max.y(), -box.min.y())),
        Vec3::Zero()};
}

std::vector<Finding> check_axes(const Surface& surface) {
    std::vector<Finding> findings;
    const Vec3 size = surface.bounds().size();
    if (!(size.minCoeff() > 0)) return findings;
    const MassProperties mass = mass_properties(surface);
    const double x = off_middle(surface, mass.centroid, 0), y = off_middle(surface, mass.centroid, 1),
                 z = off_middle(surface, mass.centroid, 2);
    const auto warn = [&](const char* name, const std::string& what) {
        findings.push_back({Finding::Level::warning, name, what, mass.centroid});
    };
    if (in_the_middle(z) && beside_it(y) && size.x() > size.y())
        warn("lying", fmt::format("its two sides, in y, differ, and its upper and lower half are alike: it lies on its "
                                  "side, or its file has y up; axes = \"{}\" sets it upright",
                                  y > 0 ? "x-zy" : "xz-y"));
    else if (in_the_middle(x) && beside_it(y) && size.y() > size.x())
        warn("across", fmt::format("it is {:.3g} m long in y and {:.3g} m in x, along which the stream runs: it lies "
                                   "across the stream; turn it with axes, e.g. \"y-xz\", or \"-yxz\" if that is stern "
                                   "first",
                                   size.y(), size.x()));
    const double down = facing(surface, -Vec3::UnitZ()), up = facing(surface, Vec3::UnitZ());
    if (in_the_middle(y) && z < -2e-2 && down > 2 * up && down > 0.3 * size.x() * size.y())
        warn("upside_down", fmt::format("{:.3g} m2 of flat surface face down and {:.3g} m2 face up, and most of its "
                                        "volume is in its lower half: it may stand on its deck; axes = \"x-y-z\" turns "
                                        "it over",
                                        down, up));
    return findings;
}

}  // namespace tw
