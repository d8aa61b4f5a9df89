#include "sph_solver/effects/ventilation.h"

#include <algorithm>

#include "sph_solver/domain/level_setup.h"
#include "sph_solver/effects/registry.h"
#include "sph_solver/loops/air.h"

namespace tw {
namespace {

class AirAlongWalls : public Effect {
public:
    explicit AirAlongWalls(const Ventilation& options) : options_(options) {}

    With brings() const override { return With::ventilation; }

    void after_first_sweep(const StepView& step) override {
        const std::size_t n = step.n, all = n + step.images;
        const AirAtParticles air = rules(step);
        touched_.resize(all / 32 + 2);
        for_particles(touched_.size(), MarkBits{[&](std::size_t i) { return air.stays(i); }, step.links, n, all,
                                                touched_.data()});
        asking_.clear();
        for (const Group& g : step.groups)
            for (int l = 0; l < g.size; ++l) {
                const auto i = static_cast<std::size_t>(g.first + l);
                if (!marked(touched_.data(), i) && air.may_come(i)) {
                    asking_.push_back(g);
                    break;
                }
            }
        near_.assign(n, 0);
        NearAirData d{.water = step.water, .near = near_.data()};
        d.water.surface = touched_.data();
        for_pairs(step.passes, d, asking_);
        step.halo.tell(near_.data());
        for_particles(n, [&](std::size_t i) { air.note(i, touched_.data(), near_.data()); });
    }
    std::size_t bytes() const override {
        return touched_.capacity() * sizeof(std::uint32_t) + near_.capacity() + asking_.capacity() * sizeof(Group);
    }

private:
    AirAtParticles rules(const StepView& step) const {
        return {.aired = step.aired,
                .wall = step.dummies.place ? step.dummies.normal : nullptr,
                .drho = step.p.drho,
                .shift = step.shift,
                .surface = step.water.surface,
                .reach = options_.reach_over_dp * static_cast<float>(step.level.dp),
                .support = options_.support};
    }

    Ventilation options_;
    std::vector<std::uint32_t> touched_;  ///< a bit for each particle and image, as Particles::surface
    std::vector<std::uint8_t> near_;
    std::vector<Group> asking_;
};

}  // namespace

std::unique_ptr<Effect> make_effect(const Ventilation& options) { return std::make_unique<AirAlongWalls>(options); }

void effect_of_scene::ventilation(const Scene& scene, const Surroundings&, const LevelSetup&, EffectOptions& on) {
    if (scene.effect_on("ventilation")) on.push_back(Ventilation{});
}

}  // namespace tw
