#include "sph_solver/effects/acoustic_damping.h"

#include "sph_solver/effects/acoustic_damping_loops.h"
#include "sph_solver/effects/registry.h"

namespace tw {
namespace {

class Damper : public Effect {
public:
    explicit Damper(const AcousticDamping& options) : alpha2_(options.alpha2) {}

    void change_pressure(const StepView& step) override {
        const float factor = static_cast<float>(alpha2_ * step.level.state_equation.c0 * step.h);
        step.each(step.n, DampSound{step.stress, step.rate, step.kind, step.water.surface, factor});
    }
    /// Explicit diffusion of div u with the diffusivity alpha2 c0 h.
    double largest_step(const LevelSetup& setup, double h) const override {
        return 0.25 * h / (alpha2_ * setup.state_equation.c0);
    }

private:
    double alpha2_;
};

}  // namespace

std::unique_ptr<Effect> make_effect(const AcousticDamping& options) { return std::make_unique<Damper>(options); }

void effect_of_scene::acoustic_damping(const Scene& scene, const Surroundings&, const LevelSetup&, EffectOptions& on) {
    if (scene.effect_on("acoustic_damping")) on.push_back(AcousticDamping{scene.sph.acoustic_damping});
}

}  // namespace tw
