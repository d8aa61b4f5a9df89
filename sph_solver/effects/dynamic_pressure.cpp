#include "sph_solver/effects/dynamic_pressure.h"

#include <fmt/format.h>

#include "base/errors.h"
#include "sph_solver/domain/level_setup.h"
#include "sph_solver/effects/dynamic_pressure_loops.h"
#include "sph_solver/effects/registry.h"

namespace tw {
namespace {

class WeightUnderSurface : public Effect {
public:
    explicit WeightUnderSurface(const RestPressure& at_rest) : r_(at_rest) {}

    void add_rates(const StepView& step) override {
        const WeighUnderSurface weigh{
            step.p, step.kind, step.shift, step.rate, r_, step.level.rho0, step.level.surface_support};
        const double seen = step.ranks.largest(step.largest(step.n, weigh));
        if (seen > 0)
            throw RunError(
                fmt::format("the free surface came down to {:.4g} m below still water at t = {:.6g} s, where the "
                            "particles carry the "
                            "dynamic pressure alone; this is no flow under a quiet surface: set [effects] "
                            "dynamic_pressure = \"off\"",
                            r_.surface - r_.top, step.time));
    }

private:
    RestPressure r_;
};

}  // namespace

std::unique_ptr<Effect> make_effect(const DynamicPressure& options) {
    return std::make_unique<WeightUnderSurface>(options.at_rest);
}

void effect_of_scene::dynamic_pressure(const Scene& scene, const Surroundings& around, const LevelSetup&,
                                       EffectOptions& on) {
    if (!around.at_rest) return;
    if (scene.effect_on("cavitation"))
        throw InputError(scene.file.string() +
                         ": [effects] cavitation and dynamic_pressure are on together; the first asks for the whole "
                         "pressure, so one of the two has to be \"off\"");
    on.push_back(DynamicPressure{*around.at_rest});
}

}  // namespace tw
