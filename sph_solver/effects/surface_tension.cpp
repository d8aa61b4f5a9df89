#include "sph_solver/effects/surface_tension.h"

#include <cmath>
#include <numbers>

#include "sph_solver/effects/registry.h"
#include "sph_solver/effects/surface_tension_loops.h"

namespace tw {
namespace {

class ContinuumForce : public Effect {
public:
    explicit ContinuumForce(const SurfaceTension& options) : sigma_(options.sigma) {}

    void add_rates(const StepView& step) override {
        const OwnSums<PackedVelocityDensity> gradient = step.sums(normal_, step.n + step.images);
        const OwnSums<float> curvature = step.sums(curvature_, step.n);
        float* const length = length_.resize(step.device, step.n);
        step.pairs(ColourGradientData{step.water, step.dummies, gradient});
        PackedVelocityDensity* const normal = step.exchange(gradient);
        step.each(step.n, NormalOfSurface{normal, length, step.h});
        step.refresh<Law::vector>(normal);
        step.pairs(CurvatureData{step.water, normal, curvature});
        step.each(step.n, PullAtSurface{SurfaceForce(sigma_, step.mass), step.water.place, normal,
                                        step.for_rates(curvature), length, step.rate});
    }
    /// Capillary waves of the kernel's length (Brackbill et al. 1992): dt < 0.25 sqrt(rho h^3 / (2 pi sigma)).
    double largest_step(const LevelSetup& setup, double h) const override {
        return 0.25 * std::sqrt(setup.rho0 * h * h * h / (2 * std::numbers::pi * sigma_));
    }
    std::size_t bytes() const override { return normal_.bytes() + curvature_.bytes() + length_.bytes(); }

private:
    double sigma_;
    LoopArray<PackedVelocityDensity> normal_;
    LoopArray<float> curvature_, length_;
};

}  // namespace

std::unique_ptr<Effect> make_effect(const SurfaceTension& options) { return std::make_unique<ContinuumForce>(options); }

void effect_of_scene::surface_tension(const Scene& scene, const Surroundings&, const LevelSetup&, EffectOptions& on) {
    if (scene.effect_on("surface_tension")) on.push_back(SurfaceTension{scene.water.surface_tension});
}

}  // namespace tw
