#pragma once
#include <functional>
#include <memory>
#include <vector>

#include "sph_solver/effects/effect.h"

namespace tw {

struct Scene;

/// An effect that is on, with its parameters: those of effects/NAME.h, which declares `make_effect` for them.
class EffectOn {
public:
    template <class Parameters>
    EffectOn(const Parameters& parameters) : make_([parameters] { return make_effect(parameters); }) {}
    std::unique_ptr<Effect> make() const { return make_(); }

private:
    std::function<std::unique_ptr<Effect>()> make_;
};

/// The effects that are on, in the order of their calls.
struct EffectOptions : std::vector<EffectOn> {
    using std::vector<EffectOn>::vector;
};

/// Those of a scene, see registry.h.
EffectOptions effects_of(const Scene& scene, const Surroundings& around, const LevelSetup& water);

}  // namespace tw
