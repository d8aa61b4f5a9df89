#pragma once
#include <cstdint>
#include <string>

#include "sph_solver/choose_passes.h"

namespace tw {

/// Throughput of this machine on a block of jittered particles in a closed box: full delta-SPH right-hand side
/// (renormalised gradient pass and force pass), lists rebuilt as in a run.
struct BenchResult {
    std::int64_t particles = 0;
    double neighbours_per_particle = 0;  ///< [-]
    int threads = 0;
    std::string isa;
    double evaluations_per_second = 0;  ///< particle evaluations of the whole right-hand side [1/s], all included
    double evaluations_per_processor_second = 0;  ///< of this process: others beside it take nothing away [1/s]
    double pairs_per_second = 0;                  ///< directed pairs within the support [1/s], both passes as one
    double bytes_per_particle = 0;                ///< [bytes]
    double bytes_on_device = 0;                   ///< of those, on a GPU [bytes]
    double visited_per_particle = 0;              ///< pairs that a pass works through, useful or not [-]
    double share_of_kernel_peak = 0;  ///< those per second in the pair passes over those of the same passes on data [-]
                                      ///< that never leaves the first cache
    double share_outside_pairs = 0;   ///< of a step: lists, sorting, updates [-]
    double share_for_lists = 0;       ///< of the time: making lists anew [-]
};
BenchResult run_bench(std::int64_t particles, double h_over_dp, int threads, double seconds,
                      const Passes& passes = choose_passes());
/// The same with a GPU that makes the steps; the shares of and outside the pairs are not known. Throws InputError where
/// there is none.
BenchResult run_bench_on_gpu(std::int64_t particles, double h_over_dp, int threads, double seconds);

}  // namespace tw
