#pragma once
#include <memory>

namespace tw {

class Effect;

/// Cavitation as a pressure cut-off: water bears no pressure below that of its vapour, p >= p_v - p_atm (gauge). No
/// bubbles are modelled: where the cut-off acts, the density falls below what the pressure says, and recovers as the
/// water is pressed together again.
struct Cavitation {
    double lowest_pressure = 2340 - 101325;  ///< gauge [Pa]
};
std::unique_ptr<Effect> make_effect(const Cavitation& options);

}  // namespace tw
