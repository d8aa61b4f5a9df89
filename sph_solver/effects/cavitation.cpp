#include "sph_solver/effects/cavitation.h"

#include "sph_solver/effects/cavitation_loops.h"
#include "sph_solver/effects/registry.h"

namespace tw {
namespace {

class CutOff : public Effect {
public:
    explicit CutOff(const Cavitation& options) : lowest_(static_cast<float>(options.lowest_pressure)) {}

    void change_pressure(const StepView& step) override { step.each(step.n, CutOffTension{step.stress, lowest_}); }

private:
    float lowest_;
};

}  // namespace

std::unique_ptr<Effect> make_effect(const Cavitation& options) { return std::make_unique<CutOff>(options); }

void effect_of_scene::cavitation(const Scene& scene, const Surroundings&, const LevelSetup&, EffectOptions& on) {
    if (scene.effect_on("cavitation"))
        on.push_back(Cavitation{scene.water.vapour_pressure - scene.water.atmospheric_pressure});
}

}  // namespace tw
