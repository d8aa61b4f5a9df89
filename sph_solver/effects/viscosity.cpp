#include "sph_solver/effects/viscosity.h"

#include <algorithm>
#include <cmath>

#include "sph_solver/backend/for_particles.h"
#include "sph_solver/bodies/walls.h"
#include "sph_solver/domain/level_setup.h"
#include "sph_solver/domain/surroundings.h"
#include "sph_solver/effects/passes.h"

namespace tw {
namespace {

constexpr double kappa = 0.41;

class PhysicalViscosity : public Effect {
public:
    explicit PhysicalViscosity(const Viscosity& options) : o_(options) {}

    void add_rates(const StepView& step) override {
        const double rho0 = step.level.rho0;
        mu_.assign(step.count(), static_cast<float>(rho0 * o_.kinematic));
        largest_ = o_.kinematic;
        PassData water = step.pass;
        const bool tank_holds = o_.no_slip && step.around.mirrors.any_holds();
        if (tank_holds) {  // images of the tank's walls move against the water
            motion_.assign(step.pass.motion, step.pass.motion + step.count());
            step.ghosts.refresh<Law::held>(motion_, step.count());
            water.motion = motion_.data();
        }
        if (o_.turbulence) add_eddies(step, water, tank_holds);
        step.ghosts.refresh<Law::scalar>(mu_, step.count());

        ViscousData v;
        v.water = &water;
        v.mu = mu_.data();
        if (o_.no_slip && !step.walls.empty()) {
            find_wall_velocity(step);
            v.wall_velocity = wall_velocity_.data();
            wall_load_.resize(step.walls.group_load_count());
            v.wall_load = wall_load_.data();
        }
        for_pairs(step.passes.viscous_forces, v, step.groups);
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
        return std::max(0.0, distance);
    }

    void add_eddies(const StepView& step, const PassData& water, bool tank_holds) {
        strain_.resize(step.count());
        StrainData s;
        s.water = &water;
        s.strain = strain_.data();
        for_pairs(step.passes.strain_rate, s, step.groups);
        const double filter = o_.turbulence->cs * step.level.dp;
        double largest = 0;
#pragma omp parallel for schedule(static) reduction(max : largest)
        for (std::size_t i = 0; i < step.count(); ++i) {
            double length = filter;
            if (o_.no_slip && !step.walls.empty())
                length = std::min(length, kappa * std::max(0.0, double(step.pass.normal[i].distance)));
            if (tank_holds) length = std::min(length, kappa * from_tank(step, i));
            const double nu = length * length * double(strain_[i]);
            mu_[i] += static_cast<float>(step.level.rho0 * nu);
            largest = std::max(largest, nu);
        }
        largest_ += largest;
    }

    void find_wall_velocity(const StepView& step) {
        wall_velocity_.assign(step.walls.size(), VelocityDensityRecord{0, 0, 0, 0});
        for (const Walls::Part& part : step.walls.parts()) {
            VelocityData w;
            w.list = part.water.view();
            w.at = step.pass.wall_place + part.first;
            w.water = &step.pass;
            w.velocity = wall_velocity_.data() + part.first;
            for_pairs(step.passes.water_velocity, w, part.near_water);
        }
#pragma omp parallel for schedule(static)
        for (std::size_t k = 0; k < wall_velocity_.size(); ++k) {
            VelocityDensityRecord& m = wall_velocity_[k];
            VelocityDensityRecord wall{0, 0, 0, 0};
            if (!step.walls.sliding().empty()) wall = step.walls.sliding()[k];
            if (const WallVelocity* moving = step.walls.velocities())
                wall.u += moving[k].u, wall.v += moving[k].v, wall.w += moving[k].w;
            m = {2 * wall.u - m.u, 2 * wall.v - m.v, 2 * wall.w - m.w, m.drho};
        }
    }

    Viscosity o_;
    double largest_ = 0;  ///< largest kinematic viscosity of the last step [m2/s]
    std::vector<float> mu_, strain_;
    std::vector<VelocityDensityRecord> wall_velocity_, motion_;
    std::vector<WallLoad> wall_load_;
};

}  // namespace

std::unique_ptr<Effect> make_viscosity(const Viscosity& options) {
    return std::make_unique<PhysicalViscosity>(options);
}

}  // namespace tw
