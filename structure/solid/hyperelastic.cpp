#include "structure/solid/hyperelastic.h"

#include <fmt/format.h>

#include <cmath>
#include <Eigen/Geometry>
#include <Eigen/LU>

namespace tw::structure {
using Eigen::Matrix3d;

namespace {
double inner(const Matrix3d& a, const Matrix3d& b) { return a.cwiseProduct(b).sum(); }

/// I2 of C; its derivative by F is 2 (I1 F - F C).
double second_invariant(const Matrix3d& C) { return (C.trace() * C.trace() - inner(C, C)) / 2; }
}  // namespace

Matrix3d cofactor(const Matrix3d& F) {
    Matrix3d G;
    for (int k = 0; k < 3; ++k) G.col(k) = F.col((k + 1) % 3).cross(F.col((k + 2) % 3));
    return G;
}

Hyperelastic Hyperelastic::mooney_rivlin(double C10, double C01, double bulk, double density) {
    Hyperelastic m;
    m.C10 = C10;
    m.C01 = C01;
    m.bulk = bulk;
    m.density = density;
    return m;
}

Hyperelastic Hyperelastic::neo_hookean(double E, double nu, double density) {
    return mooney_rivlin(E / (4 * (1 + nu)), 0, E / (3 * (1 - 2 * nu)), density);
}

Hyperelastic Hyperelastic::saint_venant(double E, double nu, double density) {
    Hyperelastic m;
    m.kind = Kind::saint_venant;
    m.lambda = E * nu / ((1 + nu) * (1 - 2 * nu));
    m.mu = E / (2 * (1 + nu));
    m.density = density;
    return m;
}

double Hyperelastic::energy(const Matrix3d& F) const {
    const Matrix3d C = F.transpose() * F;
    if (kind == Kind::saint_venant) {
        const Matrix3d E = (C - Matrix3d::Identity()) / 2;
        return lambda / 2 * E.trace() * E.trace() + mu * inner(E, E);
    }
    const double a = std::pow(F.determinant(), -2.0 / 3);
    return C10 * (a * C.trace() - 3) + C01 * (a * a * second_invariant(C) - 3);
}

Matrix3d Hyperelastic::stress(const Matrix3d& F) const {
    const Matrix3d C = F.transpose() * F;
    if (kind == Kind::saint_venant) {
        const Matrix3d E = (C - Matrix3d::Identity()) / 2;
        return F * (lambda * E.trace() * Matrix3d::Identity() + 2 * mu * E);
    }
    const double J = F.determinant(), a = std::pow(J, -2.0 / 3), I1 = C.trace();
    const Matrix3d H = cofactor(F) / J;  // F^-T
    return 2 * C10 * a * (F - I1 / 3 * H) + 2 * C01 * a * a * (I1 * F - F * C - 2.0 / 3 * second_invariant(C) * H);
}

Matrix9 Hyperelastic::tangent(const Matrix3d& F) const {
    const Matrix3d C = F.transpose() * F;
    const double J = F.determinant(), I1 = C.trace(), I2 = second_invariant(C), a = std::pow(J, -2.0 / 3);
    const Matrix3d H = cofactor(F) / J, E = (C - Matrix3d::Identity()) / 2;
    Matrix9 A;
    for (int k = 0; k < 9; ++k) {  // the stress' change by each unit change of F
        Matrix3d dF = Matrix3d::Zero(), dP;
        dF(k % 3, k / 3) = 1;
        const Matrix3d dC = dF.transpose() * F + F.transpose() * dF;
        if (kind == Kind::saint_venant) {
            dP = dF * (lambda * E.trace() * Matrix3d::Identity() + 2 * mu * E) +
                 F * (lambda * dC.trace() / 2 * Matrix3d::Identity() + mu * dC);
        } else {
            const double t = inner(H, dF), dI1 = dC.trace(), dI2 = I1 * dI1 - inner(C, dC);  // dJ = J t
            const Matrix3d dH = -H * dF.transpose() * H;
            const Matrix3d first = F - I1 / 3 * H, second = I1 * F - F * C - 2.0 / 3 * I2 * H;
            dP = 2 * C10 * a * (-2.0 / 3 * t * first + dF - dI1 / 3 * H - I1 / 3 * dH) +
                 2 * C01 * a * a *
                     (-4.0 / 3 * t * second + dI1 * F + I1 * dF - dF * C - F * dC - 2.0 / 3 * (dI2 * H + I2 * dH));
        }
        A.col(k) = Eigen::Map<const Eigen::Matrix<double, 9, 1>>(dP.data());
    }
    return A;
}

std::string impossible(const Hyperelastic& m) {
    const bool mooney = m.kind == Hyperelastic::Kind::mooney_rivlin;
    const double shear = mooney ? 2 * (m.C10 + m.C01) : m.mu, bulk = mooney ? m.bulk : m.lambda + 2 * m.mu / 3;
    if (!(std::isfinite(shear) && shear > 0))
        return fmt::format("shear modulus {} Pa; expected a positive number", shear);
    if (!(std::isfinite(bulk) && bulk > 0))
        return fmt::format("bulk modulus {} Pa; expected a positive number (Poisson's ratio below 0.5)", bulk);
    if (mooney && (m.C10 < 0 || m.C01 < 0))
        return fmt::format("C10 = {} Pa and C01 = {} Pa; expected neither to be negative", m.C10, m.C01);
    if (!(std::isfinite(m.density) && m.density > 0))
        return fmt::format("density {} kg/m3; expected a positive number", m.density);
    return {};
}

}  // namespace tw::structure
