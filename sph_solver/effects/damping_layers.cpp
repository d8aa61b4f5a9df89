#include "sph_solver/effects/damping_layers.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

#include "sph_solver/effects/damping_layers_loops.h"
#include "sph_solver/effects/registry.h"

namespace tw {
namespace {

class Layers : public Effect {
public:
    explicit Layers(DampingLayers options) : o_(std::move(options)) {
        if (o_.layers.size() > std::size_t{DampInLayers::most})
            throw std::logic_error("more damping layers than a domain has faces");
    }

    void add_rates(const StepView& step) override {
        const Box& domain = step.around.domain;
        const Vec3 moved = step.time * o_.velocity;
        DampInLayers damp{.p = step.p,
                          .kind = step.kind,
                          .rate = step.rate,
                          .layers = {},
                          .count = static_cast<int>(o_.layers.size()),
                          .strength = o_.strength,
                          .stream = step.around.stream ? step.around.stream->velocity(step.time) : 0,
                          .moved = {moved.x(), moved.y(), moved.z()}};
        for (std::size_t k = 0; k < o_.layers.size(); ++k) {
            const DampingLayers::Layer& l = o_.layers[k];
            damp.layers[k] = {l.axis, l.high, (l.high ? domain.max : domain.min)[l.axis], l.width};
        }
        step.each(step.n, damp);
    }
    double largest_step(const LevelSetup&, double) const override { return 0.5 / o_.strength; }

private:
    DampingLayers o_;
};

/// Along every outer face but inlet, symmetry, floor and top, an eighth of the domain wide; strong enough to leave e^-5
/// of the motion of what crosses them at the scene's speed.
DampingLayers layers_of(const Scene& scene, const Surroundings& s, const LevelSetup& water) {
    DampingLayers d;
    const Domain& domain = scene.domain;
    const auto layer = [&](int axis, bool high, Side side) {
        if (side == Side::symmetry || side == Side::inlet || (axis == 1 && s.dimensions == 2)) return;
        d.layers.push_back({axis, high, s.domain.size()[axis] / 8});
    };
    layer(0, false, domain.x_min), layer(0, true, domain.x_max);
    layer(1, false, domain.y_min), layer(1, true, domain.y_max);
    double widest = water.dp;
    for (const DampingLayers::Layer& l : d.layers) widest = std::max(widest, l.width);
    const double speed = s.stream ? s.stream->speed : std::sqrt(scene.water.gravity * scene.water.depth);
    d.strength = 3 * 5 * speed / widest;  // the mean of s^2 is a third
    return d;
}

}  // namespace

std::unique_ptr<Effect> make_effect(const DampingLayers& options) { return std::make_unique<Layers>(options); }

void effect_of_scene::damping_layers(const Scene& scene, const Surroundings& around, const LevelSetup& water,
                                     EffectOptions& on) {
    if (scene.effect_on("damping_layers")) on.push_back(layers_of(scene, around, water));
}

}  // namespace tw
