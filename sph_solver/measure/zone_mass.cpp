#include "sph_solver/measure/zone_mass.h"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <utility>

#include "record/recorded_checks.h"

namespace tw {

namespace {
constexpr std::ptrdiff_t frames = 8;
}

void ZoneMass::add(const std::vector<LevelLedger>& sizes) {
    sums_.resize(sizes.size());
    for (std::size_t k = 0; k < sizes.size(); ++k) sums_[k].drift += sizes[k].mass_drift, ++sums_[k].steps;
}

double ZoneMass::take_mean(std::size_t k) {
    if (k >= sums_.size()) return 0;
    const Sum sum = std::exchange(sums_[k], {});
    return sum.steps > 0 ? sum.drift / sum.steps : 0;
}

void check_zone_mass(const Table& level, RunRecord& record) {
    const Column* drift = level.find("mass_drift");
    if (!drift || level.time.empty()) return;
    const std::vector<double>& all = drift->values;
    const auto last = std::min(frames, std::ssize(all));
    const double mean = std::accumulate(all.end() - last, all.end(), 0.0) / double(frames);
    note_worst(record, {mass_drift_line, "%", std::abs(mean), 0.5, level.time.back()});
}

}  // namespace tw
