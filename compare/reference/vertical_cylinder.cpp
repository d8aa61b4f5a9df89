#include "compare/reference/vertical_cylinder.h"

#include <algorithm>
#include <cmath>
#include <complex>
#include <numbers>
#include <vector>

#include "record/solid_at_rest.h"

namespace tw {

CylinderForce mac_camy_fuchs(const WaveAtCylinder& w, double radius) {
    const double s = w.k * radius;
    const auto hankel = [&](double n) { return std::complex<double>(std::cyl_bessel_j(n, s), std::cyl_neumann(n, s)); };
    const std::complex<double> derivative = (hankel(0) - hankel(2)) / 2.0;
    return {4 * w.density * w.gravity * w.amplitude / (w.k * w.k) * std::tanh(w.k * w.depth) / std::abs(derivative),
            std::arg(derivative)};
}

std::optional<UprightCylinder> upright_cylinder(const RunRecord& record) {
    const Surface* only = nullptr;
    for (const BodyShape& body : record.bodies) {
        if (!is_at_rest(body) || only) return {};
        only = &body.surface;
    }
    if (!only) return {};
    const Box box = only->bounds();
    const Vec3 middle = (box.min + box.max) / 2;
    const double reach = box.size().x() / 2;
    std::vector<double> corners;  // directions of those on the circle of the lower end
    for (const Vec3& p : only->points) {
        const double r = std::hypot(p.x() - middle.x(), p.y() - middle.y());
        if (r < 0.01 * reach) continue;  // the middle of an end
        if (std::abs(r - reach) > 0.01 * reach) return {};
        if (p.z() < box.min.z() + 0.01 * box.size().z())
            corners.push_back(std::atan2(p.y() - middle.y(), p.x() - middle.x()));
    }
    constexpr int fewest = 12;
    std::ranges::sort(corners);
    const auto same = std::ranges::unique(corners, [](double a, double b) { return b - a < 1e-6; });
    const auto sides = static_cast<double>(same.begin() - corners.begin());
    if (sides < fewest) return {};
    const double angle = 2 * std::numbers::pi / sides;
    return UprightCylinder{middle.x(), middle.y(), reach * std::sqrt(std::sin(angle) / angle), box.min.z(),
                           box.max.z()};
}

}  // namespace tw
