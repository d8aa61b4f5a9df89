#pragma once
#include <Eigen/Core>
#include <vector>

#include "structure/solid/hyperelastic.h"
#include "structure/tyre.h"

namespace tw::structure {

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
