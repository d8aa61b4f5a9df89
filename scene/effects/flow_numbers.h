#pragma once
#include <cmath>
#include <string>

#include "scene/scene.h"

namespace tw {

/// The dimensionless numbers from which effects are planned, of the wetted length (the water's height without a hull)
/// and the speed of the stream (in a tank: of a fall from the water's height).
struct FlowNumbers {
    double length = 0, speed = 0, wetted_area = 0;  ///< [m], [m/s], [m2]
    double head = 0;                                ///< rho U^2/2 [Pa]
    double reynolds = INFINITY, weber = INFINITY, weber_dp = INFINITY, froude = 0, mach = 0, bond = INFINITY;
    double released = 0;           ///< height of water that is let go at the start [m]; 0: none
    double dry_floor = 0;          ///< share of a tank's floor that its front runs over [-]; 0: none
    double cavitation = INFINITY;  ///< (p_atm + rho g d - p_v) / head at the deepest place
};
FlowNumbers flow_numbers(const Scene& scene);

/// Skin friction coefficient of a flat plate, ITTC 1957: 0.075 / (log10 Re - 2)^2; for Re > 1e4, else 0.
double ittc57(double reynolds);

/// "Re = 1.2e+06", or that the water has no viscosity.
std::string reynolds_text(const FlowNumbers& n);

/// A share in the words of the plan: "1.2 %".
std::string per_cent(double share);

}  // namespace tw
