#pragma once

namespace tw {

/// Slow water under a quiet free surface: the particles carry the dynamic pressure, and the weight of the water is
/// taken from them. With the pressure p = p' + P(z) and a fixed field P the momentum equation of incompressible water
/// keeps its form, with p' in place of p and another weight:
///
///   du/dt = -grad p' / rho0 - (g + P'(z) / rho0) e_z + ...
///   P(z)  = S(s) (rho0 g (z_s - z) - b),   S(s) = s^2 (3 - 2 s),   s = clamp((z_a - z) / (z_a - z_b), 0, 1)
///
/// z_s: height of the still surface, z_a and z_b: the band in which P rises. Above z_a nothing is changed, so the
/// surface has its weight and bears no pressure; below z_b water at rest has the pressure b and no weight.
///
/// Among particles in disorder the pair forces of a pressure p err by a share of p, however small its gradient is. In a
/// viscous flow of mu U/L the weight of deep water is hundreds of times that, and the drag of a body two times too high
/// (docs/decisions/065-water-at-the-start.md).
struct RestPressure {
    double surface = 0, top = 0, bottom = 0;  ///< z_s, z_a, z_b [m]
    double weight = 0;                        ///< rho0 g [N/m3]
    double left = 0;                          ///< b [Pa]

    double at(double z) const { return share(z) * (weight * (surface - z) - left); }  ///< P(z) [Pa]
    /// p' of water at rest [Pa]; 0 above the surface.
    double carried(double z) const { return z < surface ? weight * (surface - z) - at(z) : 0; }
    /// -(g + P'(z) / rho0) [m/s2].
    double acceleration(double z, double rho0) const {
        const double s = depth_in_overlap(z), slope = 6 * s * (1 - s) / (top - bottom);
        return (slope * (weight * (surface - z) - left) - weight * (1 - share(z))) / rho0;
    }
    bool in_band(double z) const { return z > bottom && z < top; }

private:
    double depth_in_overlap(double z) const {
        const double s = (top - z) / (top - bottom);
        return s < 0 ? 0 : s > 1 ? 1 : s;
    }
    double share(double z) const {
        const double s = depth_in_overlap(z);
        return s * s * (3 - 2 * s);
    }
};

}  // namespace tw
