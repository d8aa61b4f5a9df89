#include "sph_solver/effects/ventilation.h"

#include "sph_solver/domain/level_setup.h"
#include "sph_solver/effects/registry.h"
#include "sph_solver/effects/ventilation_loops.h"

namespace tw {
namespace {

class AirAlongWalls : public Effect {
public:
    explicit AirAlongWalls(const Ventilation& options) : options_(options) {}

    With brings() const override { return With::ventilation; }

    void after_first_pair_loop(const StepView& step) override {
        const std::size_t n = step.n, all = n + step.images, words = all / 32 + 2;
        const AirAtParticles air = rules(step);
        std::uint32_t* const stays = stays_.resize(step.device, words);
        step.each(words, MarkAir{air, step.links, n, all, stays});
        const OwnSums<Round> sums = step.zero_sums(round_, n);
        NearAirData d{.water = step.water, .round = sums};
        d.water.surface = stays;
        step.pairs_where(MayGetAir{air, stays}, d, asking_);
        step.each(n, NoteAir{air, stays, step.exchange(sums)});
    }
    std::size_t bytes() const override { return stays_.bytes() + round_.bytes() + asking_.bytes(); }

private:
    AirAtParticles rules(const StepView& step) const {
        return {.aired = step.fields.aired,
                .wall = step.dummies.place ? step.dummies.normal : nullptr,
                .drho = step.p.drho,
                .surface = step.water.surface,
                .reach = options_.reach_over_dp * static_cast<float>(step.level.dp)};
    }

    Ventilation options_;
    LoopArray<std::uint32_t> stays_;  ///< a bit for each particle and image, as Particles::surface
    LoopArray<Round> round_;
    LoopArray<Cluster> asking_;
};

}  // namespace

std::unique_ptr<Effect> make_effect(const Ventilation& options) { return std::make_unique<AirAlongWalls>(options); }

void effect_of_scene::ventilation(const Scene& scene, const Surroundings&, const LevelSetup&, EffectOptions& on) {
    if (scene.effect_on("ventilation")) on.push_back(Ventilation{});
}

}  // namespace tw
