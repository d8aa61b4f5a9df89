#include "sph_solver/measure/spray_gate.h"

#include <algorithm>

#include "base/exact_sum.h"
#include "record/components.h"
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

ActiveWater water_of(const Simulation& simulation) {
    ActiveWater water;
    for (std::size_t k = 0; k < simulation.levels().size(); ++k) {
        const Particles& p = simulation.level(k).particles();
        const double dp = simulation.level(k).setup().dp;
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

}  // namespace

std::optional<SprayGate> SprayGate::of(const SphOptions& o) {
    if (o.gate_point.empty()) return {};
    return SprayGate(Vec3(o.gate_point.data()), Vec3(o.gate_normal.data()), o.gate_link);
}

std::vector<SprayLump> SprayGate::take(Simulation& simulation) const {
    const ActiveWater water = water_of(simulation);
    const auto is_beyond = [&](const Vec3& x) { return (x - point_).dot(normal_) > 0; };
    const auto is_inner = [&](std::size_t n) {
        const auto [k, i] = water.who[n];
        return simulation.level(k).particles().kind[i] == Kind::fluid;
    };
    bool any = false;
    for (std::size_t n = 0; n < water.who.size() && !any; ++n) any = is_inner(n) && is_beyond(water.elements[n].place);
    if (!any) return {};  // the search for components costs as much as a step

    const std::vector<int> number = components(water.elements, link_);
    const auto count = static_cast<std::size_t>(*std::ranges::max_element(number)) + 1;
    std::vector<SprayLump> all(count);
    std::vector<char> leaves(count, 1), taken(water.who.size(), 0);
    leaves[0] = 0;  // the body of water
    // masses are counted in those of the coarsest particles
    const double coarsest = simulation.level(0).mass();
    const auto share_of = [&](std::size_t n) { return simulation.level(water.who[n].first).mass() / coarsest; };
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
    std::vector<SprayLump> lumps;
    for (std::size_t n = 0; n < water.who.size(); ++n) {
        const auto c = static_cast<std::size_t>(number[n]);
        sums[c].inner_energy += share_of(n) * (water.elements[n].velocity - all[c].velocity).squaredNorm();
        taken[n] = leaves[c];
    }
    for (std::size_t c = 0; c < count; ++c) {
        all[c].inner_energy = 0.5 * coarsest * sums[c].inner_energy.value();
        if (leaves[c]) lumps.push_back(all[c]);
    }
    if (lumps.empty()) return {};

    const Bereft bereft(water, taken);
    std::size_t n = 0;
    for (std::size_t k = 0; k < simulation.levels().size(); ++k) {
        Level& level = simulation.level(k);
        const Particles& p = level.particles();
        std::int64_t out = 0;
        std::vector<std::int32_t> staying;
        for (std::size_t i = 0; i < p.size(); ++i) {
            const bool active = is_active(p.kind[i]), goes = active ? taken[n] : bereft(place(p, i), level.setup().dp);
            if (active) out += taken[n++];
            if (!goes) staying.push_back(static_cast<std::int32_t>(i));
        }
        if (staying.size() < p.size()) level.keep_only(staying, out);
    }
    return lumps;
}

}  // namespace tw
