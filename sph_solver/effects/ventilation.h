#pragma once
#include <cstdint>
#include <memory>

#include "sph_solver/sweeps/views.h"

namespace tw {

class Effect;

/// Walls hold no water under tension where air can come: beside a wall the free surface moves up along it as far as the
/// pressure would be below the air's, and the water leaves there, which in the limit is smooth separation (Brillouin
/// 1911, Villat 1914). A particle bears no tension (its density is not let below rho0) where air is at it:
///
///   at the free surface, where air was at it before or is at a particle within the kernel's support;
///   at a wall, where the same holds and
///     its distance from the wall < `reach_over_dp` dp,   its kernel support S < `support`,   rho <= rho0.
///
/// So air comes from where it is, along the surface and along the wall, not to a place with pressure and not into a void
/// that opens deep in the water. At the start, and when a particle is new, it is at all that are at the free surface.
/// Calibrated: S < 0.99 (free jets, docs/results/separation.md); a kernel's support that a free surface cuts by more than
/// a hundredth.
struct Ventilation {
    float support = 0.99f, reach_over_dp = 2;
};
std::unique_ptr<Effect> make_effect(const Ventilation& options);

/// Whether air is at a particle within the kernel's support.
struct NearAirData {
    WaterView water{};  ///< its `surface` marks those that air is at
    std::uint8_t* near = nullptr;
};

}  // namespace tw
