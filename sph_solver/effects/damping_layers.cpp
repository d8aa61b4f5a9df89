#include "sph_solver/effects/damping_layers.h"

#include <algorithm>

#include "sph_solver/domain/surroundings.h"

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
#pragma omp parallel for schedule(static)
        for (std::size_t i = 0; i < p.size(); ++i) {
            if (!follows_the_equations(p.kind[i])) continue;
            const Vec3 x = Vec3(p.x[i], p.y[i], p.z[i]) - moved;
            double s = 0;
            for (const DampingLayers::Layer& l : o_.layers) {
                const double inside = l.high ? domain.max[l.axis] - x[l.axis] : x[l.axis] - domain.min[l.axis];
                s = std::max(s, 1 - inside / l.width);
            }
            if (s <= 0) continue;
            s = std::min(s, 1.0);
            const double rate = o_.strength * s * s;
            RateRecord& r = step.pass.rate[i];
            r.ax -= static_cast<float>(rate * (double(p.u[i]) - stream));
            r.ay -= static_cast<float>(rate * double(p.v[i]));
            r.az -= static_cast<float>(rate * double(p.w[i]));
        }
    }
    double largest_step(const LevelSetup&, double) const override { return 0.5 / o_.strength; }

private:
    DampingLayers o_;
};

}  // namespace

std::unique_ptr<Effect> make_damping_layers(const DampingLayers& options) { return std::make_unique<Layers>(options); }

}  // namespace tw
