#include "sph_solver/effects/viscosity.h"

#include <algorithm>
#include <cmath>

#include "sph_solver/backend/for_particles.h"
#include "sph_solver/bodies/walls.h"
#include "sph_solver/effects/registry.h"
#include "sph_solver/equations/smagorinsky.h"
#include "sph_solver/equations/viscosity.h"

namespace tw {
namespace {

class PhysicalViscosity : public Effect {
public:
    explicit PhysicalViscosity(const Viscosity& options) : o_(options) {}

    void add_rates(const StepView& step) override {
        const double rho0 = step.level.rho0;
        mu_.assign(step.count(), static_cast<float>(rho0 * o_.kinematic));
        largest_ = o_.kinematic;
        WaterView water = step.water;
        const bool tank_holds = o_.no_slip && step.around.mirrors.any_holds();
        if (tank_holds) {  // images of the tank's walls move against the water
            motion_.assign(step.water.motion, step.water.motion + step.count());
            step.ghosts.refresh<Law::held>(motion_, step.count());
            water.motion = motion_.data();
        }
        if (o_.turbulence) add_eddies(step, water, tank_holds);
        step.ghosts.refresh<Law::scalar>(mu_, step.count());

        ViscousForceData v{.water = water, .walls = {}, .mu = mu_.data(), .rate = step.rate};
        if (o_.no_slip && !step.walls.empty()) {
            find_wall_velocity(step);
            v.walls = step.dummies;
            v.wall_velocity = wall_velocity_.data();
            wall_load_.resize(step.walls.group_load_count());
            v.wall_load = wall_load_.data();
        }
        for_pairs(step.passes, v, step.groups);
    }

    /// Explicit diffusion: dt < 0.125 h^2 / nu (Morris et al. 1997).
    double largest_step(const LevelSetup&, double h) const override {
        return 0.125 * h * h / std::max(largest_, o_.kinematic);
    }
    const std::vector<WallLoad>& wall_loads() const override { return wall_load_; }
    std::size_t bytes() const override {
        return (mu_.capacity() + strain_.capacity()) * sizeof(float) +
               (wall_velocity_.capacity() + motion_.capacity()) * sizeof(VelocityDensityRecord) +
               wall_load_.capacity() * sizeof(WallLoad);
    }

private:
    /// Distance of a particle from the nearest wall of the tank that holds the water [m].
    static double from_tank(const StepView& step, std::size_t i) {
        const Mirrors& mirrors = step.around.mirrors;
        const Box& box = step.around.domain;
        const double place[3] = {step.particles.x[i], step.particles.y[i], step.particles.z[i]};
        double distance = HUGE_VAL;
        for (std::size_t a = 0; a < 3; ++a) {
            const auto axis = static_cast<Eigen::Index>(a);
            if (mirrors.holding[a][0]) distance = std::min(distance, place[a] - box.min[axis]);
            if (mirrors.holding[a][1]) distance = std::min(distance, box.max[axis] - place[a]);
        }
        return distance;
    }

    void add_eddies(const StepView& step, const WaterView& water, bool tank_holds) {
        strain_.resize(step.count());
        for_pairs(step.passes, StrainRateData{water, strain_.data()}, step.groups);
        step.halo.tell(strain_.data());
        const double filter = o_.turbulence->cs * step.level.dp;
        largest_ += step.ranks.largest(largest_of(step.count(), 0, [&](std::size_t i) {
            double length = filter;
            if (o_.no_slip && !step.walls.empty())
                length = mixing_length_at_wall(length, double(step.dummies.normal[i].distance));
            if (tank_holds) length = mixing_length_at_wall(length, from_tank(step, i));
            const double nu = eddy_viscosity(length, double(strain_[i]));
            mu_[i] += static_cast<float>(step.level.rho0 * nu);
            return nu;
        }));
    }

    void find_wall_velocity(const StepView& step) {
        wall_velocity_.assign(step.walls.size(), VelocityDensityRecord{0, 0, 0, 0});
        for (const Walls::Part& part : step.walls.parts()) {
            const WaterVelocityData w{.water = step.water,
                                      .list = part.water.view(),
                                      .at = step.dummies.place + part.first,
                                      .velocity = wall_velocity_.data() + part.first};
            for_pairs(step.passes, w, part.near_water);
        }
        step.walls.halo().tell(wall_velocity_.data());
        for_particles(wall_velocity_.size(), [&](std::size_t k) {
            VelocityDensityRecord& m = wall_velocity_[k];
            VelocityDensityRecord wall{0, 0, 0, 0};
            if (!step.walls.sliding().empty()) wall = step.walls.sliding()[k];
            if (const WallVelocity* moving = step.walls.velocities())
                wall.u += moving[k].u, wall.v += moving[k].v, wall.w += moving[k].w;
            const V3<float> u_d = no_slip_velocity(V3<float>{wall.u, wall.v, wall.w}, V3<float>{m.u, m.v, m.w});
            m = {u_d.x, u_d.y, u_d.z, m.drho};
        });
    }

    Viscosity o_;
    double largest_ = 0;  ///< largest kinematic viscosity of the last step [m2/s]
    std::vector<float> mu_, strain_;
    std::vector<VelocityDensityRecord> wall_velocity_, motion_;
    std::vector<WallLoad> wall_load_;
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
