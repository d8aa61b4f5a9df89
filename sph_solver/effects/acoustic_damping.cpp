#include "sph_solver/effects/acoustic_damping.h"

#include "sph_solver/domain/level_setup.h"

namespace tw {
namespace {

class Damper : public Effect {
public:
    explicit Damper(const AcousticDamping& options) : alpha2_(options.alpha2) {}

    void change_pressure(const StepView& step) override {
        const float factor = static_cast<float>(alpha2_ * step.level.state_equation.c0 * step.h);
#pragma omp parallel for schedule(static)
        for (std::size_t i = 0; i < step.count(); ++i)
            if (follows_the_equations(step.particles.kind[i]) && !step.at_surface(i))
                step.pass.stress[i].p += factor * step.pass.rate[i].drho;
    }
    /// Explicit diffusion of div u with the diffusivity alpha2 c0 h.
    double largest_step(const LevelSetup& setup, double h) const override {
        return 0.25 * h / (alpha2_ * setup.state_equation.c0);
    }

private:
    double alpha2_;
};

}  // namespace

std::unique_ptr<Effect> make_acoustic_damping(const AcousticDamping& options) {
    return std::make_unique<Damper>(options);
}

}  // namespace tw
