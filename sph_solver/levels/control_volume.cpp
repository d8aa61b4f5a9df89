#include "sph_solver/levels/control_volume.h"

#include <algorithm>
#include <cmath>

namespace tw {

ControlVolume::ControlVolume(const Box& box, double size, const Shape& shape)
    : box_(box), flat_(shape.dimensions == 2) {
    faces_.want_flux = true;
    count_ = (box_.size().array() / size).round().max(1).cast<int>();
    if (flat_) count_.y() = 1;
    cell_ = box_.size().array() / count_.cast<double>();
    const auto centre = [&](const Eigen::Array3i& c) {
        return Vec3(box_.min + ((c.cast<double>() + 0.5).matrix().cwiseProduct(cell_)));
    };
    const auto for_each = [](const Eigen::Array3i& count, const auto& f) {
        for (int k = 0; k < count.z(); ++k)
            for (int j = 0; j < count.y(); ++j)
                for (int i = 0; i < count.x(); ++i) f(Eigen::Array3i(i, j, k));
    };
    std::vector<char> taken;
    if (shape.takes) for_each(count_, [&](const Eigen::Array3i& c) { taken.push_back(shape.takes(centre(c))); });
    const auto inside = [&](const Eigen::Array3i& c) {
        if ((c < 0).any() || (c >= count_).any()) return false;
        return taken.empty() ||
               taken[static_cast<std::size_t>((std::int64_t{c.z()} * count_.y() + c.y()) * count_.x() + c.x())] != 0;
    };
    for_each(count_, [&](const Eigen::Array3i& c) {
        if (!inside(c)) return;
        for (int axis = 0; axis < 3; ++axis)
            for (const int side : {-1, 1}) {
                if (axis == 1 && flat_) continue;
                Eigen::Array3i other = c;
                other[axis] += side;
                if (inside(other)) continue;
                Vec3 at = centre(c), area = Vec3::Zero();
                at[axis] += 0.5 * side * cell_[axis];
                area[axis] = side * cell_.prod() / cell_[axis];
                faces_.places.push_back(at);
                area_.push_back(area);
            }
    });
    for_each(count_ + 1, [&](const Eigen::Array3i& c) {
        std::uint8_t corners = 0;
        for (int bit = 0; bit < 8; ++bit) {
            Eigen::Array3i cell = c - 1 + Eigen::Array3i(bit & 1, bit >> 1 & 1, bit >> 2);
            if (flat_) cell.y() = 0;
            if (shape.mirrored && cell.y() < 0) cell.y() = 0;
            if (inside(cell)) corners = static_cast<std::uint8_t>(corners | 1 << bit);
        }
        corners_.push_back(corners);
    });
}

double ControlVolume::between(std::uint8_t corners, const Vec3& part) {
    double share = 0;
    for (int bit = 0; bit < 8; ++bit)
        if (corners >> bit & 1)
            share += (bit & 1 ? part.x() : 1 - part.x()) * (bit & 2 ? part.y() : 1 - part.y()) *
                     (bit & 4 ? part.z() : 1 - part.z());
    return share;
}

void ControlVolume::add_impulse(double mass_inside, const Vec3& body_force, double dt) {
    Vec3 force = mass_inside * body_force;
    for (std::size_t k = 0; k < area_.size(); ++k) {
        const float* m = &faces_.flux[6 * k];
        Eigen::Matrix3f flux;
        flux << m[0], m[1], m[2], m[1], m[3], m[4], m[2], m[4], m[5];
        force -= flux.cast<double>() * area_[k];
    }
    state_.impulse += force * dt;
    state_.since += dt;
}

void ControlVolume::add_inside(const Particles& p, std::size_t i, Inside& inside) const {
    if (p.kind[i] == Kind::buffer) return;
    const double share_of_it = share(p.x[i], p.y[i], p.z[i]);
    if (share_of_it == 0) return;
    inside.momentum += share_of_it * Vec3(p.u[i], p.v[i], p.w[i]);
    inside.share += share_of_it;
}

}  // namespace tw
