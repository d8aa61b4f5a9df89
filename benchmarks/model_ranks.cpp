// What many ranks would bring: the columns of a scene are divided for real, on one machine, for 8 to 4096 ranks, and
// imbalance, copies and neighbours are counted; the time of a step is a model of these counts and of a stated machine.
//
//   build/benchmarks/model_ranks SCENE.toml [FINER] [FIGURE.svg]
//
// FINER (default 1): so many times finer in each direction than the scene, without making those particles: each column
// is cut into FINER x FINER and has their share of its work. One step of the scene is made, so that its pairs are known.
// docs/decisions/067-ranks.md has the tables.
#include <algorithm>
#include <cmath>
#include <cstdio>
#include <cstdlib>
#include <set>
#include <vector>

#include "base/atomic_file.h"
#include "base/errors.h"
#include "compare/report/svg_plot.h"
#include "scene/scene.h"
#include "sph_solver/neighbours/list_life.h"
#include "sph_solver/parallel/decomposition.h"
#include "sph_solver/scene_setup.h"

using namespace tw;

namespace {

/// The machine of the model: a rank is a core of a node with 64, which share a network card of 25 GB/s.
struct Machine {
    double pace = 2.0e6;           ///< evaluations of the largest density of pairs that a core makes a second
    double latency = 2e-6;         ///< of a message [s]
    double bandwidth = 25e9 / 64;  ///< of a rank [B/s]
};
/// What was counted on four ranks with two sizes (bench_ranks): for each step of one size.
struct Counted {
    double exchanges = 6.3, collectives = 5.2, bytes_a_copy = 60;
};

/// One size of particles, as a rank of many would see it.
struct Size {
    ColumnGrid grid, blocks;
    std::vector<std::int64_t> work, particles;  ///< of each column
    WidePlace low, high;
    std::int64_t reach;
    double all_work = 0, all_particles = 0;
    int steps;  ///< of this size in one of the largest
};

ColumnGrid cut(ColumnGrid grid, int finer) {
    grid.width /= finer, grid.nx *= finer, grid.ny *= finer;
    return grid;
}

Size size_of(const Level& level, const SimulationSetup& setup, int finer, int steps) {
    Size s;
    s.grid = cut(level.grid(), finer);
    s.blocks = steps > 1 ? s.grid.scaled(2) : s.grid;
    s.steps = steps;
    const Quanta& quanta = level.quanta();
    s.low = quanta.wide(setup.domain.min), s.high = quanta.wide(setup.domain.max);
    const double reach = level.kernel().support() + ListLife::skin_over_dp * level.setup().dp;
    s.reach = static_cast<std::int64_t>(reach * quanta.per_metre / finer) + 1;
    std::vector<std::int64_t> work(static_cast<std::size_t>(level.grid().count())), particles(work.size());
    const Particles& p = level.particles();
    for (const Group& g : level.groups()) {
        const auto i = static_cast<std::size_t>(g.first);
        const auto c = static_cast<std::size_t>(level.grid().of(quanta.wide({p.x[i], p.y[i], p.z[i]})));
        work[c] += g.size * (1 + level.live_pairs(g)), particles[c] += g.size;
    }
    s.work.resize(static_cast<std::size_t>(s.grid.count())), s.particles.resize(s.work.size());
    for (int c = 0; c < s.grid.count(); ++c) {
        const int x = c % s.grid.nx / finer, y = c / s.grid.nx % s.grid.ny / finer, z = c / s.grid.nx / s.grid.ny;
        const auto of = static_cast<std::size_t>(level.grid().column(x, y, z));
        const auto k = static_cast<std::size_t>(c);
        s.work[k] = finer * work[of], s.particles[k] = finer * particles[of];  // finer^3 as many in finer^2 columns
        s.all_work += double(s.work[k]), s.all_particles += double(s.particles[k]);
    }
    return s;
}

/// What the division of one size between ranks comes to.
struct Division {
    bool possible = false;
    double imbalance = 0;  ///< work, largest over mean
    double copies = 0;     ///< of the rank with most
    double all_copies = 0;
    double neighbours = 0;  ///< of the rank with most
};

Division divide(const Size& s, const Mirrors& mirrors, int ranks) {
    Division d;
    Decomposition columns(s.grid, s.blocks, s.work, ranks);
    columns.find_holders(s.grid, mirrors, s.low, s.high, s.reach);
    std::vector<double> work(static_cast<std::size_t>(ranks)), copies(work.size());
    std::vector<std::set<std::int32_t>> tells(work.size());
    for (int c = 0; c < s.grid.count(); ++c) {
        const auto k = static_cast<std::size_t>(c);
        if (s.particles[k] == 0) continue;
        const auto owner = static_cast<std::size_t>(columns.owner(c));
        work[owner] += double(s.work[k]);
        for (const std::int32_t r : columns.holders(c)) {
            copies[static_cast<std::size_t>(r)] += double(s.particles[k]);
            tells[owner].insert(r);
        }
    }
    d.possible = std::ranges::min(work) > 0;
    d.imbalance = std::ranges::max(work) * ranks / s.all_work;
    d.copies = std::ranges::max(copies);
    for (const double n : copies) d.all_copies += n;
    for (const auto& to : tells) d.neighbours = std::max(d.neighbours, double(to.size()));
    return d;
}

void model(const Scene& scene, int finer, const char* figure) {
    const SphSetup setup = sph_setup(scene, 0);
    Simulation simulation(setup.simulation, setup.fluid);
    simulation.step();
    std::vector<Size> sizes;
    double densest = 0;
    for (const auto& level : simulation.water())
        sizes.push_back(size_of(*level, setup.simulation, finer, 1 << sizes.size()));
    for (const Size& s : sizes) {
        densest = std::max(densest, s.all_work / s.all_particles);
        std::printf("%.3g particles, %d steps of one of the largest, %d columns\n", s.all_particles, s.steps,
                    s.grid.count());
    }
    const Machine machine;
    const Counted counted;
    std::printf("model: %.1e evaluations/s a rank, messages %.0f us and %.2f GB/s a rank; counts of bench_ranks\n\n",
                machine.pace, 1e6 * machine.latency, 1e-9 * machine.bandwidth);
    std::printf("%6s | %-23s | %-11s | %10s | %9s | %9s | %s\n", "ranks", "imbalance of each size", "copies/own",
                "neighbours", "work, ms", "talk, ms", "efficiency");
    double alone = 0;
    for (const Size& s : sizes) alone += s.steps * s.all_work / densest / machine.pace;
    PlotLine line;
    line.points = true;
    for (int ranks = 8; ranks <= 4096; ranks *= 2) {
        double work = 0, talk = 0, copies = 0, own = 0, neighbours = 0;
        bool possible = true;
        std::string imbalance;
        for (const Size& s : sizes) {
            const Division d = divide(s, setup.simulation.mirrors, ranks);
            possible = possible && d.possible;
            work += s.steps * d.imbalance * s.all_work / ranks / densest / machine.pace;
            talk += s.steps * (counted.exchanges * d.neighbours * machine.latency +
                               d.copies * counted.bytes_a_copy / machine.bandwidth +
                               counted.collectives * std::log2(ranks) * machine.latency);
            copies += d.all_copies, own += s.all_particles, neighbours = std::max(neighbours, d.neighbours);
            char text[16];
            std::snprintf(text, sizeof text, "%s%.2f", imbalance.empty() ? "" : ", ", d.imbalance);
            imbalance += text;
        }
        const double efficiency = alone / ranks / (work + talk);
        if (!possible) {
            std::printf("%6d | fewer columns with particles than ranks\n", ranks);
            break;
        }
        std::printf("%6d | %-23s | %11.2f | %10.0f | %9.3g | %9.3g | %.2f\n", ranks, imbalance.c_str(), copies / own,
                    neighbours, 1e3 * work, 1e3 * talk, efficiency);
        line.x.push_back(ranks), line.y.push_back(efficiency);
    }
    if (figure != nullptr)
        write_text_atomically(figure, svg_file(svg({.title = "Efficiency by the model",
                                                    .x_label = "ranks",
                                                    .y_label = "time of one rank over ranks times theirs",
                                                    .lines = {line},
                                                    .levels = {{"0.7", 0.7}},
                                                    .include_zero = true,
                                                    .log_x = true})));
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2) {
        std::fprintf(stderr, "usage: model_ranks SCENE.toml [FINER] [FIGURE.svg]\n");
        return 2;
    }
    try {
        model(read_scene(argv[1]), argc > 2 ? std::max(1, std::atoi(argv[2])) : 1, argc > 3 ? argv[3] : nullptr);
    } catch (const std::exception& e) {
        std::fprintf(stderr, "%s\n", e.what());
        return 2;
    }
    return 0;
}
