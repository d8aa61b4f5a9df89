#include "sph_solver/effects/ventilation.h"

#include <algorithm>

#include "sph_solver/backend/for_particles.h"
#include "sph_solver/domain/level_setup.h"
#include "sph_solver/effects/registry.h"

namespace tw {
namespace {

class AirAlongWalls : public Effect {
public:
    explicit AirAlongWalls(const Ventilation& options) : options_(options) {}

    With brings() const override { return With::ventilation; }

    void after_first_sweep(const StepView& step) override {
        Particles& p = step.particles;
        const std::size_t n = p.size();
        const float reach = options_.reach_over_dp * static_cast<float>(step.level.dp);
        // beside a wall, not pressed on it and short of support
        const auto loose = [&](std::size_t i) {
            return !p.wall_normal.empty() && p.wall_normal[i].distance < reach && p.drho[i] <= 0 &&
                   p.shift_support[i].support < options_.support;
        };
        const auto aired = [&](std::size_t i) {
            return (step.at_surface(i) && p.aired[i] != Aired::no) || (p.aired[i] == Aired::yes && loose(i));
        };
        touched_.resize(p.surface.size());
        for_particles(touched_.size(), [&](std::size_t word) {
            std::uint32_t bits = 0;
            for (std::size_t i = 32 * word; i < std::min(p.place.size(), 32 * word + 32); ++i)
                bits |= std::uint32_t{aired(i < n ? i : static_cast<std::size_t>(step.ghosts.links()[i - n].index))}
                        << (i % 32);
            touched_[word] = bits;
        });
        const auto is_touched = [&](std::size_t i) { return (touched_[i / 32] >> (i % 32) & 1u) != 0; };
        asking_.clear();
        for (const Group& g : step.groups)
            for (int l = 0; l < g.size; ++l) {
                const auto i = static_cast<std::size_t>(g.first + l);
                if (!is_touched(i) && (step.at_surface(i) || loose(i))) {
                    asking_.push_back(g);
                    break;
                }
            }
        near_.assign(n, 0);
        NearAirData d{.water = step.water, .near = near_.data()};
        d.water.surface = touched_.data();
        for_pairs(step.passes, d, asking_);
        step.halo.tell(near_.data());
        for_particles(n, [&](std::size_t i) {
            p.aired[i] = is_touched(i) || (near_[i] && (step.at_surface(i) || loose(i))) ? Aired::yes : Aired::no;
        });
    }
    std::size_t bytes() const override {
        return touched_.capacity() * sizeof(std::uint32_t) + near_.capacity() + asking_.capacity() * sizeof(Group);
    }

private:
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
