#include "sph_solver/effects/forcing_zones.h"

#include <algorithm>
#include <limits>
#include <stdexcept>

#include "scene/water/tailwater.h"
#include "sph_solver/effects/forcing_zones_loops.h"
#include "sph_solver/effects/registry.h"

namespace tw {
namespace {

class InZones : public Effect {
public:
    explicit InZones(ZoneForcing options) : o_(std::move(options)) {
        if (o_.zones.size() > std::size_t{ForceInZones::most})
            throw std::logic_error("more forcing zones than a domain has faces");
    }

    void add_rates(const StepView& step) override {
        if (o_.wave) return add_rates_towards<ForceTowardsWave>(step, in_stream(*o_.wave, step));
        if (o_.sea) return add_rates_towards<ForceTowardsSea>(step, wave_moment(in_stream(*o_.sea, step), step.time));
        ForceInZones force{.p = step.p,
                           .kind = step.kind,
                           .rate = step.rate,
                           .zones = {},
                           .count = static_cast<int>(o_.zones.size()),
                           .stream = 0,
                           .behind_from = std::numeric_limits<double>::infinity(),
                           .behind = 0};
        if (const auto& stream = step.around.stream) {
            force.stream = stream->velocity(step.time);
            force.behind_from = stream->behind_from;
            force.behind = (stream->behind_share - 1) * stream->acceleration(step.time);
        }
        for (std::size_t k = 0; k < o_.zones.size(); ++k) {
            const ForcingZone& z = o_.zones[k];
            force.zones[k] = {z.axis, z.begin, 1 / (z.end - z.begin), z.gamma, z.share};
        }
        step.each(step.n, force);
    }
    double largest_step(const LevelSetup&, double) const override {
        double strongest = 0;
        for (const ForcingZone& z : o_.zones) strongest = std::max(strongest, z.gamma);
        return 0.5 / strongest;
    }

private:
    /// While the stream starts, the wave is carried by as much of it as there is: crests come to where they are after
    /// the start as if it had had its speed always.
    static WaveSum in_stream(WaveSum wave, const StepView& step) {
        if (const auto& stream = step.around.stream) {
            wave.current += stream->velocity(step.time) - stream->speed;
            wave.phase -= wave.direction * wave.k * stream->ahead_of_full_speed(step.time);
        }
        return wave;
    }
    static WaveComponents in_stream(WaveComponents sea, const StepView& step) {
        if (const auto& stream = step.around.stream) {
            sea.current += stream->velocity(step.time) - stream->speed;
            for (int n = 0; n < sea.count; ++n)
                sea.phase[n] -= sea.direction * sea.k[n] * stream->ahead_of_full_speed(step.time);
        }
        return sea;
    }
    template <class Loop, class Wave>
    void add_rates_towards(const StepView& step, const Wave& wave) {
        ForceTowards<Wave> force{.p = step.p,
                                 .kind = step.kind,
                                 .rate = step.rate,
                                 .zones = {},
                                 .makes_wave = {},
                                 .count = static_cast<int>(o_.zones.size()),
                                 .time = step.time,
                                 .stream = step.around.stream ? step.around.stream->velocity(step.time) : 0,
                                 .wave = wave};
        for (std::size_t k = 0; k < o_.zones.size(); ++k) {
            const ForcingZone& z = o_.zones[k];
            force.zones[k] = {z.axis, z.begin, 1 / (z.end - z.begin), z.gamma, 1};
            force.makes_wave[k] = z.makes_wave;
        }
        step.each(step.n, Loop{force});
    }

    ZoneForcing o_;
};

}  // namespace

std::unique_ptr<Effect> make_effect(const ZoneForcing& options) { return std::make_unique<InZones>(options); }

void effect_of_scene::forcing_zones(const Scene& scene, const Surroundings&, const LevelSetup&, EffectOptions& on) {
    ForcingZones plan = tw::forcing_zones(scene);
    if (plan.zones.empty() && !tailwater(scene)) return;
    ZoneForcing forcing{std::move(plan.zones)};
    if (scene.wave) forcing.wave = scene.wave->sum;
    if (scene.sea) forcing.sea = scene.sea->waves;
    on.push_back(std::move(forcing));
}

}  // namespace tw
