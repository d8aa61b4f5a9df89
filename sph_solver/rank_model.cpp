#include "sph_solver/rank_model.h"

#include <algorithm>
#include <cmath>
#include <set>

#include "sph_solver/neighbours/list_life.h"
#include "sph_solver/parallel/decomposition.h"

namespace tw {
namespace {

PencilGrid cut(PencilGrid grid, int finer) {
    grid.width /= finer, grid.nx *= finer, grid.ny *= finer;
    return grid;
}

}  // namespace

PencilsOfSize pencils_of(const Level& level, int finer, int steps) {
    PencilsOfSize s;
    s.grid = cut(level.system().grid, finer);
    s.blocks = steps > 1 ? s.grid.scaled(2) : s.grid;
    s.steps = steps;
    const FixedPoint& fixed_point = level.system().fixed_point;
    s.low = fixed_point.wide(level.system().around.domain.min),
    s.high = fixed_point.wide(level.system().around.domain.max);
    const double reach = level.system().kernel.support() + ListLife::least_slack_over_dp * level.system().setup.dp;
    s.reach = static_cast<std::int64_t>(reach * fixed_point.per_metre / finer) + 1;
    std::vector<std::int64_t> work(static_cast<std::size_t>(level.system().grid.count())), particles(work.size());
    const Particles& p = level.fields().particles();
    const auto pencil = [&](std::size_t i) {
        return static_cast<std::size_t>(level.system().grid.of(fixed_point.wide({p.x[i], p.y[i], p.z[i]})));
    };
    for (const Cluster& g : level.system().near.clusters) {
        const std::size_t c = pencil(static_cast<std::size_t>(g.first));
        work[c] += g.size * (1 + level.system().live_pairs(g)), particles[c] += g.size;
    }
    if (level.system().near.clusters.empty()) {
        for (std::size_t i = 0; i < p.size(); ++i) ++particles[pencil(i)];
        work = particles;
    }
    s.work.resize(static_cast<std::size_t>(s.grid.count())), s.particles.resize(s.work.size());
    for (int c = 0; c < s.grid.count(); ++c) {
        const int x = c % s.grid.nx / finer, y = c / s.grid.nx % s.grid.ny / finer, z = c / s.grid.nx / s.grid.ny;
        const auto of = static_cast<std::size_t>(level.system().grid.pencil(x, y, z));
        const auto k = static_cast<std::size_t>(c);
        s.work[k] = finer * work[of], s.particles[k] = finer * particles[of];  // finer^3 as many in finer^2 pencils
        s.all_work += double(s.work[k]), s.all_particles += double(s.particles[k]);
    }
    return s;
}

std::vector<PencilsOfSize> pencils_of_water(const Simulation& simulation, int finer) {
    std::vector<PencilsOfSize> sizes;
    for (const auto& level : simulation.water()) sizes.push_back(pencils_of(*level, finer, 1 << sizes.size()));
    return sizes;
}

Division divide(const PencilsOfSize& s, const Mirrors& mirrors, int ranks) {
    Division d;
    Decomposition pencils(s.grid, s.blocks, s.work, ranks);
    pencils.find_holders(s.grid, mirrors, s.low, s.high, s.reach);
    std::vector<double> work(static_cast<std::size_t>(ranks)), own(work.size()), copies(work.size());
    std::vector<std::set<std::int32_t>> sends_to(work.size());
    for (int c = 0; c < s.grid.count(); ++c) {
        const auto k = static_cast<std::size_t>(c);
        if (s.particles[k] == 0) continue;
        const auto owner = static_cast<std::size_t>(pencils.owner(c));
        work[owner] += double(s.work[k]), own[owner] += double(s.particles[k]);
        for (const std::int32_t r : pencils.holders(c)) {
            copies[static_cast<std::size_t>(r)] += double(s.particles[k]);
            sends_to[owner].insert(r);
        }
    }
    d.possible = std::ranges::min(work) > 0;
    d.imbalance = s.all_work > 0 ? std::ranges::max(work) * ranks / s.all_work : 1;
    d.own_particles = std::ranges::max(own), d.copies = std::ranges::max(copies);
    for (const double n : copies) d.all_copies += n;
    for (const auto& to : sends_to) d.neighbours = std::max(d.neighbours, double(to.size()));
    return d;
}

double seconds_of_talk(const Division& d, int ranks, const MachineOfRanks& machine, const CountedOfRanks& counted) {
    return counted.exchanges * d.neighbours * machine.latency + d.copies * counted.bytes_a_copy / machine.bandwidth +
           counted.collectives * std::log2(ranks) * machine.latency;
}

}  // namespace tw
