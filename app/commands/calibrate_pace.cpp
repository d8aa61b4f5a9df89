#include "app/pace/machine_pace.h"
#include "sph_solver/bench.h"

namespace tw::app {
namespace {

/// `twinwake bench` on one thread of the machine that the table of scene/cost/cost_estimate.cpp was made on [1/s].
constexpr double evaluations_of_the_table = 3.57e6;
/// What a GPU loses of its bench in a run, beside what that machine does: frames and edges of sizes stay on the host.
constexpr double lost_by_gpu = 1.38;

}  // namespace

double calibrate_pace() {
    // by the processor's time: of a busy hour the calibration must not tell
    const double pace = evaluations_of_the_table / run_bench(30000, 1.5, 1, 1).evaluations_per_processor_second;
    remember_calibration("", pace);
    return pace;
}

double calibrate_gpu_pace(const std::string& method) {
    // few particles at first: a device that is none takes seconds for them
    constexpr double fast = 20e6;  // [1/s]
    constexpr double h_over_dp = 1.5;
    double evaluations = run_bench_on_gpu(20000, h_over_dp, 0, 0).evaluations_per_second;
    if (evaluations > fast) evaluations = run_bench_on_gpu(500000, h_over_dp, 0, 0.5).evaluations_per_second;
    const double pace = lost_by_gpu * evaluations_of_the_table / evaluations;
    remember_calibration(method, pace);
    return pace;
}

}  // namespace tw::app
