#include "sph_solver/ghosts/open_boundaries.h"

#include "sph_solver/ghosts/link.h"

namespace tw {

Crossed cross_open_boundaries(const Surroundings& around, double dp, Particles& p, Ledger& ledger) {
    const Box& domain = around.domain;
    Crossed crossed;
    std::vector<char>& gone = crossed.gone;
    gone.assign(p.size(), 0);
    if (around.stream) {
        const double buffer = around.stream->buffer;
        const CrossOpenings cross{domain.min.x(), domain.max.x(), buffer, dp};
        const std::size_t n = p.size();
        for (std::size_t i = 0; i < n; ++i) {
            const CrossOpenings::Outcome outcome = cross(p.x[i], p.kind[i]);
            gone[i] = outcome == CrossOpenings::Outcome::leaves;
            if (outcome != CrossOpenings::Outcome::enters) continue;
            crossed.entered.push_back(static_cast<std::int32_t>(i));
            p.add(p.x[i] - buffer, p.y[i], p.z[i], p.u[i], p.drho[i], ledger.next_id++, Kind::inlet);
            if (p.has(With::sea_at_inlet)) p.calm_height.back() = p.calm_height[i];
            ++ledger.in;
        }
        gone.resize(p.size(), 0);
    }
    return_from_mirrors(around.mirrors, domain, p);
    for (std::size_t i = 0; i < p.size(); ++i)
        if (p.z[i] > domain.max.z() && !around.mirrors.on[2][1] && !around.mirrors.periodic[2])
            gone[i] = 1;  // through the open top
    return crossed;
}

std::int64_t return_from_mirrors(const Mirrors& mirrors, const Box& domain, Particles& p) {
    const ReturnFromMirrors back{
        {p.x.data(), p.y.data(), p.z.data(), p.u.data(), p.v.data(), p.w.data(), p.drho.data()},
        faces_of(mirrors, domain)};
    std::int64_t returned = 0;
    for (std::size_t i = 0; i < p.size(); ++i) returned += back(i);
    return returned;
}

}  // namespace tw
