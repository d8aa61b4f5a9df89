#include "structure/shell/mitc4.h"

#include <fmt/format.h>

#include <cmath>
#include <Eigen/LU>

#include "base/errors.h"

namespace tw::structure {
namespace {
using Eigen::Matrix2d, Eigen::Vector2d, Eigen::Vector4d;
using Row = Eigen::Matrix<double, 1, 24>;

constexpr double xi_of[] = {-1, 1, 1, -1}, eta_of[] = {-1, -1, 1, 1};
const double gauss = 1 / std::sqrt(3.0);

/// Stiffness of the rotation about the normal over the section's in-plane shear stiffness [-].
constexpr double drilling = 1e-3;

Vector4d shape(double xi, double eta) {
    Vector4d N;
    for (int i = 0; i < 4; ++i) N[i] = (1 + xi * xi_of[i]) * (1 + eta * eta_of[i]) / 4;
    return N;
}

/// Rows: derivatives of the shape functions by xi and by eta.
Eigen::Matrix<double, 2, 4> shape_gradient(double xi, double eta) {
    Eigen::Matrix<double, 2, 4> d;
    for (int i = 0; i < 4; ++i) {
        d(0, i) = xi_of[i] * (1 + eta * eta_of[i]) / 4;
        d(1, i) = eta_of[i] * (1 + xi * xi_of[i]) / 4;
    }
    return d;
}

/// Covariant transverse shear gamma_xi (direction 0) or gamma_eta (1), compatible, at one place.
Row covariant_shear(const Eigen::Matrix<double, 4, 2>& xy, int direction, double xi, double eta) {
    const Eigen::RowVector4d d = shape_gradient(xi, eta).row(direction);
    const Vector4d N = shape(xi, eta);
    const Eigen::RowVector2d tangent = d * xy;
    Row g = Row::Zero();
    for (int i = 0; i < 4; ++i) {
        g[6 * i + 2] = d[i];
        g[6 * i + 3] = -N[i] * tangent[1];
        g[6 * i + 4] = N[i] * tangent[0];
    }
    return g;
}
}  // namespace

Mitc4::Mitc4(const std::array<Vec3, 4>& corners, const Vec3& along) {
    centre_ = (corners[0] + corners[1] + corners[2] + corners[3]) / 4;
    const Vec3 across = (corners[2] - corners[0]).cross(corners[3] - corners[1]);
    const double size = (corners[2] - corners[0]).norm() * (corners[3] - corners[1]).norm();
    if (!(across.norm() > 1e-9 * size)) throw InputError("a shell element without area");
    const Vec3 z = across.normalized(), x = along - along.dot(z) * z;
    if (!(x.norm() > 1e-6 * along.norm()))
        throw InputError("the laminate's x axis stands across a shell element; expected one that lies along it");
    axes_.row(0) = x.normalized();
    axes_.row(2) = z;
    axes_.row(1) = z.cross(x.normalized());

    local_.setZero();
    for (int i = 0; i < 4; ++i) {
        const Vec3 p = axes_ * (corners[static_cast<std::size_t>(i)] - centre_);
        xy_.row(i) = p.head<2>();
        auto block = local_.block<6, 6>(6 * i, 6 * i);
        block.topLeftCorner<3, 3>() = block.bottomRightCorner<3, 3>() = axes_;
        // The rigid link from the node down to the plane, r = (0, 0, -z): u_corner = u_node + theta x r.
        block.block<1, 3>(0, 3) = -p.z() * axes_.row(1);
        block.block<1, 3>(1, 3) = p.z() * axes_.row(0);
    }
    node_area_.setZero();
    for (const double eta : {-gauss, gauss})
        for (const double xi : {-gauss, gauss})
            node_area_ += shape(xi, eta) * (shape_gradient(xi, eta) * xy_).determinant();
    for (int i = 0; i < 4; ++i)
        if (const double det = (shape_gradient(xi_of[i], eta_of[i]) * xy_).determinant(); !(det > 1e-9 * size))
            throw InputError(
                fmt::format("a shell element whose corner {} at ({:.6g}, {:.6g}, {:.6g}) m does not turn "
                            "outward; expected a convex element",
                            i + 1, corners[static_cast<std::size_t>(i)].x(), corners[static_cast<std::size_t>(i)].y(),
                            corners[static_cast<std::size_t>(i)].z()));
}

Vec3 Mitc4::place(double xi, double eta) const {
    const Eigen::RowVector2d p = shape(xi, eta).transpose() * xy_;
    return centre_ + axes_.transpose() * Vec3(p[0], p[1], 0);
}

Eigen::Vector2d Mitc4::coordinates(const Vec3& point) const {
    const Vector2d p = (axes_ * (point - centre_)).head<2>();
    Vector2d at = Vector2d::Zero();
    for (int k = 0; k < 20; ++k) {  // Newton; a parallelogram needs one step
        const Vector2d miss = p - (shape(at[0], at[1]).transpose() * xy_).transpose();
        const Matrix2d J = shape_gradient(at[0], at[1]) * xy_;
        const Vector2d step = J.transpose().inverse() * miss;
        if (!(step.norm() < 10)) return Vector2d::Constant(10);  // far outside
        at += step;
        if (step.norm() < 1e-12) break;
    }
    return at;
}

Mitc4::Strains Mitc4::strains(double xi, double eta) const {
    const Eigen::Matrix<double, 2, 4> d_xi = shape_gradient(xi, eta);
    const Matrix2d J = d_xi * xy_, inverse = J.inverse();
    const Eigen::Matrix<double, 2, 4> d = inverse * d_xi;
    Strains B = Strains::Zero();
    for (int i = 0; i < 4; ++i) {
        const int c = 6 * i;
        B(0, c) = B(2, c + 1) = d(0, i);
        B(1, c + 1) = B(2, c) = d(1, i);
        B(3, c + 4) = d(0, i);
        B(4, c + 3) = -d(1, i);
        B(5, c + 4) = d(1, i);
        B(5, c + 3) = -d(0, i);
    }
    Eigen::Matrix<double, 2, 24> covariant;
    covariant.row(0) = (1 - eta) / 2 * covariant_shear(xy_, 0, 0, -1) + (1 + eta) / 2 * covariant_shear(xy_, 0, 0, 1);
    covariant.row(1) = (1 - xi) / 2 * covariant_shear(xy_, 1, -1, 0) + (1 + xi) / 2 * covariant_shear(xy_, 1, 1, 0);
    B.bottomRows<2>() = inverse * covariant;
    return B * local_;
}

Mitc4::Matrix24 Mitc4::stiffness(const Eigen::Matrix<double, 8, 8>& section) const {
    Matrix24 K = Matrix24::Zero();
    for (const double eta : {-gauss, gauss})
        for (const double xi : {-gauss, gauss}) {
            const Eigen::Matrix<double, 2, 4> d_xi = shape_gradient(xi, eta);
            const Matrix2d J = d_xi * xy_;
            const double weight = J.determinant();
            const Strains B = strains(xi, eta);
            K += weight * B.transpose() * section * B;

            const Eigen::Matrix<double, 2, 4> d = J.inverse() * d_xi;
            const Vector4d N = shape(xi, eta);
            Row spin = Row::Zero();  // theta_z - (v,x - u,y) / 2
            for (int i = 0; i < 4; ++i) {
                spin[6 * i] = d(1, i) / 2;
                spin[6 * i + 1] = -d(0, i) / 2;
                spin[6 * i + 5] = N[i];
            }
            spin *= local_;
            K += weight * drilling * section(2, 2) * spin.transpose() * spin;
        }
    return K;
}

}  // namespace tw::structure
