#include "structure/laminate.h"

#include <fmt/format.h>

#include <cmath>

#include "base/errors.h"

namespace tw::structure {
namespace {
using Eigen::Matrix2d, Eigen::Matrix3d, Eigen::Vector2d, Eigen::Vector3d;

/// Engineering strains (xx, yy, xy) to those in axes turned by `angle` about z.
Matrix3d strain_turn(double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return Matrix3d{{c * c, s * s, c * s}, {s * s, c * c, -c * s}, {-2 * c * s, 2 * c * s, c * c - s * s}};
}

/// (gamma_xz, gamma_yz) to (gamma_13, gamma_23).
Matrix2d shear_turn(double angle) {
    const double c = std::cos(angle), s = std::sin(angle);
    return Matrix2d{{c, s}, {-s, c}};
}

/// Plane-stress stiffness in the material's axes [Pa].
Matrix3d plane_stress(const PlyMaterial& m) {
    const double d = 1 - m.nu12 * m.nu12 * m.E2 / m.E1, q12 = m.nu12 * m.E2 / d;
    return Matrix3d{{m.E1 / d, q12, 0}, {q12, m.E2 / d, 0}, {0, 0, m.G12}};
}

Matrix2d transverse(const PlyMaterial& m) { return Vector2d(m.G13, m.G23).asDiagonal(); }

constexpr double shear_correction = 5.0 / 6;
}  // namespace

Laminate::Laminate(std::vector<Ply> bottom_to_top) : plies_(std::move(bottom_to_top)) {
    if (plies_.empty()) throw InputError("a laminate without layers; expected one or more");
    for (std::size_t k = 0; k < plies_.size(); ++k) {
        const Ply& p = plies_[k];
        if (!(std::isfinite(p.thickness) && p.thickness > 0) || !std::isfinite(p.angle))
            throw InputError(fmt::format("layer {}: thickness {} m at {} rad; expected a positive thickness", k + 1,
                                         p.thickness, p.angle));
        if (const std::string why = impossible(p.material); !why.empty())
            throw InputError(fmt::format("layer {}: {}", k + 1, why));
        thickness_ += p.thickness;
    }
    A_ = B_ = D_ = Matrix3d::Zero();
    S_ = Matrix2d::Zero();
    double z = -thickness_ / 2;
    for (const Ply& p : plies_) {
        const double t = p.thickness, m = z + t / 2;  // of this layer
        const Matrix3d turn = strain_turn(p.angle), Q = turn.transpose() * plane_stress(p.material) * turn;
        const Matrix2d cross = shear_turn(p.angle);
        A_ += t * Q;
        B_ += t * m * Q;                         // (z_top^2 - z_bottom^2) / 2
        D_ += (t * m * m + t * t * t / 12) * Q;  // (z_top^3 - z_bottom^3) / 3
        S_ += shear_correction * t * cross.transpose() * transverse(p.material) * cross;
        areal_mass_ += p.material.density * t;
        rotary_inertia_ += p.material.density * (t * m * m + t * t * t / 12);
        bottom_.push_back(z);
        z += t;
    }
}

Eigen::Matrix<double, 8, 8> Laminate::stiffness() const {
    Eigen::Matrix<double, 8, 8> C = Eigen::Matrix<double, 8, 8>::Zero();
    C.block<3, 3>(0, 0) = A_;
    C.block<3, 3>(0, 3) = C.block<3, 3>(3, 0) = B_;
    C.block<3, 3>(3, 3) = D_;
    C.block<2, 2>(6, 6) = S_;
    return C;
}

PlyState Laminate::state(const Eigen::Matrix<double, 8, 1>& strains, int ply, double height) const {
    const auto k = static_cast<std::size_t>(ply);
    const Ply& p = plies_.at(k);
    const double z = bottom_[k] + height * p.thickness;
    PlyState s;
    s.strain = strain_turn(p.angle) * (strains.segment<3>(0) + z * strains.segment<3>(3));
    s.stress = plane_stress(p.material) * s.strain;
    s.shear_strain = shear_turn(p.angle) * strains.segment<2>(6);
    s.shear_stress = transverse(p.material) * s.shear_strain;
    return s;
}

}  // namespace tw::structure
