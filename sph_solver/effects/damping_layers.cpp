#include "sph_solver/effects/damping_layers.h"

#include <algorithm>
#include <cmath>

#include "sph_solver/backend/for_particles.h"
#include "sph_solver/effects/registry.h"

namespace tw {
namespace {

class Layers : public Effect {
public:
    explicit Layers(DampingLayers options) : o_(std::move(options)) {}

    void add_rates(const StepView& step) override {
        const Particles& p = step.particles;
        const Box& domain = step.around.domain;
        const double stream = step.around.stream ? step.around.stream->velocity(step.time) : 0;
        const Vec3 moved = step.time * o_.velocity;
        for_particles(p.size(), [&](std::size_t i) {
            if (!follows_the_equations(p.kind[i])) return;
            const Vec3 x = Vec3(p.x[i], p.y[i], p.z[i]) - moved;
            double s = 0;
            for (const DampingLayers::Layer& l : o_.layers) {
                const double inside = l.high ? domain.max[l.axis] - x[l.axis] : x[l.axis] - domain.min[l.axis];
                s = std::max(s, 1 - inside / l.width);
            }
            if (s <= 0) return;
            s = std::min(s, 1.0);
            const double rate = o_.strength * s * s;
            RateRecord& r = step.rate[i];
            r.ax -= static_cast<float>(rate * (double(p.u[i]) - stream));
            r.ay -= static_cast<float>(rate * double(p.v[i]));
            r.az -= static_cast<float>(rate * double(p.w[i]));
        });
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
