#include "sph_solver/bench.h"

#include <fmt/format.h>

#include "app/facts_json.h"
#include "app/output.h"

namespace tw::app {

int run_bench_command(const BenchCommand& command, const Common& common) {
    const std::vector<PassesPace> paces = measure_passes(runnable_passes());
    const BenchResult r = run_bench(command.particles, command.h_over_dp, command.threads, command.seconds);
    say(common,
        fmt::format(
            "{} particles, {:.0f} neighbours each, {:.0f} visited, {} threads, {}\n"
            "{:.3g} million particle evaluations/s, {:.3g} million pairs/s\n"
            "{:.0f} bytes per particle, {:.0f} % of the kernels' own peak, {:.0f} % of the time outside the pairs\n"
            "variants of the pair loops on one core: {}\n",
            r.particles, r.neighbours_per_particle, r.visited_per_particle, r.threads, r.isa,
            r.evaluations_per_second / 1e6, r.pairs_per_second / 1e6, r.bytes_per_particle,
            100 * r.share_of_kernel_peak, 100 * r.share_outside_pairs, passes_line(paces)));
    write_json(common, bench_json(r, paces));
    return done;
}

}  // namespace tw::app
