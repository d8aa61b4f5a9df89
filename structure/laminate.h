#pragma once
#include <Eigen/Core>
#include <string>
#include <string_view>
#include <utility>
#include <vector>

#include "structure/material.h"

namespace tw::structure {

/// One layer of a stack.
struct Ply {
    PlyMaterial material;
    double angle = 0;      ///< of its direction 1 from the laminate's x axis, counter-clockwise about the normal [rad]
    double thickness = 0;  ///< [m]
};

/// Stresses or strains of a layer in its own axes: along 1, along 2, in the plane 12; and across: 13, 23. Shear strains
/// are engineering strains.
struct PlyState {
    Eigen::Vector3d strain, stress;              ///< 11, 22, 12 [-], [Pa]
    Eigen::Vector2d shear_strain, shear_stress;  ///< 13, 23 [-], [Pa]
};

/// A stack of layers about its mid-plane, from the bottom (z = -t/2) to the top, as classical laminate theory with
/// first-order shear deformation sees it (Reddy, Mechanics of Laminated Composite Plates and Shells, 2004, 3.4):
///
///   N = A eps0 + B kappa,  M = B eps0 + D kappa,  Q = S gamma
///   A, B, D = sum over layers of Qbar (z_top^n - z_bottom^n) / n,  n = 1, 2, 3
///   S = 5/6 sum of the layers' transverse shear stiffness times thickness
///
/// The factor 5/6 is that of a homogeneous section. A sandwich with a soft core is stiffer with it than it is.
class Laminate {
public:
    /// Throws InputError naming the layer: no layers, a thickness that is not positive, a material that cannot be.
    explicit Laminate(std::vector<Ply> bottom_to_top);

    const std::vector<Ply>& plies() const { return plies_; }
    double thickness() const { return thickness_; }    ///< [m]
    double areal_mass() const { return areal_mass_; }  ///< [kg/m2]
    /// Inertia of a unit area of the section about a line in its mid-plane: integral of rho z^2 [kg].
    double rotary_inertia() const { return rotary_inertia_; }

    const Eigen::Matrix3d& A() const { return A_; }  ///< [N/m]
    const Eigen::Matrix3d& B() const { return B_; }  ///< [N]
    const Eigen::Matrix3d& D() const { return D_; }  ///< [N m]
    const Eigen::Matrix2d& S() const { return S_; }  ///< on (gamma_xz, gamma_yz) [N/m]

    /// The section's stiffness on (eps0: xx yy xy, kappa: xx yy xy, gamma: xz yz), in the laminate's axes.
    Eigen::Matrix<double, 8, 8> stiffness() const;

    /// What layer `ply` feels at `height` of its thickness (0 bottom, 1 top) under those eight strains. The transverse
    /// shear is first-order theory's: constant through a layer, zero at no face.
    PlyState state(const Eigen::Matrix<double, 8, 1>& strains, int ply, double height) const;

private:
    std::vector<Ply> plies_;
    std::vector<double> bottom_;  ///< z of each layer's lower face [m]
    double thickness_ = 0, areal_mass_ = 0, rotary_inertia_ = 0;
    Eigen::Matrix3d A_, B_, D_;
    Eigen::Matrix2d S_;
};

/// Reads a stacking sequence as it is printed, bottom first: layers `ANGLE NAME` (degrees) between slashes, NAME with
/// an optional count of repeats in front, a trailing `s` mirrors: "[45 C1/0 2*C2/90 C2]s". `materials` gives each name
/// its material and thickness; their angle is ignored. Throws InputError naming the layer that cannot be read or has no
/// material.
std::vector<Ply> read_layup(std::string_view text, const std::vector<std::pair<std::string, Ply>>& materials);

}  // namespace tw::structure
