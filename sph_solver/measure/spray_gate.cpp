#include "sph_solver/measure/spray_gate.h"

#include <algorithm>

#include "record/components.h"

namespace tw {

std::optional<SprayGate> SprayGate::of(const SphOptions& o) {
    if (o.gate_point.empty()) return {};
    return SprayGate(Vec3(o.gate_point.data()), Vec3(o.gate_normal.data()), o.gate_link);
}

std::vector<SprayLump> SprayGate::take(Level& level) const {
    const Particles& p = level.particles();
    const double dp = level.setup().dp, mass = level.mass();
    const auto place = [&](std::size_t i) { return Vec3(p.x[i], p.y[i], p.z[i]); };
    const auto velocity = [&](std::size_t i) { return Vec3(p.u[i], p.v[i], p.w[i]); };
    const auto is_beyond = [&](const Vec3& x) { return (x - point_).dot(normal_) > 0; };
    bool any = false;
    for (std::size_t i = 0; i < p.size() && !any; ++i) any = p.kind[i] == Kind::fluid && is_beyond(place(i));
    if (!any) return {};  // the search for components costs as much as a step

    std::vector<WaterElement> elements(p.size());
    for (std::size_t i = 0; i < p.size(); ++i) elements[i] = {place(i), velocity(i), dp * dp * dp, dp};
    const std::vector<int> number = components(elements, link_);
    const auto count = static_cast<std::size_t>(*std::ranges::max_element(number)) + 1;
    std::vector<SprayLump> all(count);
    std::vector<char> taken(count, 1);
    taken[0] = 0;  // the body of water
    for (std::size_t i = 0; i < p.size(); ++i) {
        const auto k = static_cast<std::size_t>(number[i]);
        if (p.kind[i] != Kind::fluid) taken[k] = 0;
        all[k].place += place(i), all[k].velocity += velocity(i);
        all[k].mass += mass;
        ++all[k].particles;
    }
    for (std::size_t k = 0; k < count; ++k) {
        all[k].place /= static_cast<double>(all[k].particles);
        all[k].velocity /= static_cast<double>(all[k].particles);
        taken[k] = taken[k] && is_beyond(all[k].place);
    }
    std::vector<std::int32_t> staying;
    for (std::size_t i = 0; i < p.size(); ++i) {
        SprayLump& lump = all[static_cast<std::size_t>(number[i])];
        if (!taken[static_cast<std::size_t>(number[i])]) staying.push_back(static_cast<std::int32_t>(i));
        lump.inner_energy += 0.5 * mass * (velocity(i) - lump.velocity).squaredNorm();
    }
    std::vector<SprayLump> lumps;
    for (std::size_t k = 0; k < count; ++k)
        if (taken[k]) lumps.push_back(all[k]);
    if (lumps.empty()) return {};
    Level::State state = level.state();
    state.ledger.out += static_cast<std::int64_t>(p.size() - staying.size());
    Particles rest = p;
    rest.reorder(staying);
    level.restore(state, std::move(rest));
    return lumps;
}

}  // namespace tw
