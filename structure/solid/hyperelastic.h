#pragma once
#include <Eigen/Core>
#include <string>

namespace tw::structure {

using Matrix9 = Eigen::Matrix<double, 9, 9>;

/// An elastic solid by its stored energy per reference volume [Pa], split so that the volume can be taken as the mean
/// of an element (hexahedron.h): of the deformation gradient F with J = det F,
///
///   mooney_rivlin:  C10 (J^-2/3 I1 - 3) + C01 (J^-4/3 I2 - 3)  +  K/2 (J - 1)^2
///                   I1 = tr C, I2 = (tr^2 C - tr C^2) / 2, C = F^T F   (Mooney 1940; Bonet & Wood 2008, 6.5)
///   saint_venant:   lambda/2 tr^2 E + mu E:E, E = (C - 1) / 2; all of it at each point, nothing by the mean
///
/// A neo-Hookean rubber is mooney_rivlin with C01 = 0; at small strain its shear modulus is 2 (C10 + C01).
struct Hyperelastic {
    enum class Kind { mooney_rivlin, saint_venant };
    Kind kind = Kind::mooney_rivlin;
    double C10 = 0, C01 = 0;    ///< mooney_rivlin [Pa]
    double bulk = 0;            ///< K [Pa]
    double lambda = 0, mu = 0;  ///< saint_venant [Pa]
    double density = 0;         ///< in the reference state [kg/m3]

    static Hyperelastic mooney_rivlin(double C10, double C01, double bulk, double density);
    /// Nearly incompressible where nu comes near 0.5; small strains are those of E and nu.
    static Hyperelastic neo_hookean(double E, double nu, double density);
    static Hyperelastic saint_venant(double E, double nu, double density);

    /// Without the volume's part: energy [Pa], first Piola-Kirchhoff stress dW/dF [Pa] and its derivative by F,
    /// matrices as columns of nine, column by column.
    double energy(const Eigen::Matrix3d& F) const;
    Eigen::Matrix3d stress(const Eigen::Matrix3d& F) const;
    Matrix9 tangent(const Eigen::Matrix3d& F) const;

    /// The volume's part: energy [Pa] and pressure-like stress dU/dJ [Pa] of a volume ratio J.
    double volume_energy(double J) const { return bulk / 2 * (J - 1) * (J - 1); }
    double volume_stress(double J) const { return bulk * (J - 1); }
};

/// Why no material has these constants; empty if one can: shear modulus, bulk modulus and density are positive and
/// finite, and C10 and C01 are not negative.
std::string impossible(const Hyperelastic& material);

/// cof F = J F^-T, the derivative of J by F; finite also where J = 0.
Eigen::Matrix3d cofactor(const Eigen::Matrix3d& F);

}  // namespace tw::structure
