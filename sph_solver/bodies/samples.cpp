#include "sph_solver/bodies/samples.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "record/wetted_line.h"
#include "sph_solver/bodies/body.h"

namespace tw {

SurfaceSamples::SurfaceSamples(const Surface& surface, double size, const Box& region) {
    for (int t = 0; t < static_cast<int>(surface.triangles.size()); ++t) {
        const Vec3 a = surface.corner(t, 0), ab = surface.corner(t, 1) - a, ac = surface.corner(t, 2) - a;
        const double longest = std::max({ab.norm(), ac.norm(), (ab - ac).norm()});
        const int n = std::max(1, static_cast<int>(std::ceil(longest / size)));
        const Vec3 part = surface.area_vector2(t) / (2.0 * n * n);
        // n^2 congruent triangles: those standing up, and those upside down between them
        for (int i = 0; i < n; ++i)
            for (int j = 0; i + j < n; ++j)
                for (int down = 0; down < (i + j < n - 1 ? 2 : 1); ++down) {
                    const double third = down ? 2.0 / 3 : 1.0 / 3;
                    const Vec3 p = a + ab * ((i + third) / n) + ac * ((j + third) / n);
                    if (!region.contains(p)) continue;
                    add(p, part);
                    const double u = double(i) / n, v = double(j) / n, e = 1.0 / n;
                    const auto corner = [&](double x, double y) {
                        patches_.points.push_back(a + ab * x + ac * y);
                        return static_cast<int>(patches_.points.size()) - 1;
                    };
                    if (down)
                        patches_.triangles.push_back({corner(u + e, v), corner(u + e, v + e), corner(u, v + e)});
                    else
                        patches_.triangles.push_back({corner(u, v), corner(u + e, v), corner(u, v + e)});
                }
    }
}

SurfaceSamples SurfaceSamples::of_section(const Surface& prism, double size, const Box& region) {
    SurfaceSamples out;
    for (int t = 0; t < static_cast<int>(prism.triangles.size()); ++t) {
        int k = 0;  // a side is two triangles: the one with an edge on the low end, from corner k on
        while (k < 3 && (prism.corner(t, k).y() > 0 || prism.corner(t, (k + 1) % 3).y() > 0)) ++k;
        if (k == 3 || prism.corner(t, (k + 2) % 3).y() < 0) continue;
        const Vec3 a = prism.corner(t, k), along = prism.corner(t, (k + 1) % 3) - a;
        const int n = std::max(1, static_cast<int>(std::ceil(along.norm() / size)));
        const Vec3 across(0, -2 * a.y(), 0), half_strip = prism.area_vector2(t) / (2.0 * n * across.norm());
        for (int i = 0; i < n; ++i) {
            const Vec3 low = a + along * i / n, high = a + along * (i + 1) / n, middle = 0.5 * (low + high + across);
            if (!region.contains(middle)) continue;
            const int first = static_cast<int>(out.patches_.points.size());
            out.patches_.points.insert(out.patches_.points.end(), {low, high, high + across, low + across});
            for (const int corner : {1, 2}) {
                out.patches_.triangles.push_back({first, first + corner, first + corner + 1});
                out.add(middle, half_strip);
            }
        }
    }
    return out;
}

SurfaceSamples SurfaceSamples::moved_with(const Body& body) const {
    SurfaceSamples moved;
    for (std::size_t k = 0; k < area.size(); ++k) moved.add(body.now(points.places[k]), body.turned(area[k]));
    return moved;
}

Surface SurfaceSamples::patches_with(const Body& body) const {
    Surface moved = patches_;
    for (Vec3& p : moved.points) p = body.now(p);
    return moved;
}

void SurfaceSamples::add(const Vec3& place, const Vec3& part) {
    const Vec3 normal = part.normalized();
    points.places.push_back(place);
    area.push_back(part);
    on_patch_.push_back(static_cast<float>(waterline_support(std::acos(std::clamp(-normal.z(), -1.0, 1.0)))));
    along_x_.push_back(static_cast<float>(waterline_support(std::atan2(std::abs(normal.x()), -normal.z()))));
}

Vec3 SurfaceSamples::pressure_force(const Vec3& moment_reference, Vec3& moment) const {
    Vec3 force = Vec3::Zero();
    moment.setZero();
    for (std::size_t k = 0; k < area.size(); ++k) {
        if (!presses(k)) continue;
        const Vec3 f = -double(points.p[k]) * area[k];
        force += f;
        moment += (points.places[k] - moment_reference).cross(f);
    }
    return force;
}

double SurfaceSamples::waterline_support(double theta) {
    return std::clamp(0.5 * (1 - theta / std::numbers::pi), 0.06, 0.47);
}

double SurfaceSamples::wetted_area() const {
    double sum = 0;
    for (std::size_t k = 0; k < area.size(); ++k)
        if (wet(k)) sum += area[k].norm();
    return sum;
}

double SurfaceSamples::wetted_length(double beam) const {
    WettedLine line(beam);
    for (std::size_t k = 0; k < area.size(); ++k)
        if (points.support[k] >= along_x_[k]) line.add_wet(points.places[k]);
    return line.longest();
}

}  // namespace tw
