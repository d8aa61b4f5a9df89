#include "structure/solid/hexahedron.h"

#include <fmt/format.h>

#include <cmath>
#include <Eigen/LU>

#include "base/errors.h"

namespace tw::structure {
namespace {
constexpr double corner[8][3] = {{-1, -1, -1}, {1, -1, -1}, {1, 1, -1}, {-1, 1, -1},
                                 {-1, -1, 1},  {1, -1, 1},  {1, 1, 1},  {-1, 1, 1}};
}  // namespace

Hexahedron::Hexahedron(const Corners& reference) {
    const double gauss = 1 / std::sqrt(3.0);
    const double size = std::pow((reference.colwise() - reference.rowwise().mean().eval()).norm(), 3);
    node_volume_.setZero();
    for (int q = 0; q < 8; ++q) {
        Eigen::Matrix<double, 8, 1> N;
        Eigen::Matrix<double, 8, 3> d;
        for (int i = 0; i < 8; ++i) {
            double f[3];
            for (int k = 0; k < 3; ++k) f[k] = (1 + gauss * corner[q][k] * corner[i][k]) / 2;
            N[i] = f[0] * f[1] * f[2];
            for (int k = 0; k < 3; ++k) d(i, k) = corner[i][k] / 2 * f[(k + 1) % 3] * f[(k + 2) % 3];
        }
        const Eigen::Matrix3d J = reference * d;
        weight_[q] = J.determinant();
        if (!(weight_[q] > 1e-9 * size))
            throw InputError(fmt::format("a hexahedron that is inverted or has no volume near its corner {}", q + 1));
        gradient_[static_cast<std::size_t>(q)] = d * J.inverse();
        node_volume_ += weight_[q] * N;
    }
}

Eigen::Matrix3d Hexahedron::deformation_gradient(const Corners& x, int q) const {
    return x * gradient_[static_cast<std::size_t>(q)];
}

double Hexahedron::volume_ratio(const Corners& x) const {
    double v = 0;
    for (int q = 0; q < 8; ++q) v += weight_[q] * deformation_gradient(x, q).determinant();
    return v / volume();
}

double Hexahedron::energy(const Corners& x, const Hyperelastic& material) const {
    double sum = material.volume_energy(volume_ratio(x)) * volume();
    for (int q = 0; q < 8; ++q) sum += weight_[q] * material.energy(deformation_gradient(x, q));
    return sum;
}

Hexahedron::Vector24 Hexahedron::force(const Corners& x, const Hyperelastic& material) const {
    const double p = material.volume_stress(volume_ratio(x));
    Corners f = Corners::Zero();
    for (int q = 0; q < 8; ++q) {
        const Eigen::Matrix3d F = deformation_gradient(x, q);
        f += weight_[q] * (material.stress(F) + p * cofactor(F)) * gradient_[static_cast<std::size_t>(q)].transpose();
    }
    return Eigen::Map<const Vector24>(f.data());
}

Hexahedron::Matrix24 Hexahedron::tangent(const Corners& x, const Hyperelastic& material) const {
    const double p = material.volume_stress(volume_ratio(x));
    Matrix24 K = Matrix24::Zero();
    Corners dv = Corners::Zero();  // of the element's volume by its nodes
    for (int q = 0; q < 8; ++q) {
        const auto& g = gradient_[static_cast<std::size_t>(q)];
        const Eigen::Matrix3d F = deformation_gradient(x, q);
        Matrix9 A = material.tangent(F);
        for (int k = 0; k < 9; ++k) {  // p d(cof F): column c of cof F is F_(c+1) x F_(c+2)
            Eigen::Matrix3d dF = Eigen::Matrix3d::Zero(), dG;
            dF(k % 3, k / 3) = 1;
            for (int c = 0; c < 3; ++c) {
                const int m = (c + 1) % 3, n = (c + 2) % 3;
                dG.col(c) = dF.col(m).cross(F.col(n)) + F.col(m).cross(dF.col(n));
            }
            A.col(k) += p * Eigen::Map<const Eigen::Matrix<double, 9, 1>>(dG.data());
        }
        for (int i = 0; i < 8; ++i)
            for (int j = 0; j < 8; ++j)
                for (int a = 0; a < 3; ++a)
                    for (int b = 0; b < 3; ++b)
                        K.block<3, 3>(3 * i, 3 * j) += weight_[q] * g(i, a) * g(j, b) * A.block<3, 3>(3 * a, 3 * b);
        dv += weight_[q] * cofactor(F) * g.transpose();
    }
    const Eigen::Map<const Vector24> d(dv.data());
    return K + material.bulk / volume() * d * d.transpose();
}

}  // namespace tw::structure
