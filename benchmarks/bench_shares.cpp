// Where the time of a particle run of a scene goes: a row for each share of it outside the loops over pairs, and these.
//
//   build/benchmarks/bench_shares SCENE.toml [STEPS] [NEAR_HULL] [THREADS]
//
// Timed are the set-up and, after 20 steps, so many steps (100) with what the run records after each. A frame is
// recorded, and lists are made anew, at each sampling interval of the scene, as in a run; pictures, checkpoints and
// files are left out.
#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <utility>
#include <vector>

#include "scene/new_record.h"
#include "scene/scene.h"
#include "sph_solver/backend/threads.h"
#include "sph_solver/measure/recorder.h"
#include "sph_solver/phase_timer.h"
#include "sph_solver/scene_setup.h"

using namespace tw;

namespace {

/// A part of the steps, and what it took until they were timed [s].
struct Part {
    const char* name;
    double Timers::*what;
    double before = 0;
};

void measure(const Scene& scene, int steps, int threads) {
    const Threads own(threads);
    const double start = wall_now();
    const SphSetup setup = sph_setup(scene, threads);
    Simulation simulation(setup.simulation, setup.fluid);
    if (setup.control_volume) simulation.set_control_volume(*setup.control_volume);
    Recorder recorder(scene, simulation, new_record(scene, "sph"));
    const double set_up = wall_now() - start;

    double next_frame = scene.sampling.interval, stepping = 0, measuring = 0;
    const auto make_steps = [&](int n) {
        for (int k = 0; k < n; ++k) {
            const double before = wall_now();
            simulation.step();
            const double between = wall_now();
            const bool frame = simulation.time() >= next_frame;
            recorder.after_step(simulation, frame);
            if (frame) simulation.mark_restart_point(), next_frame += scene.sampling.interval;
            stepping += between - before, measuring += wall_now() - between;
        }
    };
    const auto taken = [&](double Timers::*what) {
        double sum = 0;
        for (const auto& level : simulation.water()) sum += level->timers().*what;
        return sum;
    };
    const auto at_edges = [&] {
        double sum = 0;
        for (const Refinement& edge : simulation.refinements()) sum += edge.ledger().seconds;
        return sum;
    };
    std::vector<Part> parts{{"first pair loop", &Timers::gradient},
                            {"second pair loop", &Timers::forces},
                            {"lists made anew", &Timers::lists},
                            {"lists pruned", &Timers::pruning},
                            {"records, images, densities", &Timers::update},
                            {"dummies of walls", &Timers::walls},
                            {"effects", &Timers::effects},
                            {"end of a step", &Timers::advance}};
    make_steps(20);
    for (Part& part : parts) part.before = taken(part.what);
    const double edges_before = at_edges();
    std::vector<std::pair<std::int64_t, std::int64_t>> before;  // steps and lists of each size
    for (const auto& level : simulation.water()) before.emplace_back(level->system().steps, level->timers().rebuilds);
    stepping = measuring = 0;
    make_steps(steps);

    const double all = stepping + measuring;
    std::printf("set-up %.2f s (%d iterations of the pressure), %d steps %.2f s, threads %d\n", set_up,
                setup.pressure_iterations, steps, all, threads);
    for (std::size_t k = 0; k < before.size(); ++k) {
        const Level& level = simulation.level(k);
        std::printf("%lld particles of %g m, lists made every %.1f steps\n",
                    static_cast<long long>(level.fields().count()), level.system().setup.dp,
                    double(level.system().steps - before[k].first) /
                        double(std::max<std::int64_t>(1, level.timers().rebuilds - before[k].second)));
    }
    std::printf("\n| part | ms a step | share |\n|---|---|---|\n");
    double rest = stepping;
    const auto row = [&](const char* name, double seconds) {
        std::printf("| %s | %.3f | %.1f %% |\n", name, 1e3 * seconds / steps, 100 * seconds / all);
        rest -= seconds;
    };
    for (const Part& part : parts) row(part.name, taken(part.what) - part.before);
    row("edges between sizes", at_edges() - edges_before);
    row("measuring", measuring), rest += measuring;
    row("rest of a step", rest);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2) {
        std::fprintf(stderr, "usage: bench_shares SCENE.toml [STEPS] [NEAR_HULL] [THREADS]\n");
        return 2;
    }
    try {
        SceneOverrides overrides;
        if (argc > 3) overrides.near_hull = std::atof(argv[3]);
        measure(read_scene(argv[1], overrides), argc > 2 ? std::atoi(argv[2]) : 100,
                argc > 4 ? std::max(1, std::atoi(argv[4])) : 1);
    } catch (const std::exception& e) {
        std::fprintf(stderr, "%s\n", e.what());
        return 2;
    }
    return 0;
}
