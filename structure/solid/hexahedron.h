#pragma once
#include <array>
#include <Eigen/Core>

#include "base/vec3.h"
#include "structure/solid/hyperelastic.h"

namespace tw::structure {

/// Eight-node hexahedron, total Lagrangian, eight Gauss points, with one mean volume ratio for all of them (Q1P0: Simo,
/// Taylor & Pister 1985, doi:10.1016/0045-7825(85)90033-7), so that it does not lock where the volume hardly changes:
///
///   Pi(x) = sum_q W(F_q) w_q + U(Jbar) V,   F_q = sum_i x_i grad N_i(X_q),   Jbar = v / V
///   f_i   = dPi/dx_i = sum_q (P(F_q) + U'(Jbar) cof F_q) grad N_i w_q
///
/// Forces are the exact gradient of this energy. Deviatoric strain is integrated in full: there are no hourglass modes,
/// but an element bends stiffly (parasitic shear); a thin wall takes four elements or more, or a shell.
class Hexahedron {
public:
    using Vector24 = Eigen::Matrix<double, 24, 1>;
    using Matrix24 = Eigen::Matrix<double, 24, 24>;
    using Corners = Eigen::Matrix<double, 3, 8>;  ///< places of the nodes [m], in VTK's order

    /// Throws InputError where the reference element is inverted or has no volume at a Gauss point.
    explicit Hexahedron(const Corners& reference);

    double volume() const { return weight_.sum(); }                                  ///< reference [m3]
    const Eigen::Matrix<double, 8, 1>& node_volume() const { return node_volume_; }  ///< integrals of N_i [m3]

    double energy(const Corners& x, const Hyperelastic& material) const;  ///< [J]
    /// Internal forces f_i [N]: what the nodes have to be loaded with. NaN if a Gauss point is turned inside out.
    Vector24 force(const Corners& x, const Hyperelastic& material) const;
    Matrix24 tangent(const Corners& x, const Hyperelastic& material) const;  ///< d force / d x [N/m]

    Eigen::Matrix3d deformation_gradient(const Corners& x, int gauss_point) const;
    double volume_ratio(const Corners& x) const;  ///< Jbar [-]

private:
    std::array<Eigen::Matrix<double, 8, 3>, 8> gradient_;  ///< of N_i by X, at each Gauss point [1/m]
    Eigen::Matrix<double, 8, 1> weight_, node_volume_;
};

}  // namespace tw::structure
