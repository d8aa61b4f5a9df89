// What the ranks of a particle run do and tell each other, counted: that says the same on any machine; and what a step
// takes on this one.
//
//   mpirun -n 4 build/benchmarks/bench_ranks SCENE.toml [STEPS] [NEAR_HULL] [THREADS]
//
// Prints the work of the rank that has most over the mean, the copies of others' particles that a rank holds, what a
// step sends; and, timed, a step with so many threads a rank (1), and the share that a rank's own sums of the loads
// have of it. docs/decisions/067-ranks.md has the tables.
#include <algorithm>
#include <cstdio>
#include <cstdlib>

#include "scene/scene.h"
#include "sph_solver/backend/threads.h"
#include "sph_solver/parallel/comm.h"
#include "sph_solver/phase_timer.h"
#include "sph_solver/scene_setup.h"

using namespace tw;

namespace {

/// Of the particles of one size.
void count_size(const Comm& ranks, const Level& level) {
    std::int64_t pairs = 0;
    for (const Cluster& g : level.system().near.clusters) pairs += g.size * level.system().live_pairs(g);
    const double most_pairs = ranks.largest(double(pairs)), all_pairs = double(ranks.sum(pairs));
    const auto copies = static_cast<std::int64_t>(level.share().copies());
    const double most_copies = ranks.largest(double(copies)), all_copies = double(ranks.sum(copies));
    if (!ranks.first()) return;
    std::printf("%d ranks, %lld particles of %g m\n", ranks.size(), static_cast<long long>(level.fields().count()),
                level.system().setup.dp);
    std::printf("pairs, largest over mean             %.3f\n", most_pairs * ranks.size() / all_pairs);
    std::printf("copies over own particles            %.3f (largest rank: %.0f)\n",
                all_copies / double(level.fields().count()), most_copies);
}

void count(const Comm& ranks, const Scene& scene, int steps, int threads) {
    const SphSetup setup = sph_setup(scene, threads, ranks);
    Simulation simulation(setup.simulation, setup.fluid);
    if (setup.control_volume) simulation.set_control_volume(*setup.control_volume);
    for (int k = 0; k < 20; ++k) simulation.step();  // the pencils are divided by their pairs by then

    const Comm::Traffic before = ranks.traffic();
    const std::int64_t lists_before = simulation.timers().rebuilds;
    const double start = wall_now(), processor_start = cpu_now();
    for (int k = 0; k < steps; ++k) simulation.step();
    const double step = (wall_now() - start) / steps;
    const double processor = ranks.sum(cpu_now() - processor_start) / steps;
    const Comm::Traffic& after = ranks.traffic();
    const auto most_a_step = [&](std::int64_t Comm::Traffic::*what) {
        return ranks.largest(double(after.*what - before.*what)) / steps;
    };
    const double messages = most_a_step(&Comm::Traffic::messages), bytes = most_a_step(&Comm::Traffic::bytes),
                 exchanges = most_a_step(&Comm::Traffic::exchanges),
                 collectives = most_a_step(&Comm::Traffic::collectives);

    constexpr int repeats = 100;
    const double sums_start = wall_now();
    for (int k = 0; k < repeats; ++k) simulation.finest().loads().gather(setup.simulation.moment_reference);
    const double sums = (wall_now() - sums_start) / repeats;
    for (const auto& level : simulation.water()) count_size(ranks, *level);
    if (!ranks.first()) return;
    std::printf("lists made every %.1f steps of the largest size\n",
                double(steps) / double(std::max<std::int64_t>(1, simulation.timers().rebuilds - lists_before)));
    std::printf("a step of the rank with most: exchanges %.2f, messages %.2f, kB %.1f, collectives %.2f\n", exchanges,
                messages, bytes / 1e3, collectives);
    std::printf("a step                               %.3f s, processor time of all ranks %.3f s\n", step, processor);
    std::printf("exact sums of the loads              %.2f %% of a step, on this machine\n", 100 * sums / step);
}

}  // namespace

int main(int argc, char** argv) {
    if (argc < 2) {
        std::fprintf(stderr, "usage: mpirun -n RANKS bench_ranks SCENE.toml [STEPS] [NEAR_HULL] [THREADS]\n");
        return 2;
    }
    std::string failure;
    try {
        SceneOverrides overrides;
        if (argc > 3) overrides.near_hull = std::atof(argv[3]);
        count(Comm::world(), read_scene(argv[1], overrides), argc > 2 ? std::atoi(argv[2]) : 100,
              argc > 4 ? std::max(1, std::atoi(argv[4])) : 1);
    } catch (const std::exception& e) { failure = e.what(); }
    if (!failure.empty() && Comm::world().first()) std::fprintf(stderr, "%s\n", failure.c_str());
    Comm::world().end(failure.empty() ? 0 : 2, failure);
    return failure.empty() ? 0 : 2;
}
