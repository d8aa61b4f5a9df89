#pragma once
#include <string>
#include <vector>

namespace tw {

/// How far the truth may lie from a computed value because a run leaves an effect out. Where the run has v, the truth is
/// expected between v (1 - below) and v (1 + above), or, of a bound with a unit of its own, between v - below and v +
/// above. A sign that is known makes one of the two zero.
struct EffectBound {
    /// Kind of quantity: drag, lift, splash, pressure (means; "pressure:NAME" of one gauge), peak (largest pressures, forces
    /// and strains of some milliseconds), height (largest), level (means), arrival, impulse, motion.
    std::string of;
    double below = 0, above = 0;  ///< not negative [unit]
    std::string unit = "-";       ///< "-": shares of the value, of its magnitude where it is negative
    std::string source = {};      ///< the formula, or where it was measured
    std::string elements =
        {};  ///< counts for methods whose solution is made of these alone ("particles"); empty: for all
};

/// One effect of the plan: whether it is solved, why, and its expected influence.
struct EffectChoice {
    std::string name;  ///< as in the registry (scene/effects/registry.h)
    bool on = false;
    bool forced = false;                   ///< the user said so
    std::string reason;                    ///< one sentence with the numbers
    std::string influence;                 ///< estimated influence on drag, lift, splash
    double cost = 0;                       ///< (would-be) cost as a fraction of a particle run without it [-]
    std::vector<EffectBound> bounds = {};  ///< of kinds of quantities, where a number is known
};

}  // namespace tw
