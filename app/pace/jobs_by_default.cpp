#include "app/pace/jobs_by_default.h"

#include <algorithm>
#include <functional>

namespace tw::app {
namespace {

constexpr double another_thread = 0.97, another_rank = 0.7;  // measured on two cores
constexpr double worth_it = 0.9, least_seconds = 30;         // of the time one after another; of that time [s]

}  // namespace

SideBySideChoice jobs_by_default(std::vector<JobCost> runs, int cores, double memory) {
    SideBySideChoice choice;
    for (const JobCost& r : runs)
        choice.one_by_one += r.core_seconds / (1 + (r.cores_alone - 1) * (r.threads ? another_thread : another_rank));
    choice.together = choice.one_by_one;
    const auto jobs = std::min(static_cast<std::size_t>(std::max(cores, 1)), runs.size());
    if (jobs < 2 || choice.one_by_one < least_seconds) return choice;

    std::ranges::sort(runs, std::greater{}, &JobCost::bytes);
    double bytes = 0;
    for (std::size_t k = 0; k < jobs; ++k) bytes += runs[k].bytes;
    if (bytes > memory) return choice;

    // The longest first, each on the core that is free first (SideBySide).
    std::ranges::sort(runs, std::greater{}, &JobCost::core_seconds);
    std::vector<double> busy(jobs, 0.0);
    for (const JobCost& r : runs) *std::ranges::min_element(busy) += r.core_seconds;
    const double together = std::ranges::max(busy);
    if (!(together < worth_it * choice.one_by_one)) return choice;
    choice.jobs = static_cast<int>(jobs), choice.together = together;
    return choice;
}

}  // namespace tw::app
