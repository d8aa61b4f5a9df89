#include "structure/shell/corotational.h"

#include <cmath>
#include <Eigen/Geometry>

namespace tw::structure {
namespace {
using Eigen::Matrix3d;

Matrix3d rotation(const Vec3& turn) {
    const double angle = turn.norm();
    return angle < 1e-300 ? Matrix3d(Matrix3d::Identity()) : Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix();
}

/// The vector of a rotation, at most pi long.
Vec3 turn_of(const Matrix3d& R) {
    const Eigen::Quaterniond q(R);
    const double sine = q.vec().norm(), angle = 2 * std::atan2(sine, std::abs(q.w()));
    return (sine < 1e-12 ? 2.0 : angle / sine) * (q.w() < 0 ? -1.0 : 1.0) * q.vec();
}

/// How the vector r of a rotation changes by a further turn omega about fixed axes: dr = H omega (Felippa & Haugen
/// 2005).
Matrix3d turn_rate(const Vec3& r) {
    const double a = r.norm();
    const double eta = a < 1e-3 ? 1.0 / 12 + a * a / 720 : (1 - a / 2 / std::tan(a / 2)) / (a * a);
    Matrix3d S;
    S << 0, -r.z(), r.y(), r.z(), 0, -r.x(), -r.y(), r.x(), 0;
    return Matrix3d::Identity() - S / 2 + eta * S * S;
}
}  // namespace

Corotational::Corotational(const Shell& shell) : shell_(&shell) {
    const auto section = shell.laminate().stiffness();
    for (const Mitc4& element : shell.elements()) stiffness_.push_back(element.stiffness(section));
}

Vec3 Corotational::corner(std::size_t e, int i) const {
    return shell_->mesh().nodes[static_cast<std::size_t>(shell_->mesh().quads[e][static_cast<std::size_t>(i)])];
}

Corotational::Frame Corotational::frame(const Vector24& u, std::size_t e) const {
    const Mitc4& element = shell_->elements()[e];
    Frame f;
    Vec3 c = Vec3::Zero();
    for (int i = 0; i < 4; ++i) {
        f.y[static_cast<std::size_t>(i)] = corner(e, i) + u.segment<3>(6 * i);
        c += f.y[static_cast<std::size_t>(i)] / 4;
    }
    for (Vec3& y : f.y) y -= c;
    // First the turn that takes the normal along the shortest way, then the best fit about it.
    const Vec3 z = (f.y[2] - f.y[0]).cross(f.y[3] - f.y[1]).normalized();
    const Matrix3d tilt = Eigen::Quaterniond::FromTwoVectors(element.normal(), z).toRotationMatrix();
    double sine = 0, cosine = 0;
    for (int i = 0; i < 4; ++i) {
        const Vec3 r = tilt * (corner(e, i) - element.centre()), &y = f.y[static_cast<std::size_t>(i)];
        sine += r.cross(y).dot(z);
        cosine += r.dot(y) - r.dot(z) * y.dot(z);
    }
    f.Q = Eigen::AngleAxisd(std::atan2(sine, cosine), z).toRotationMatrix() * tilt;
    return f;
}

Corotational::Vector24 Corotational::deformation(const Frame& f, const Vector24& u, std::size_t e) const {
    Vector24 d;
    for (int i = 0; i < 4; ++i) {
        const Vec3 X = corner(e, i) - shell_->elements()[e].centre();
        d.segment<3>(6 * i) = f.Q.transpose() * f.y[static_cast<std::size_t>(i)] - X;
        d.segment<3>(6 * i + 3) = turn_of(f.Q.transpose() * rotation(u.segment<3>(6 * i + 3)));
    }
    return d;
}

Corotational::Vector24 Corotational::force(const Vector24& u, std::size_t e) const {
    const Frame f = frame(u, e);
    const Vector24 d = deformation(f, u, e), local = stiffness_[e] * d;
    Vector24 force;
    Vec3 left = Vec3::Zero();  // moment of all about the centre, as the element lies now
    double inertia = 0;
    const Vec3 n = (f.y[2] - f.y[0]).cross(f.y[3] - f.y[1]), z = n.normalized();
    std::array<Vec3, 4> r;
    for (int i = 0; i < 4; ++i) {
        const auto k = static_cast<std::size_t>(i);
        force.segment<3>(6 * i) = f.Q * local.segment<3>(6 * i);
        force.segment<3>(6 * i + 3) =
            f.Q * turn_rate(d.segment<3>(6 * i + 3)).transpose() * local.segment<3>(6 * i + 3);
        left += f.y[k].cross(force.segment<3>(6 * i)) + force.segment<3>(6 * i + 3);
        r[k] = f.Q * (corner(e, i) - shell_->elements()[e].centre());
        r[k] -= r[k].dot(z) * z;
        inertia += r[k].dot(f.y[k]);
    }
    // The frame's turn by its corners' places: across, z x dz with dz = (da x b + a x db) / |n|, a = y2 - y0,
    // b = y3 - y1; about the normal, that of the best fit. What is left does its work on that turn.
    const Vec3 a = f.y[2] - f.y[0], b = f.y[3] - f.y[1], about = left.cross(z) / n.norm();
    const Vec3 by_a = b.cross(about), by_b = about.cross(a);  // of left . (z x dz) by a and b
    const Vec3 across[4] = {-by_a, -by_b, by_a, by_b};
    Vec3 mean = Vec3::Zero();
    std::array<Vec3, 4> correction;
    for (int i = 0; i < 4; ++i) {
        const auto k = static_cast<std::size_t>(i);
        correction[k] = across[i] + left.dot(z) * z.cross(r[k]) / inertia;
        mean += correction[k] / 4;
    }
    for (int i = 0; i < 4; ++i) force.segment<3>(6 * i) -= correction[static_cast<std::size_t>(i)] - mean;
    return force;
}

Eigen::VectorXd Corotational::internal_force(const Eigen::VectorXd& u) const {
    Eigen::VectorXd all = Eigen::VectorXd::Zero(u.size());
    for (std::size_t e = 0; e < stiffness_.size(); ++e) {
        const Vector24 f = force(shell_->of_element(u, static_cast<int>(e)), e);
        for (int i = 0; i < 4; ++i)
            all.segment<6>(6 * shell_->mesh().quads[e][static_cast<std::size_t>(i)]) += f.segment<6>(6 * i);
    }
    return all;
}

SparseMatrix Corotational::tangent(const Eigen::VectorXd& u) const {
    std::vector<Eigen::Triplet<double>> entries;
    entries.reserve(stiffness_.size() * 576);
    for (std::size_t e = 0; e < stiffness_.size(); ++e) {
        const auto& quad = shell_->mesh().quads[e];
        const Vector24 at = shell_->of_element(u, static_cast<int>(e));
        const double length = std::sqrt(shell_->elements()[e].area());
        for (int j = 0; j < 24; ++j) {
            const double step = 1e-6 * (j % 6 < 3 ? length : 1);
            Vector24 by = Vector24::Zero();
            by[j] = step;
            const Vector24 column = (force(moved(at, by), e) - force(moved(at, -by), e)) / (2 * step);
            for (int i = 0; i < 24; ++i)
                entries.emplace_back(6 * quad[static_cast<std::size_t>(i / 6)] + i % 6,
                                     6 * quad[static_cast<std::size_t>(j / 6)] + j % 6, column[i]);
        }
    }
    SparseMatrix K(u.size(), u.size());
    K.setFromTriplets(entries.begin(), entries.end());
    return K;
}

Eigen::VectorXd Corotational::moved(const Eigen::VectorXd& u, const Eigen::VectorXd& by) const {
    Eigen::VectorXd to = u + by;
    for (int n = 3; n < u.size(); n += 6)
        to.segment<3>(n) = turn_of(rotation(by.segment<3>(n)) * rotation(u.segment<3>(n)));
    return to;
}

Eigen::Matrix<double, 24, 1> Corotational::deformation(const Eigen::VectorXd& u, int element) const {
    const auto e = static_cast<std::size_t>(element);
    const Vector24 at = shell_->of_element(u, element);
    return deformation(frame(at, e), at, e);
}

double Corotational::energy(const Eigen::VectorXd& u) const {
    double sum = 0;
    for (std::size_t e = 0; e < stiffness_.size(); ++e) {
        const Vector24 d = deformation(u, static_cast<int>(e));
        sum += d.dot(stiffness_[e] * d) / 2;
    }
    return sum;
}

}  // namespace tw::structure
