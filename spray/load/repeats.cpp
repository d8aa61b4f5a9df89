#include "spray/load/repeats.h"

#include <cmath>

#include "base/errors.h"

namespace tw::spray {
namespace {

struct Moments {
    double mean = 0, deviation = 0;
};
Moments moments(const std::vector<double>& values) {
    const auto n = static_cast<double>(values.size());
    Moments m;
    for (const double v : values) m.mean += v / n;
    for (const double v : values) m.deviation += (v - m.mean) * (v - m.mean) / (n - 1);
    return {m.mean, std::sqrt(m.deviation)};
}

}  // namespace

Repeats repeats_of(std::span<const double> values) {
    if (values.size() < 2) throw InputError("measured: fewer than two repeats; expected a list of pressures");
    for (const double v : values)
        if (!std::isfinite(v)) throw InputError("measured: a value that is not finite");
    Repeats r;
    r.values.assign(values.begin(), values.end());
    const Moments all = moments(r.values);
    r.mean = all.mean, r.deviation = all.deviation;
    std::vector<double> kept;
    for (const double v : values) {
        const double off = std::abs(v - all.mean);
        if (all.deviation > 0) r.farthest = std::max(r.farthest, off / all.deviation);
        if (!(off > 3 * all.deviation)) kept.push_back(v);
    }
    r.left_out = values.size() - kept.size();
    const Moments rest = moments(kept);
    r.kept_mean = rest.mean, r.error = rest.deviation / std::sqrt(static_cast<double>(kept.size()));
    return r;
}

}  // namespace tw::spray
