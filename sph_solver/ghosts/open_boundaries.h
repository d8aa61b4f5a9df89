#pragma once
#include <cstdint>
#include <vector>

#include "sph_solver/domain/surroundings.h"
#include "sph_solver/fields/particles.h"

namespace tw {

/// What left and entered since the start, in particles.
struct Ledger {
    std::int64_t in = 0, out = 0, lost = 0;
    std::int64_t held = 0;     ///< times that a particle was stopped at a wall (Level::hold_at_wall), not particles
    std::int64_t next_id = 0;  ///< of the next particle that enters
};

/// Particles that have crossed a face of the domain: at the inlet they become water and a new one is appended behind
/// them, at the outlet they are carried on; those beyond a mirror plane or a periodic face return. Counts what enters.
struct Crossed {
    /// A mark for each particle that has left (through the outlet's far end, back into the inlet, or the open top).
    std::vector<char> gone;
    std::vector<std::int32_t> entered;  ///< those that have become water, in order; a new one for each is at the end
};
Crossed cross_open_boundaries(const Surroundings& around, double dp, Particles& particles, Ledger& ledger);

/// A particle that has crossed a plane or periodic face has changed places with its own image: puts it back. Returns
/// how many.
std::int64_t return_from_mirrors(const Mirrors& mirrors, const Box& domain, Particles& particles);

}  // namespace tw
