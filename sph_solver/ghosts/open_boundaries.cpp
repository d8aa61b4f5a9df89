#include "sph_solver/ghosts/open_boundaries.h"

namespace tw {

Crossed cross_open_boundaries(const Surroundings& around, double dp, Particles& p, Ledger& ledger) {
    const Box& domain = around.domain;
    Crossed crossed;
    std::vector<char>& gone = crossed.gone;
    gone.assign(p.size(), 0);
    if (around.stream) {
        const double buffer = around.stream->buffer;
        const std::size_t n = p.size();
        for (std::size_t i = 0; i < n; ++i) {
            switch (p.kind[i]) {
                case Kind::inlet:
                    if (p.x[i] < domain.min.x()) break;
                    p.kind[i] = Kind::fluid;
                    crossed.entered.push_back(static_cast<std::int32_t>(i));
                    p.add(p.x[i] - buffer, p.y[i], p.z[i], p.u[i], p.drho[i], ledger.next_id++, Kind::inlet);
                    ++ledger.in;
                    break;
                case Kind::fluid:
                    if (p.x[i] > domain.max.x())
                        p.kind[i] = Kind::outlet;
                    else if (p.x[i] < domain.min.x() - 0.5 * dp)
                        gone[i] = 1;  // washed back into the inlet
                    break;
                case Kind::outlet:
                case Kind::guard:
                case Kind::band:
                case Kind::carried:
                    if (p.x[i] > domain.max.x() + buffer) gone[i] = 1;
                    break;
            }
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
    std::vector<double>* coordinate[3] = {&p.x, &p.y, &p.z};
    std::vector<float>* velocity[3] = {&p.u, &p.v, &p.w};
    std::int64_t returned = 0;
    for (int a = 0; a < 3; ++a) {
        if (mirrors.periodic[static_cast<std::size_t>(a)])
            for (double& x : *coordinate[a]) {
                const double length = domain.max[a] - domain.min[a];
                const double back = x < domain.min[a] ? length : x >= domain.max[a] ? -length : 0;
                x += back;
                returned += back != 0;
            }
        for (int side = 0; side < 2; ++side) {
            if (!mirrors.on[static_cast<std::size_t>(a)][static_cast<std::size_t>(side)]) continue;
            const double plane = side == 0 ? domain.min[a] : domain.max[a];
            for (std::size_t i = 0; i < p.size(); ++i) {
                double& x = (*coordinate[a])[i];
                if (side == 0 ? x >= plane : x <= plane) continue;
                x = 2 * plane - x;
                (*velocity[a])[i] = -(*velocity[a])[i];
                ++returned;
            }
        }
    }
    return returned;
}

}  // namespace tw
