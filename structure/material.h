#pragma once
#include <string>

namespace tw::structure {

/// An elastic layer in plane stress with its stiff direction along 1: a unidirectional or woven ply, or, with equal
/// constants, an isotropic sheet.
struct PlyMaterial {
    double E1 = 0, E2 = 0;             ///< Young's moduli along 1 and 2 [Pa]
    double nu12 = 0;                   ///< strain along 2 by stress along 1, over the strain along 1, reversed [-]
    double G12 = 0, G13 = 0, G23 = 0;  ///< shear moduli: in the plane, and across the thickness [Pa]
    double density = 0;                ///< [kg/m3]
};

/// E [Pa], Poisson's ratio [-], density [kg/m3].
PlyMaterial isotropic(double E, double nu, double density);

/// Why no material has these constants; empty if one can. Moduli and density are positive and finite, and the strain
/// energy of every strain is positive: nu12^2 < E1 / E2 (Lempriere 1968, doi:10.2514/3.4910); an isotropic nu lies
/// between -1 and 0.5, which G12 = E / (2 (1 + nu)) makes the same as G12 > E / 3.
std::string impossible(const PlyMaterial& material);

}  // namespace tw::structure
