#include "sph_solver/effects/surface_tension.h"

#include <cmath>
#include <numbers>

#include "sph_solver/backend/for_particles.h"
#include "sph_solver/domain/level_setup.h"
#include "sph_solver/effects/passes.h"

namespace tw {
namespace {

constexpr double smallest_normal = 0.15;  ///< |grad C| h from which a particle has a normal

class ContinuumForce : public Effect {
public:
    explicit ContinuumForce(const SurfaceTension& options) : sigma_(options.sigma) {}

    void add_rates(const StepView& step) override {
        const std::size_t n = step.count();
        normal_.resize(n);
        curvature_.resize(n);
        length_.resize(n);
        ColourData c;
        c.water = &step.pass;
        c.normal = normal_.data();
        c.curvature = curvature_.data();
        for_pairs(step.passes.colour_gradient, c, step.groups);
#pragma omp parallel for schedule(static)
        for (std::size_t i = 0; i < n; ++i) {
            VelocityDensityRecord& r = normal_[i];
            length_[i] = std::sqrt(r.u * r.u + r.v * r.v + r.w * r.w);
            const bool counts = double(length_[i]) * step.h > smallest_normal;
            const float inv = counts ? 1 / length_[i] : 0;
            r = {r.u * inv, r.v * inv, r.w * inv, counts ? 1.0f : 0.0f};
        }
        step.ghosts.refresh<Law::vector>(normal_, n);
        c.normal = normal_.data();
        for_pairs(step.passes.surface_curvature, c, step.groups);
#pragma omp parallel for schedule(static)
        for (std::size_t i = 0; i < n; ++i) {
            const float f =
                static_cast<float>(2 * sigma_ / step.mass) * step.pass.place[i].volume * curvature_[i] * length_[i];
            RateRecord& rate = step.pass.rate[i];
            rate.ax += f * normal_[i].u;
            rate.ay += f * normal_[i].v;
            rate.az += f * normal_[i].w;
        }
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

std::unique_ptr<Effect> make_surface_tension(const SurfaceTension& options) {
    return std::make_unique<ContinuumForce>(options);
}

}  // namespace tw
