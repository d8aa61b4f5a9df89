#pragma once
#include <cstdint>

namespace tw {

/// What a particle is: moved by the equations, prescribed at the inlet, or carried out through the outlet; and where
/// levels of particle size meet (refinement/refinement.h), one that stands for the water of another level.
enum class Kind : std::uint8_t {
    fluid = 0,
    inlet = 1,
    outlet = 2,
    buffer = 3,   ///< round a level's own zone: moves with the fields of the next coarser level
    overlap = 4,  ///< under the zone of a finer level, near its edge: moved by the equations, then given its fields
    slave = 5     ///< deeper under it: given its fields only
};
/// Each place in the water belongs to one level, whose active particles are the water there.
constexpr bool is_active(Kind k) { return k <= Kind::outlet; }
constexpr bool stands_for_finer(Kind k) { return k == Kind::overlap || k == Kind::slave; }
constexpr bool follows_the_equations(Kind k) { return k == Kind::fluid || k == Kind::overlap; }
/// What stands for another level's water is kept out of solids as well: it may become active there.
constexpr bool kept_out_of_solids(Kind k) { return k != Kind::inlet && k != Kind::outlet; }

}  // namespace tw
