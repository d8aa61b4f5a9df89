#include "app/machine_pace.h"
#include "sph_solver/bench.h"

namespace tw::app {
namespace {

/// `twinwake bench` on one thread of the machine that the table of scene/cost_estimate.cpp was made on [1/s].
constexpr double evaluations_of_the_table = 1.9e6;

}  // namespace

double calibrate_pace() {
    const double pace = evaluations_of_the_table / run_bench(30000, 1.5, 1, 1).evaluations_per_second;
    remember_calibration(pace);
    return pace;
}

}  // namespace tw::app
