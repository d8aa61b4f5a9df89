#pragma once
#include <vector>

#include "scene/scene.h"

namespace tw {

// Hydraulics of a channel of rectangular section and horizontal bed, per metre of its width (Chow, Open-Channel
// Hydraulics, 1959, chapters 3, 15 and 17).

/// Depth of a stream that carries q [m2/s] with the least energy: h_c^3 = q^2 / g [m].
double critical_depth(double q, double gravity);
/// Height of the energy line above the bed: h + U^2 / 2 g [m].
double specific_energy(double depth, double speed, double gravity);
/// Behind a hydraulic jump in a stream of Froude number F > 1, h2 / h1 = (sqrt(1 + 8 F^2) - 1) / 2; the same formula
/// gives the depth before a jump from that behind it [m].
double conjugate_depth(double depth, double speed, double gravity);
/// What a gate that is open by `opening` lets through at the energy E ahead of it, with its contraction [m2/s]:
///
///   q = c b sqrt(2 g (E - c b)),   c = 0.61
double through_gate(double opening, double energy, double gravity);
inline constexpr double contraction_of_gate = 0.61;  ///< of a sharp edge; measured ones are 0.59 to 0.62

/// Of a stream without a hull, by the obstacles that reach across it, as findings of level warning:
///   choked         it has not the energy to carry its water over a weir or through a gate: the level ahead will rise
///   gate_too_wide  a gate in whose free jet the water leaves lets more through than comes: the level ahead will fall
///   jump_moves     the depth behind is not the conjugate one of a jump in a channel without obstacles
std::vector<Finding> channel_flow(const Scene& scene);

}  // namespace tw
