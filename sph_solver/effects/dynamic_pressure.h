#pragma once
#include <memory>

#include "sph_solver/equations/rest_pressure.h"

namespace tw {

class Effect;

/// Weight of water whose particles carry the pressure p' of equations/rest_pressure.h, in place of gravity. Ends the
/// run (RunError) where the free surface has come down into the band: the water there has no weight of its own any
/// more. A scene that asks for it together with cavitation is refused (InputError).
struct DynamicPressure {
    RestPressure at_rest;
};
std::unique_ptr<Effect> make_effect(const DynamicPressure& options);

}  // namespace tw
