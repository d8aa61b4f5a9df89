// What many ranks would bring: the pencils of a scene are divided for real, on one machine, for 8 to 4096 ranks, and
// imbalance, copies and neighbours are counted; the time of a step is a model of these counts and of a stated machine.
//
//   build/benchmarks/model_ranks SCENE.toml [FINER] [FIGURE.svg]
//
// FINER (default 1): so many times finer in each direction than the scene, without making those particles: each pencil
// is cut into FINER x FINER and has their share of its work. One step of the scene is made, so that its pairs are
// known. docs/decisions/067-ranks.md has the tables.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <vector>

#include "base/atomic_file.h"
#include "base/errors.h"
#include "compare/report/svg_plot.h"
#include "scene/scene.h"
#include "sph_solver/rank_model.h"
#include "sph_solver/scene_setup.h"

using namespace tw;

namespace {

void model(const Scene& scene, int finer, const char* figure) {
    const SphSetup setup = sph_setup(scene, 0);
    Simulation simulation(setup.simulation, setup.fluid);
    simulation.step();
    const std::vector<PencilsOfSize> sizes = pencils_of_water(simulation, finer);
    double densest = 0;
    for (const PencilsOfSize& s : sizes) {
        densest = std::max(densest, s.all_work / s.all_particles);
        std::printf("%.3g particles, %d steps of one of the largest, %d columns\n", s.all_particles, s.steps,
                    s.grid.count());
    }
    const MachineOfRanks machine;
    std::printf("model: %.1e evaluations/s a rank, messages %.0f us and %.2f GB/s a rank; counts of bench_ranks\n\n",
                machine.pace, 1e6 * machine.latency, 1e-9 * machine.bandwidth);
    std::printf("%6s | %-23s | %-11s | %10s | %9s | %9s | %s\n", "ranks", "imbalance of each size", "copies/own",
                "neighbours", "work, ms", "talk, ms", "efficiency");
    double alone = 0;
    for (const PencilsOfSize& s : sizes) alone += s.steps * s.all_work / densest / machine.pace;
    PlotLine line;
    line.points = true;
    for (int ranks = 8; ranks <= 4096; ranks *= 2) {
        double work = 0, talk = 0, copies = 0, own = 0, neighbours = 0;
        bool possible = true;
        std::string imbalance;
        for (const PencilsOfSize& s : sizes) {
            const Division d = divide(s, setup.simulation.mirrors, ranks);
            possible = possible && d.possible;
            work += s.steps * d.imbalance * s.all_work / ranks / densest / machine.pace;
            talk += s.steps * seconds_of_talk(d, ranks, machine);
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
