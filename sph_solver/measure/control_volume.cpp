#include "sph_solver/measure/control_volume.h"

#include <algorithm>
#include <cmath>

namespace tw {

void ControlVolume::make_faces(double size, int dimensions) {
    faces_ = {};
    faces_.want_flux = true;
    area_.clear();
    for (int axis = 0; axis < 3; ++axis) {
        const int b = (axis + 1) % 3, c = (axis + 2) % 3;
        if (axis == 1 && dimensions == 2) continue;
        const auto parts = [&](int a) {
            return a == 1 && dimensions == 2 ? 1 : std::max(1, static_cast<int>(std::round(box_.size()[a] / size)));
        };
        const int nb = parts(b), nc = parts(c);
        const double patch = box_.size()[b] / nb * box_.size()[c] / nc;
        for (int side = 0; side < 2; ++side)
            for (int i = 0; i < nb; ++i)
                for (int j = 0; j < nc; ++j) {
                    Vec3 p, n = Vec3::Zero();
                    p[axis] = side == 0 ? box_.min[axis] : box_.max[axis];
                    p[b] = box_.min[b] + (i + 0.5) * box_.size()[b] / nb;
                    p[c] = box_.min[c] + (j + 0.5) * box_.size()[c] / nc;
                    n[axis] = side == 0 ? -patch : patch;
                    faces_.places.push_back(p);
                    area_.push_back(n);
                }
    }
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
        if (!is_active(p.kind[i]) || !cv.inside(p.x[i], p.y[i], p.z[i])) continue;
        sum += m * Vec3(p.u[i], p.v[i], p.w[i]);
        mass_inside += m;
    }
    return sum;
}

}  // namespace tw
