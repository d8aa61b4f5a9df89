#include "compare/metrics/sound.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "methods/methods.h"
#include "record/record_numbers.h"

namespace tw {

namespace {

constexpr double particles_crossed = 6;

/// The opening of one stretch of finite samples: the least value of each window that begins or ends on a sample, and at
/// each sample the largest of the windows that hold it.
void open_stretch(std::span<const double> t, std::span<const double> x, double shortest, std::span<double> out) {
    const double slack = 1e-9 * shortest;
    const auto at = [&](double time) {
        const auto after =
            std::clamp<std::ptrdiff_t>(std::ranges::upper_bound(t, time) - t.begin(), 1, std::ssize(t) - 1);
        const auto k = static_cast<std::size_t>(after);
        return x[k - 1] + (x[k] - x[k - 1]) * (time - t[k - 1]) / (t[k] - t[k - 1]);
    };
    for (std::size_t i = 0; i < t.size(); ++i)
        for (const double from : {t[i], t[i] - shortest}) {
            const double to = from + shortest;
            if (from < t.front() - slack || to > t.back() + slack) continue;
            const auto first = std::ranges::lower_bound(t, from - slack) - t.begin(),
                       last = std::ranges::upper_bound(t, to + slack) - t.begin();
            double least = std::min(at(from), at(to));
            for (auto k = first; k < last; ++k) least = std::min(least, x[static_cast<std::size_t>(k)]);
            for (auto k = first; k < last; ++k) {
                double& here = out[static_cast<std::size_t>(k)];
                if (!(here >= least)) here = least;
            }
        }
}

}  // namespace

double sound_time(const RunRecord& record) {
    const double c0 = number_of(record, "c0", 0), dp = number_of(record, "near_hull", 0);
    return c0 > 0 && dp > 0 ? particles_crossed * dp / c0 : 0;
}

std::vector<double> lasting(std::span<const double> t, std::span<const double> x, double shortest) {
    if (!(shortest > 0)) return {x.begin(), x.end()};
    std::vector<double> out(t.size(), nan);
    for (std::size_t begin = 0; begin < t.size();) {
        std::size_t end = begin;
        while (end < t.size() && std::isfinite(x[end])) ++end;
        if (end - begin > 1)
            open_stretch(t.subspan(begin, end - begin), x.subspan(begin, end - begin), shortest,
                         std::span(out).subspan(begin, end - begin));
        begin = end + 1;
    }
    return out;
}

std::string why_sound(double peak, double lasts, double shortest, const std::string& unit) {
    if (!(shortest > 0) || !(std::abs(lasts) < least_lasting * std::abs(peak))) return {};
    return fmt::format(
        "not judged: sound of the impact. Of {:.3g} {} no more than {:.2g} {} lasts for {:.2g} ms, in which sound "
        "crosses "
        "six particles; shorter peaks grow with the sound speed and say nothing about the flow",
        peak, unit, lasts, unit, 1e3 * shortest);
}

void set_sound_aside(Quantity& q, std::size_t source, double lasts, double shortest, const std::string& name) {
    MeanValue& m = q.values[source];
    if (!m.known) return;
    m.not_resolved = why_sound(m.value, lasts, shortest, q.unit);
    if (m.not_resolved.empty()) return;
    q.not_resolved += (q.not_resolved.empty() ? "" : "; ") + method_label(name) + ": " + m.not_resolved;
}

}  // namespace tw
