#include "sph_solver/measure/control_volume.h"

#include <algorithm>
#include <cmath>

namespace tw {

ControlVolume::ControlVolume(const Box& box, double size, int dimensions, const std::function<bool(const Vec3&)>& takes)
    : box_(box) {
    const bool flat = dimensions == 2;
    faces_.want_flux = true;
    count_ = (box_.size().array() / size).round().max(1).cast<int>();
    if (flat) count_.y() = 1;
    cell_ = box_.size().array() / count_.cast<double>();
    const auto centre = [&](const Eigen::Array3i& c) {
        return Vec3(box_.min + ((c.cast<double>() + 0.5).matrix().cwiseProduct(cell_)));
    };
    const auto for_cells = [&](const auto& f) {
        for (int k = 0; k < count_.z(); ++k)
            for (int j = 0; j < count_.y(); ++j)
                for (int i = 0; i < count_.x(); ++i) f(Eigen::Array3i(i, j, k));
    };
    if (takes) for_cells([&](const Eigen::Array3i& c) { taken_.push_back(takes(centre(c))); });
    for_cells([&](const Eigen::Array3i& c) {
        if (!inside(c.x(), c.y(), c.z())) return;
        for (int axis = 0; axis < 3; ++axis)
            for (const int side : {-1, 1}) {
                if (axis == 1 && flat) continue;
                Eigen::Array3i other = c;
                other[axis] += side;
                if (inside(other.x(), other.y(), other.z())) continue;
                Vec3 at = centre(c), area = Vec3::Zero();
                at[axis] += 0.5 * side * cell_[axis];
                area[axis] = side * cell_.prod() / cell_[axis];
                faces_.places.push_back(at);
                area_.push_back(area);
            }
    });
}

void ControlVolume::add_impulse(double mass_inside, const Vec3& body_force, double dt) {
    Vec3 force = mass_inside * body_force;
    for (std::size_t k = 0; k < area_.size(); ++k) {
        // the share of the patch that is water: full support 1 in the interior
        const double share = std::clamp(2.0 * faces_.support[k] - 0.5, 0.0, 1.0);
        for (int axis = 0; axis < 3; ++axis)
            force[axis] -= share * double(faces_.flux[3 * k + static_cast<std::size_t>(axis)]) * area_[k][axis];
    }
    state_.impulse += force * dt;
    state_.since += dt;
}

Vec3 ControlVolume::momentum_inside(const ControlVolume& cv, const Particles& p, double m, double& mass_inside) {
    Vec3 sum = Vec3::Zero();
    mass_inside = 0;
    for (std::size_t i = 0; i < p.size(); ++i) {
        if (p.kind[i] == Kind::guard || !cv.inside(p.x[i], p.y[i], p.z[i])) continue;
        sum += m * Vec3(p.u[i], p.v[i], p.w[i]);
        mass_inside += m;
    }
    return sum;
}

}  // namespace tw
