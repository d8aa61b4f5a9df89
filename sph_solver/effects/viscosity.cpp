#include "sph_solver/effects/viscosity.h"

#include <algorithm>

#include "sph_solver/effects/registry.h"
#include "sph_solver/effects/viscosity_loops.h"

namespace tw {
namespace {

class PhysicalViscosity : public Effect {
public:
    explicit PhysicalViscosity(const Viscosity& options) : o_(options) {}

    void add_rates(const StepView& step) override {
        const std::size_t n = step.n, all = n + step.images;
        float* const mu = mu_.resize(step.device, all);
        step.each(n, SetViscosity{mu, static_cast<float>(step.level.rho0 * o_.kinematic)});
        largest_ = o_.kinematic;
        WaterView water = step.water;
        if (o_.no_slip && step.around.mirrors.any_holds()) {  // images of the tank's walls move against the water
            PackedVelocityDensity* const motion = motion_.resize(step.device, all);
            step.each(n, CopyMotion{water.motion, motion});
            step.refresh<Law::held>(motion);
            water.motion = motion;
        }
        if (o_.turbulence) add_eddies(step, water, mu);
        step.refresh<Law::scalar>(mu);

        ViscousForceData v{.water = water, .walls = {}, .mu = mu, .rate = step.rate};
        const bool bodies_hold = o_.no_slip && step.dummies.place;
        if (bodies_hold) {
            v.walls = step.dummies;
            v.wall_velocity = find_wall_velocity(step);
            v.wall_load = wall_load_.resize(step.device, step.wall_load_count);
        }
        step.pairs(v);
        if (bodies_hold) wall_load_.copy_to_host();
    }

    /// Explicit diffusion: dt < 0.125 h^2 / nu (Morris et al. 1997).
    double largest_step(const LevelSetup&, double h) const override {
        return 0.125 * h * h / std::max(largest_, o_.kinematic);
    }
    const std::vector<WallLoad>& wall_loads() const override { return wall_load_.on_host(); }
    std::size_t bytes() const override {
        return mu_.bytes() + strain_.bytes() + wall_velocity_.bytes() + motion_.bytes() + wall_load_.bytes();
    }

private:
    void add_eddies(const StepView& step, const WaterView& water, float* mu) {
        const OwnSums<float> sums = step.sums(strain_, step.n);
        step.pairs(StrainRateData{water, sums});
        const float* const strain = step.exchange(sums);
        AddEddies add{.p = step.p,
                      .strain = strain,
                      .wall = o_.no_slip && step.dummies.place ? step.dummies.normal : nullptr,
                      .low = {},
                      .high = {},
                      .holds = {},
                      .filter = o_.turbulence->cs * step.level.dp,
                      .rho0 = step.level.rho0,
                      .mu = mu};
        for (std::size_t a = 0; a < 3; ++a) {
            const auto axis = static_cast<Eigen::Index>(a);
            add.low[a] = step.around.domain.min[axis], add.high[a] = step.around.domain.max[axis];
            for (std::size_t side = 0; side < 2; ++side)
                add.holds[a][side] = o_.no_slip && step.around.mirrors.holding[a][side];
        }
        largest_ += step.ranks.largest(step.largest(step.n, add));
    }

    const PackedVelocityDensity* find_wall_velocity(const StepView& step) {
        const OwnSums<PackedVelocityDensity> sums = step.zero_sums(wall_velocity_, step.dummy_count);
        for (const StepView::DummiesOfBody& body : step.bodies)
            step.pairs(WaterVelocityData{.water = step.water,
                                         .list = body.water,
                                         .at = step.dummies.place + body.first,
                                         .velocity = sums.from(body.first)},
                       body.clusters);
        PackedVelocityDensity* const velocity = step.exchange_at_dummies(sums);
        step.each(step.dummy_count, HoldAtWalls{velocity, step.sliding, step.dummies.velocity});
        return velocity;
    }

    Viscosity o_;
    double largest_ = 0;  ///< largest kinematic viscosity of the last step [m2/s]
    LoopArray<float> mu_, strain_;
    LoopArray<PackedVelocityDensity> wall_velocity_, motion_;
    LoopArray<WallLoad> wall_load_;
};

}  // namespace

std::unique_ptr<Effect> make_effect(const Viscosity& options) { return std::make_unique<PhysicalViscosity>(options); }

void effect_of_scene::viscosity(const Scene& scene, const Surroundings&, const LevelSetup&, EffectOptions& on) {
    if (!scene.effect_on("viscosity")) return;
    Viscosity viscosity{scene.water.kinematic_viscosity, scene.effect_on("no_slip"), {}};
    if (scene.effect_on("turbulence")) viscosity.turbulence = EddyViscosity{scene.sph.smagorinsky};
    on.push_back(viscosity);
}

}  // namespace tw
