#include "statistics/settled_mean.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <vector>

#include "statistics/drift.h"
#include "statistics/error_of_mean.h"
#include "statistics/mser.h"
#include "statistics/time_bins.h"
#include "text/plain_number.h"

namespace tw {

namespace {

SettledMean unknown(std::string why) {
    SettledMean m;
    m.why_not = std::move(why);
    return m;
}

SettledMean too_short(SettledMean m, double more, const std::string& why) {
    SettledMean refused;
    refused.from = m.from;
    refused.to = m.to;
    refused.n_effective = m.n_effective;
    refused.seconds_needed = more;
    refused.why_not = fmt::format("record too short: {}; about {} s more is needed", why, plain_number(more, 2));
    return refused;
}

double mean_of(std::span<const double> x) {
    return std::accumulate(x.begin(), x.end(), 0.0) / static_cast<double>(x.size());
}

double allowed_error(const SettledRules& rules, double mean) {
    return std::max(rules.largest_error * std::abs(mean), rules.allowed_error);
}

/// The mean of a window in which a trend is seen, with what the trend may still change in it. Towards x_inf as
/// exp(-t/theta) the mean of a window T lacks x_inf by theta/T of the change over the window; theta is taken as the
/// whole record, the slowest approach that it can show. Known where that is within what the permitted standard error
/// makes of an interval.
SettledMean drifting_mean(SettledMean m, double mean, const Drift& drift, double record_over_window,
                          const SettledRules& rules) {
    const double lacking = record_over_window * std::abs(drift.change), allowed = 2 * allowed_error(rules, mean);
    const double record = record_over_window * (m.to - m.from);
    m.n_effective = drift.n_effective;
    if (!(lacking <= allowed))
        return too_short(m, record * (allowed > 0 ? std::log(lacking / allowed) : 1),
                         fmt::format("the series still changes by {} % of the mean in {:.2g} s, {} % allowed",
                                     plain_number(100 * lacking / std::abs(mean), 2), record,
                                     plain_number(100 * allowed / std::abs(mean), 2)));
    m.known = true;
    m.value = mean;
    m.half_width = lacking + std::hypot(record_over_window * drift.interval,
                                        correlated_t_95(drift.n_effective, 2) * drift.mean_error);
    m.limited_by = "slow changes of the series";
    return m;
}

/// Finite values from a time on.
struct Samples {
    std::vector<double> time, values;
};

Samples samples_from(std::span<const double> time, std::span<const double> values, double from) {
    Samples s;
    for (std::size_t i = 0; i < std::min(time.size(), values.size()); ++i) {
        if (!(time[i] >= from) || !std::isfinite(values[i])) continue;
        s.time.push_back(time[i]);
        s.values.push_back(values[i]);
    }
    return s;
}

/// Why there is no sample from `rules.from` on.
SettledMean without_samples(std::span<const double> time, std::span<const double> values, const SettledRules& rules) {
    if (std::ranges::none_of(values, [](double v) { return std::isfinite(v); }))
        return unknown("no value in the whole record");
    const double end = time.empty() ? 0 : time.back();
    if (end >= rules.from) return unknown(fmt::format("no value after {:.3g} s", rules.from));
    return too_short({}, rules.from - end + 3 * rules.flow_through,
                     fmt::format("it ends at {:.3g} s and means begin at {:.3g} s", end, rules.from));
}

/// The mean of a window without a trend, whose noise is correlated. `resolution`: a deviation that is none [unit of the
/// series].
SettledMean steady_mean(SettledMean m, std::span<const double> settled, double mean, const Drift& drift,
                        double record_over_window, double resolution, const SettledRules& rules) {
    const double n = static_cast<double>(settled.size()), window = m.to - m.from;
    const double window_needed = rules.fewest_flow_throughs * rules.flow_through;
    const bool long_enough = !(rules.flow_through > 0 && window < window_needed);
    double squares = 0;
    for (const double v : settled) squares += (v - mean) * (v - mean);
    const double tau = integrated_autocorrelation_time(settled);
    m.n_effective = n / (2 * tau);
    const double s = std::sqrt(squares / (n - 1));
    const double u = s / std::sqrt(m.n_effective);

    if (m.n_effective < rules.fewest_independent && s <= resolution && long_enough) {
        m.known = true;
        m.value = mean;
        m.half_width = std::max(2 * s, record_over_window * std::abs(drift.change));
        m.limited_by = "slow changes of the series";
        return m;
    }
    if (m.n_effective < rules.fewest_independent)
        return too_short(
            m, window * (rules.fewest_independent / m.n_effective - 1),
            fmt::format("{:.2g} independent samples, {:g} needed", m.n_effective, rules.fewest_independent));
    if (!long_enough)
        return too_short(m, window_needed - window,
                         fmt::format("{:.2g} flow-through times after the transient, {:g} needed",
                                     window / rules.flow_through, rules.fewest_flow_throughs));
    const double allowed = allowed_error(rules, mean), t95 = correlated_t_95(m.n_effective, 1);
    if (u > allowed && rules.allowed_error == 0 &&
        t95 * u >= std::abs(mean))  // no record is long enough for 2 % of nothing
        return unknown(fmt::format("its mean, {} ± {}, cannot be distinguished from zero", plain_number(mean, 2),
                                   plain_number(t95 * u, 2)));
    if (u > allowed)
        return too_short(
            m, allowed > 0 ? window * ((u / allowed) * (u / allowed) - 1) : window,
            fmt::format("standard error {} % of the mean, {} % allowed", plain_number(100 * u / std::abs(mean), 2),
                        plain_number(100 * allowed / std::abs(mean), 2)));

    const auto batch = static_cast<std::size_t>(std::min(n / 5, std::max(std::sqrt(n), 10 * tau)));
    const double second = batch_means_error(settled, batch);
    m.known = true;
    m.value = mean;
    m.half_width = t95 * u;
    m.second_opinion = t95 * second;
    m.unreliable = std::max(u, second) > 1.5 * std::min(u, second);
    if (m.unreliable) m.half_width = std::max(m.half_width, m.second_opinion);
    return m;
}

}  // namespace

SettledMean settled_mean(std::span<const double> time, std::span<const double> values, const SettledRules& rules) {
    const auto [t, x] = samples_from(time, values, rules.from);
    if (t.empty()) return without_samples(time, values, rules);
    SettledMean m;
    m.from = t.front();
    m.to = t.back();
    constexpr std::size_t fewest_samples = 10;
    if (t.size() < fewest_samples || !(m.to > m.from)) {
        const double per_sample = t.size() > 1 ? (m.to - m.from) / static_cast<double>(t.size() - 1) : 0;
        return too_short(m, std::max(rules.flow_through * rules.fewest_flow_throughs, per_sample * fewest_samples),
                         fmt::format("{} samples after {:.3g} s", t.size(), rules.from));
    }

    constexpr std::size_t most_bins = 4096;
    const std::vector<double> bins = time_bins(t, x, std::min(t.size(), most_bins));
    const double bin = (m.to - m.from) / static_cast<double>(bins.size());
    // A slow creep that stays within half the permitted error is no transient worth a refusal.
    const double half_error = 0.5 * rules.largest_error * std::abs(bins.back());
    const double resolution =
        std::isfinite(rules.allowed_error) ? std::max(rules.allowed_error, half_error) : half_error;
    auto cut = mser_cut(bins, std::isfinite(rules.allowed_error) ? rules.allowed_error : 0);
    if (!cut) cut = mser_cut(bins, resolution);
    if (!cut) return too_short(m, m.to - m.from, "the series is still settling");
    m.from += bin * static_cast<double>(*cut);
    const std::span<const double> settled = std::span(bins).subspan(*cut);

    const double window = m.to - m.from, mean = mean_of(settled);
    const bool long_enough = !(rules.flow_through > 0 && window < rules.fewest_flow_throughs * rules.flow_through);
    const Drift drift = drift_of(settled);
    const double record_over_window = (m.to - t.front()) / window;
    return drift.seen() && long_enough ? drifting_mean(m, mean, drift, record_over_window, rules)
                                       : steady_mean(m, settled, mean, drift, record_over_window, resolution, rules);
}

}  // namespace tw
