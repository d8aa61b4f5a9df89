#pragma once
#include <string>

namespace tw {

/// One effect of the plan: whether it is solved, why, and its expected influence.
struct EffectChoice {
    std::string name;  ///< as in the registry (scene/effects/registry.h)
    bool on = false;
    bool forced = false;    ///< the user said so
    std::string reason;     ///< one sentence with the numbers
    std::string influence;  ///< estimated influence on drag, lift, splash
    double cost = 0;        ///< what it costs, or would cost, as a fraction of a particle run without it
};

}  // namespace tw
