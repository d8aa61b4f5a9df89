#pragma once
#include <cstdint>
#include <memory>

#include "sph_solver/pair_loops/own_sums.h"
#include "sph_solver/pair_loops/views.h"

namespace tw {

class Effect;

/// Walls hold no water under tension where air can come: beside a wall the free surface moves up along it as far as the
/// pressure would be below the air's, and the water leaves there, which in the limit is smooth separation (Brillouin
/// 1911, Villat 1914). A particle bears no tension (its density is not let below rho0) where air is at it:
///
///   at the free surface, where air was at it before or is at a particle within the kernel's support;
///   within `reach_over_dp` dp of a wall, where rho <= rho0, air was at it before or is at a particle within the
///     kernel's support, and sum_j V_j W_ij (rho_j - rho0) <= 0 over those round it that no air is at.
///
/// So air comes from where it is, along the surface and along the wall, not to a place with pressure and not into a
/// void that opens deep in the water; and no particle lets it in whose own density is low by chance. At the start, and
/// when a particle is new, it is at all that are at the free surface.
struct Ventilation {
    float reach_over_dp = 2;  ///< how far air is looked for [dp]
};
std::unique_ptr<Effect> make_effect(const Ventilation& options);

/// What is within the kernel's support of a particle.
enum class Round : std::uint8_t {
    no_air = 0,
    air = 1,
    air_and_tension = 2  ///< and the water that no air is at is not under pressure in the mean
};
struct NearAirData {
    WaterView water{};  ///< its `surface` marks those that air is at
    OwnSums<Round> round{};
};

}  // namespace tw
