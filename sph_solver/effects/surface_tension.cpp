#include "sph_solver/effects/surface_tension.h"

#include <cmath>
#include <numbers>

#include "sph_solver/backend/for_particles.h"
#include "sph_solver/effects/registry.h"
#include "sph_solver/equations/surface_tension.h"

namespace tw {
namespace {

class ContinuumForce : public Effect {
public:
    explicit ContinuumForce(const SurfaceTension& options) : sigma_(options.sigma) {}

    void add_rates(const StepView& step) override {
        const std::size_t n = step.count();
        normal_.resize(n);
        curvature_.resize(n);
        length_.resize(n);
        for_pairs(step.passes, ColourGradientData{step.water, step.dummies, normal_.data()}, step.groups);
        step.halo.tell(normal_.data());
        for_particles(n, [&](std::size_t i) {
            VelocityDensityRecord& r = normal_[i];
            length_[i] = std::sqrt(r.u * r.u + r.v * r.v + r.w * r.w);
            const bool counts = double(length_[i]) * step.h > smallest_colour_gradient;
            const float inv = counts ? 1 / length_[i] : 0;
            r = {r.u * inv, r.v * inv, r.w * inv, counts ? 1.0f : 0.0f};
        });
        step.ghosts.refresh<Law::vector>(normal_, n);
        for_pairs(step.passes, CurvatureData{step.water, normal_.data(), curvature_.data()}, step.groups);
        const SurfaceForce force(sigma_, step.mass);
        for_particles(n, [&](std::size_t i) {
            const float f = force.along_normal(step.water.place[i].volume, curvature_[i], length_[i]);
            RateRecord& rate = step.rate[i];
            rate.ax += f * normal_[i].u;
            rate.ay += f * normal_[i].v;
            rate.az += f * normal_[i].w;
        });
    }
    /// Capillary waves of the kernel's length (Brackbill et al. 1992): dt < 0.25 sqrt(rho h^3 / (2 pi sigma)).
    double largest_step(const LevelSetup& setup, double h) const override {
        return 0.25 * std::sqrt(setup.rho0 * h * h * h / (2 * std::numbers::pi * sigma_));
    }
    std::size_t bytes() const override {
        return normal_.capacity() * sizeof(VelocityDensityRecord) +
               (curvature_.capacity() + length_.capacity()) * sizeof(float);
    }

private:
    double sigma_;
    std::vector<VelocityDensityRecord> normal_;
    std::vector<float> curvature_, length_;
};

}  // namespace

std::unique_ptr<Effect> make_effect(const SurfaceTension& options) { return std::make_unique<ContinuumForce>(options); }

void effect_of_scene::surface_tension(const Scene& scene, const Surroundings&, const LevelSetup&, EffectOptions& on) {
    if (scene.effect_on("surface_tension")) on.push_back(SurfaceTension{scene.water.surface_tension});
}

}  // namespace tw
