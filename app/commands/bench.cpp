#include "sph_solver/bench.h"

#include <fmt/format.h>

#include "app/arguments/output.h"
#include "app/runs/facts_json.h"
#include "sph_solver/on_gpu.h"

namespace tw::app {

int run_bench_command(const BenchCommand& command, const Common& common) {
    if (command.device == "gpu") {
        const BenchResult r = run_bench_on_gpu(command.particles, command.h_over_dp, command.threads, command.seconds);
        say(common,
            fmt::format("{} particles, {:.0f} neighbours each, {:.0f} visited, {}\n"
                        "{:.3g} million particle evaluations/s, {:.3g} million between two makings of the lists, "
                        "which take {:.0f} % of the time\n"
                        "{:.0f} bytes per particle, {:.0f} of them on the device; the device at most: {}\n",
                        r.particles, r.neighbours_per_particle, r.visited_per_particle, r.isa,
                        r.evaluations_per_second / 1e6, r.evaluations_per_second / 1e6 / (1 - r.share_for_lists),
                        100 * r.share_for_lists, r.bytes_per_particle, r.bytes_on_device, gpu_peaks_in_words()));
        write_json(common, bench_json(r, {}));
        return done;
    }
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
