// Throughput of the full delta-SPH right-hand side on this machine, as a table. usage: bench_sph [seconds per row]
#include <cstdlib>

#include <fmt/format.h>
#include <omp.h>

#include "sph_solver/bench.h"

int main(int argc, char** argv) {
    const double seconds = argc > 1 ? std::atof(argv[1]) : 5;
    fmt::print(
        "| particles | h/dp | threads | set | M evaluations/s | M pairs/s | bytes/particle | of kernel peak | outside "
        "pairs |\n|---|---|---|---|---|---|---|---|---|\n");
    for (std::int64_t n : {100000, 1000000})
        for (double h_over_dp : {1.5, 2.0})
            for (int threads : {1, omp_get_num_procs()}) {
                const tw::BenchResult r = tw::run_bench(n, h_over_dp, threads, seconds);
                fmt::print("| {} | {} | {} | {} | {:.2f} | {:.0f} | {:.0f} | {:.0f} % | {:.0f} % |\n", r.particles,
                           h_over_dp, r.threads, r.isa, r.evaluations_per_second / 1e6, r.pairs_per_second / 1e6,
                           r.bytes_per_particle, 100 * r.share_of_kernel_peak, 100 * r.share_outside_pairs);
            }
    return 0;
}
