#pragma once
#include <Eigen/Core>
#include <vector>

#include "base/vec3.h"
#include "structure/solid/hyperelastic.h"
#include "structure/tyre.h"

namespace tw::structure {

/// Mooney-Rivlin constants [C10, C01, bulk modulus] in Pa of the study's tyre, which prints none. Those of tread and side
/// walls are the assumed ones of a soft rubber (0.8, 0.2 and 0.6, 0.15 MPa) times the one factor with which 800 N press
/// the tyre 10 mm flat (docs/results/tyre.md): they stand for rubber, cords and belt together. The inner tyre's are
/// assumed.
inline const Vec3 assumed_inner_tyre(0.336e6, 0, 33e6), calibrated_sidewall(2.98e6, 0.745e6, 100e6),
    calibrated_tread(3.975e6, 0.994e6, 100e6);

/// Displacements of all nodes of `tyre_mesh` under the air's pressure [Pa] inside, the rim held: in balance, and alike
/// all round, so that one section's radial and axial displacements are the unknowns. `rubbers`: by the mesh's material
/// numbers. Throws RunError where there is no balance: the pressure bursts the tyre.
Eigen::VectorXd blown_up(const Tyre& tyre, const std::vector<Hyperelastic>& rubbers, double pressure);

/// A tyre pressed on a rigid plane.
struct Pressed {
    double deflection = 0;  ///< how much nearer the axle is than where the plane was first touched [m]
    double load = 0;        ///< [N]
    double patch = 0;       ///< length of the contact along the plane [m]
};

/// The blown up tyre in balance at rising deflections [m] on a plane without friction (solid/plane_contact.h, with its
/// stiffness [Pa/m]). Solved of one half, from the lowest section to the highest. Throws RunError where there is no
/// balance.
std::vector<Pressed> press(const Tyre& tyre, const std::vector<Hyperelastic>& rubbers, double pressure,
                           double contact_stiffness, const std::vector<double>& deflections);

}  // namespace tw::structure
