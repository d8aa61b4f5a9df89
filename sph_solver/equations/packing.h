#pragma once

namespace tw {

/// Beside solids density follows the packing of the particles. Shifting moves particles without the continuity equation
/// knowing it. Along a solid it does so for ever: the water creeps into the solid, shifting carries the particles back
/// out, continuity counts the first of the two alone, and what it makes of that is evened out by the density diffusion.
/// So density and packing no longer agree, the pressure does not show it, and still water shrinks and stirs itself. The
/// Shepard sum S_i = sum_j V_j W_ij, solids counted, is 1 where the particles stand as their densities say. Therefore
///
///   drho_i/dt += k c0/h rho0 e_i,   e_i = S_i - 1 less the play where it is above it or below minus it; else 0
///
/// where shifting acts and a solid is within 2h - dp/2: S_i > 0.95, no free surface within 2h. Crowded water is pressed
/// out from the solid, and water that is too thin takes more in, within some h / (k U) of a flow of U = c0/10. Away
/// from solids shifting has no such partner, and the term would put the noise of S_i into the pressure.
///
/// k and the play are calibrated, on water at rest round solids (docs/decisions/065): with k = 0.005 particles caught
/// in an inner corner ring, and particles in disorder have sums so far from 1 (+0.002 with h/dp = 1.55, -0.001 with 2).
struct Packing {
    static constexpr double k = 0.05;
    static constexpr float play = 0.002f, inside = 0.95f;

    /// e_i; `surface2`: |N_i|^2 of keep_along_surface() in shifting.h, 0 where no free surface is within 2h.
    static float excess(float support, float surface2) {
        if (support <= inside || surface2 > 0) return 0;
        const float e = support - 1.0f;
        return e > play ? e - play : e < -play ? e + play : 0.0f;
    }
};

}  // namespace tw
