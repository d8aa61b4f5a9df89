#pragma once
#include <optional>
#include <utility>

namespace tw {

/// A prismatic planing hull in fresh or sea water.
struct PlaningState {
    double beam = 0;                                                    ///< [m]
    double deadrise = 0, trim = 0;                                      ///< [rad]
    double speed = 0;                                                   ///< [m/s]
    double density = 1000, kinematic_viscosity = 1e-6, gravity = 9.81;  ///< [kg/m3], [m2/s], [m/s2]
};

/// Savitsky, "Hydrodynamic design of planing hulls", Marine Technology 1(1), 1964, with ITTC-57 friction, no roughness
/// allowance:
///
///   CL0    = trim_deg^1.1 (0.012 lambda^0.5 + 0.0055 lambda^2.5 / Cv^2)       Cv = U / sqrt(g b)
///   CLbeta = CL0 - 0.0065 beta_deg CL0^0.6                                    lift = CLbeta 1/2 rho U^2 b^2
///   drag   = lift tan(trim) + Df / cos(trim)
///   Df     = Cf 1/2 rho Vm^2 lambda b^2 / cos(beta)                           Vm: mean bottom velocity
///
/// A fit to towing-tank data, good to about +-10 % inside 0.6 <= Cv <= 13, 2 <= trim <= 15 degrees, lambda <= 4. Measured
/// lifts of two models at five conditions lie above it by the factors measured_over_savitsky
/// (tests/data/planing_lift_measured.csv).
struct Savitsky {
    double lambda = 0;                                                ///< mean wetted length over beam [-]
    double keel_wetted_length = 0, chine_wetted_length = 0;           ///< [m]; chine < 0: chines dry, outside the fit
    double lift = 0, pressure_drag = 0, friction_drag = 0, drag = 0;  ///< [N]
    double pressure_centre = 0;                                       ///< forward of the transom, along the keel [m]
    bool in_range = false;
};
/// At speeds Cv of 1.7 to 4, trims of 4 degrees, 17 and 20 degrees of deadrise: smallest and largest factor [-].
inline constexpr double measured_over_savitsky[] = {1.07, 1.19};
/// `lambda`: mean wetted length over beam [-].
Savitsky savitsky(const PlaningState& state, double lambda);
/// From the wetted length along the keel [m]; the chine's is shorter by b tan(beta) / (pi tan(trim)).
Savitsky savitsky_at_keel(const PlaningState& state, double keel);
/// From the draft of the keel at the transom [m]: keel wet over draft / sin(trim).
Savitsky savitsky_at_draft(const PlaningState& state, double draft);

/// Where the hull's weight and centre of gravity stand along and above the keel.
struct PlaningMass {
    double weight = 0;        ///< [N]
    double lcg = 0, vcg = 0;  ///< ahead of the transom, above the keel [m]
    bool friction = true;     ///< counts in the moment
};
/// The running attitude of a free hull that is towed through its centre of gravity, `state.trim` set aside: the trim from
/// half a degree to 15 and the wetted length up to six beams at which the lift carries the weight and the moments about
/// the centre of gravity cancel,
///
///   lift / cos(trim) (Lp - lcg) = Df (vcg - b/4 tan(beta)),   Lp: pressure_centre
///
/// (the friction acts half way up the bottom). Nothing where no trim balances it.
std::optional<std::pair<PlaningState, Savitsky>> savitsky_free(PlaningState state, const PlaningMass& mass);

}  // namespace tw
