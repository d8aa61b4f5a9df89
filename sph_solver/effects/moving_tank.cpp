#include "sph_solver/effects/moving_tank.h"

#include "sph_solver/backend/for_particles.h"
#include "sph_solver/effects/registry.h"

namespace tw {
namespace {

class ForcesOfMotion : public Effect {
public:
    void add_rates(const StepView& step) override {
        const Particles& p = step.particles;
        const FrameForce force = step.around.force(step.time);
        const Vec3 gravity = step.around.gravity;
        for_particles(p.size(), [&](std::size_t i) {
            if (!follows_the_equations(p.kind[i])) return;
            const Vec3 more = force.at({p.x[i], p.y[i], p.z[i]}, {p.u[i], p.v[i], p.w[i]}) - gravity;
            RateRecord& r = step.rate[i];
            r.ax += static_cast<float>(more.x());
            r.ay += static_cast<float>(more.y());
            r.az += static_cast<float>(more.z());
        });
    }
};

}  // namespace

std::unique_ptr<Effect> make_effect(const MovingTank&) { return std::make_unique<ForcesOfMotion>(); }

void effect_of_scene::moving_tank(const Scene& scene, const Surroundings&, const LevelSetup&, EffectOptions& on) {
    if (scene.tank_motion) on.push_back(MovingTank{});
}

}  // namespace tw
