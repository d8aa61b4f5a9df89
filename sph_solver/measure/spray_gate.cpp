#include "sph_solver/measure/spray_gate.h"

#include <algorithm>
#include <array>

#include "base/exact_sum.h"
#include "record/components.h"
#include "sph_solver/all_particles.h"
#include "sph_solver/simulation.h"

namespace tw {
namespace {

Vec3 place(const Particles& p, std::size_t i) { return {p.x[i], p.y[i], p.z[i]}; }
Vec3 velocity(const Particles& p, std::size_t i) { return {p.u[i], p.v[i], p.w[i]}; }

/// The run's water: the active particles of all its sizes, and which particle each is.
struct ActiveWater {
    std::vector<WaterElement> elements;
    std::vector<std::pair<std::size_t, std::size_t>> who;  ///< level, particle
};

ActiveWater water_of(const Simulation& simulation, const AllParticles& all) {
    ActiveWater water;
    for (std::size_t k = 0; k < simulation.levels().size(); ++k) {
        const Particles& p = all.of(k);
        const double dp = simulation.level(k).system().setup.dp;
        for (std::size_t i = 0; i < p.size(); ++i) {
            if (!is_active(p.kind[i])) continue;
            water.elements.push_back({place(p, i), velocity(p, i), dp * dp * dp, dp});
            water.who.emplace_back(k, i);
        }
    }
    return water;
}

/// Whether a particle that stands for the water of another size stands for what is taken: within a spacing and a half
/// of its own or of theirs it has water that is, and none that stays.
class Bereft {
public:
    Bereft(const ActiveWater& water, const std::vector<char>& taken) : water_(water), taken_(taken) {
        for (std::size_t n = 0; n < taken.size(); ++n) {
            if (!taken[n]) continue;
            const Vec3 reach = Vec3::Constant(1.5 * water.elements[n].size);
            round_.extend(water.elements[n].place - reach);
            round_.extend(water.elements[n].place + reach);
        }
    }
    bool operator()(const Vec3& x, double dp) const {
        if (round_.exteriorDistance(x) > 1.5 * dp) return false;
        bool any = false;
        for (std::size_t n = 0; n < taken_.size(); ++n) {
            const WaterElement& e = water_.elements[n];
            if ((e.place - x).norm() > 1.5 * std::max(dp, e.size)) continue;
            if (!taken_[n]) return false;
            any = true;
        }
        return any;
    }

private:
    const ActiveWater& water_;
    const std::vector<char>& taken_;
    Eigen::AlignedBox3d round_;
};

/// All ranks have what the first one has.
SprayGate::Leaving leaving_of_first(const Comm& ranks, SprayGate::Leaving own) {
    if (!ranks.many()) return own;
    struct Lump {
        std::array<double, 3> place, velocity;
        double mass, inner_energy;
        std::int64_t particles;
    };
    std::vector<Lump> sent;
    for (const SprayLump& l : own.lumps)
        sent.push_back({{l.place.x(), l.place.y(), l.place.z()},
                        {l.velocity.x(), l.velocity.y(), l.velocity.z()},
                        l.mass,
                        l.inner_energy,
                        l.particles});
    SprayGate::Leaving all_ranks;
    for (const Lump& l : ranks.gathered(sent))
        all_ranks.lumps.push_back({Vec3(l.place.data()), Vec3(l.velocity.data()), l.mass, l.inner_energy, l.particles});
    for (const SprayGate::Leaving::OfSize& size : own.sizes)
        all_ranks.sizes.push_back({ranks.gathered(size.ids), ranks.sum(size.active)});
    return all_ranks;
}

}  // namespace

std::optional<SprayGate> SprayGate::of(const SphOptions& o) {
    if (o.gate_point.empty()) return {};
    return SprayGate(Vec3(o.gate_point.data()), Vec3(o.gate_normal.data()), o.gate_link);
}

std::vector<SprayLump> SprayGate::take(Simulation& simulation) const {
    const Comm& ranks = simulation.level(0).system().ranks();
    if (ranks.sum(std::int64_t{any_beyond(simulation)}) == 0) return {};  // the search costs as much as a step
    Leaving leaving;
    leaving.sizes.resize(simulation.levels().size());
    {
        const AllParticles all(simulation);
        ranks.on_first([&] { find(simulation, all, leaving); });
    }
    leaving = leaving_of_first(ranks, std::move(leaving));
    for (std::size_t k = 0; k < leaving.sizes.size(); ++k)
        if (auto& [ids, active] = leaving.sizes[k]; !ids.empty()) simulation.level(k).take_out(std::move(ids), active);
    return leaving.lumps;
}

bool SprayGate::is_beyond(const Vec3& x) const { return (x - point_).dot(normal_) > 0; }

bool SprayGate::any_beyond(const Simulation& simulation) const {
    for (const auto& level : simulation.levels()) {
        const Particles& p = level->fields().particles();
        for (std::size_t i = 0; i < p.size(); ++i)
            if (p.kind[i] == Kind::fluid && is_beyond(place(p, i))) return true;
    }
    return false;
}

void SprayGate::find(const Simulation& simulation, const AllParticles& particles, Leaving& leaving) const {
    const ActiveWater water = water_of(simulation, particles);
    const auto is_inner = [&](std::size_t n) {
        const auto [k, i] = water.who[n];
        return particles.of(k).kind[i] == Kind::fluid;
    };
    const std::vector<int> number = components(water.elements, link_);
    const auto count = static_cast<std::size_t>(*std::ranges::max_element(number)) + 1;
    std::vector<SprayLump> all(count);
    std::vector<char> leaves(count, 1), taken(water.who.size(), 0);
    leaves[0] = 0;  // the body of water
    // masses are counted in those of the coarsest particles
    const double coarsest = simulation.level(0).system().mass;
    const auto share_of = [&](std::size_t n) { return simulation.level(water.who[n].first).system().mass / coarsest; };
    struct Sums {
        ExactVectorSum place, velocity;
        ExactSum share, inner_energy;
    };
    std::vector<Sums> sums(count);
    for (std::size_t n = 0; n < water.who.size(); ++n) {
        const auto c = static_cast<std::size_t>(number[n]);
        if (!is_inner(n)) leaves[c] = 0;
        sums[c].place += share_of(n) * water.elements[n].place;
        sums[c].velocity += share_of(n) * water.elements[n].velocity;
        sums[c].share += share_of(n);
        ++all[c].particles;
    }
    for (std::size_t c = 0; c < count; ++c) {
        const double share = sums[c].share.value();
        all[c].place = sums[c].place.value() / share, all[c].velocity = sums[c].velocity.value() / share;
        all[c].mass = coarsest * share;
        leaves[c] = leaves[c] && is_beyond(all[c].place);
    }
    for (std::size_t n = 0; n < water.who.size(); ++n) {
        const auto c = static_cast<std::size_t>(number[n]);
        sums[c].inner_energy += share_of(n) * (water.elements[n].velocity - all[c].velocity).squaredNorm();
        taken[n] = leaves[c];
    }
    for (std::size_t c = 0; c < count; ++c) {
        all[c].inner_energy = 0.5 * coarsest * sums[c].inner_energy.value();
        if (leaves[c]) leaving.lumps.push_back(all[c]);
    }
    if (leaving.lumps.empty()) return;

    const Bereft bereft(water, taken);
    std::size_t n = 0;
    for (std::size_t k = 0; k < simulation.levels().size(); ++k) {
        const Particles& p = particles.of(k);
        auto& [ids, active] = leaving.sizes[k];
        for (std::size_t i = 0; i < p.size(); ++i) {
            const bool water_itself = is_active(p.kind[i]),
                       goes = water_itself ? taken[n] : bereft(place(p, i), simulation.level(k).system().setup.dp);
            if (water_itself) active += taken[n++];
            if (goes) ids.push_back(p.id[i]);
        }
    }
}

}  // namespace tw
