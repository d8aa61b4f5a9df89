#include "sph_solver/effects/moving_tank.h"

#include "sph_solver/effects/moving_tank_loops.h"
#include "sph_solver/effects/registry.h"

namespace tw {
namespace {

class ForcesOfMotion : public Effect {
public:
    void add_rates(const StepView& step) override {
        const Vec3& g = step.around.gravity;
        step.each(
            step.n,
            FeelMotion{
                step.p, step.kind, ForceOfFrame::of(step.around.force(step.time)), {g.x(), g.y(), g.z()}, step.rate});
    }
};

}  // namespace

std::unique_ptr<Effect> make_effect(const MovingTank&) { return std::make_unique<ForcesOfMotion>(); }

void effect_of_scene::moving_tank(const Scene& scene, const Surroundings&, const LevelSetup&, EffectOptions& on) {
    if (scene.tank_motion) on.push_back(MovingTank{});
}

}  // namespace tw
