#include "sph_solver/bench.h"

#include <cmath>
#include <ctime>
#include <random>

#include "sph_solver/backend/for_particles.h"
#include "sph_solver/backend/threads.h"
#include "sph_solver/on_gpu.h"
#include "sph_solver/phase_timer.h"
#include "sph_solver/simulation.h"

namespace tw {

namespace {

/// Candidate pairs per second of gradient + force pass on one cluster and 400 neighbours, all in the first cache, per
/// thread.
double kernel_peak(const Passes& passes, const WaterView& like, int threads) {
    constexpr int n = 400, repeats = 4000;
    double best = 0;
    for (int trial = 0; trial < 3; ++trial) {
        const double start = wall_now();
        on_each_of(threads, [&] {
            std::vector<PackedPlace> place(n);
            std::vector<PackedVelocityDensity> motion(n, PackedVelocityDensity{0, 0, 0, 0});
            std::vector<PackedGradientPressure> stress(n, PackedGradientPressure{0, 0, 0, 0});
            std::vector<PackedShiftSupport> shift(most_lanes);
            std::vector<PackedRate> rate(most_lanes);
            const std::vector<std::uint32_t> surface(n / 32 + 2, 0);
            std::vector<NeighbourBlock> list;
            for (int k = 0; k < n; ++k)
                place[static_cast<std::size_t>(k)] = {(k % 8) << 18, (k / 8 % 8) << 18, (k / 64) << 18, 1e-6f};
            for (int k = 0; k < n; k += 16) list.push_back({k, 0xffffu, 0});  // as full as lists are on average
            WaterView water = like;
            water.place = place.data(), water.motion = motion.data(), water.stress = stress.data();
            water.surface = surface.data();
            Cluster g;
            g.size = passes.lanes, g.list = {0, 0, static_cast<std::int32_t>(list.size())};
            NeighbourBlock* const chunk = list.data();
            water.list = {&chunk};
            const FirstPairLoopData first{
                .water = water, .stress = stress.data(), .shift = shift.data(), .rate = rate.data()};
            const SecondPairLoopData second{.water = water, .shift = shift.data(), .rate = rate.data()};
            for (int r = 0; r < repeats; ++r) {
                passes.run(first, &g, 1);
                passes.run(second, &g, 1);
            }
        });
        best = std::max(best, double(threads) * repeats * n * passes.lanes / (wall_now() - start));
    }
    return best;
}

BenchResult run_block(std::int64_t particles, double h_over_dp, int threads, double seconds, const Passes& passes,
                      bool on_gpu) {
    const int n = std::max(8, static_cast<int>(std::lround(std::cbrt(double(particles)))));
    SimulationSetup s;
    s.dp = 0.01;
    s.h_over_dp = h_over_dp;
    s.state_equation.c0 = 20;
    s.threads = threads > 0 ? threads : processors();
    s.domain = {Vec3::Zero(), Vec3::Constant(n * s.dp)};
    for (auto& axis : s.mirrors.on) axis = {true, true};
    Fluid fluid = fill_with_fluid(s, {s.domain});
    std::mt19937 random(1);
    std::uniform_real_distribution<double> jitter(-0.1 * s.dp, 0.1 * s.dp);
    for (Vec3& p : fluid.places) p += Vec3(jitter(random), jitter(random), jitter(random));
    Simulation simulation(s, fluid, passes);
    const std::string device = on_gpu ? leave_steps_to_gpu(simulation) : "";
    simulation.step();

    const Timers before = simulation.timers();
    const std::int64_t first = simulation.steps();
    const double start = wall_now();
    const std::clock_t processor = std::clock();
    while (wall_now() - start < seconds || simulation.steps() - first < 4) simulation.step();
    const double wall = wall_now() - start, of_processor = double(std::clock() - processor) / CLOCKS_PER_SEC;
    const Timers& t = simulation.timers();

    BenchResult r;
    r.particles = static_cast<std::int64_t>(fluid.places.size());
    r.threads = s.threads;
    r.isa = on_gpu ? device : passes.isa;
    r.evaluations_per_second = double(t.evaluations - before.evaluations) / wall;
    const double support = 2 * h_over_dp;
    r.evaluations_per_processor_second = double(t.evaluations - before.evaluations) / of_processor;
    r.neighbours_per_particle = 4.0 / 3 * 3.14159265358979 * support * support * support;
    r.pairs_per_second = r.evaluations_per_second * r.neighbours_per_particle;
    r.bytes_per_particle = simulation.bytes() / double(r.particles);
    r.bytes_on_device = simulation.bytes_on_device() / double(r.particles);
    r.visited_per_particle = double(simulation.level(0).maker().live_pairs()) / double(r.particles);
    r.share_for_lists = (t.lists - before.lists) / wall;
    if (on_gpu) return r;
    const double in_pairs = t.gradient + t.forces - before.gradient - before.forces;
    r.share_outside_pairs = 1 - in_pairs / wall;
    WaterView like;
    like.kernel = Kernel(simulation.h(), 3);
    like.unit = static_cast<float>(s.dp / (1 << 18));
    r.share_of_kernel_peak = r.visited_per_particle * double(t.evaluations - before.evaluations) / in_pairs /
                             kernel_peak(passes, like, s.threads);
    return r;
}

}  // namespace

BenchResult run_bench(std::int64_t particles, double h_over_dp, int threads, double seconds, const Passes& passes) {
    return run_block(particles, h_over_dp, threads, seconds, passes, false);
}

BenchResult run_bench_on_gpu(std::int64_t particles, double h_over_dp, int threads, double seconds) {
    return run_block(particles, h_over_dp, threads, seconds, passes_beside_gpu(), true);
}

}  // namespace tw
