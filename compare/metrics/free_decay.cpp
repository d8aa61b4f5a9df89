#include "compare/metrics/free_decay.h"

#include <fmt/format.h>
#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <functional>
#include <numbers>
#include <set>
#include <vector>

#include "compare/metrics/quantity.h"
#include "compare/metrics/wave_samples.h"
#include "compare/verdict/judge.h"
#include "record/record_numbers.h"
#include "record/run_record.h"
#include "statistics/student_t.h"

namespace tw {
namespace {

using std::numbers::pi;

constexpr int fewest_half_swings = 3;
constexpr double share_of_first = 0.05;  ///< smaller swings are left out: noise and waves that came back
constexpr double largest_misfit = 0.15;  ///< root mean square over the first swing: what is left is no free decay
constexpr double smallest_share = 1e-3;  ///< of the body's length, or of a radian: smaller motions are none

/// Highest and lowest values between crossings of a level, from the first extreme on that lies within the record.
std::vector<TurningPoint> extremes_about(std::span<const double> t, std::span<const double> x, double level) {
    std::vector<TurningPoint> out;
    std::size_t from = 0;
    for (std::size_t i = 1; i <= x.size(); ++i) {
        if (i < x.size() && (x[i] - level) * (x[from] - level) > 0) continue;
        std::size_t best = from;
        for (std::size_t j = from; j < i; ++j)
            if (std::abs(x[j] - level) > std::abs(x[best] - level)) best = j;
        // a release is an extreme though it stands at the record's edge; what is cut off at its end is none
        if (i < x.size()) out.push_back(turning_point(t, x, best, level));
        from = i;
    }
    return out;
}

/// Where swings are smaller than a share of the first they end.
void leave_small_ones(std::vector<TurningPoint>& extremes, double smallest) {
    if (extremes.empty()) return;
    const double least = std::max(share_of_first * std::abs(extremes.front().x), smallest);
    const auto end = std::ranges::find_if(extremes, [&](const TurningPoint& e) { return std::abs(e.x) < least; });
    extremes.erase(end, extremes.end());
}

/// Least squares for level, A cos, A sin, delta and omega by Gauss-Newton steps.
struct Fit {
    Eigen::Vector<double, 5> p;  ///< level, a, b, delta, omega
    double rms = 0;
    bool found = false;
};
Fit fitted(std::span<const double> t, std::span<const double> x, double delta, double omega, double level,
           double first) {
    Fit fit;
    fit.p << level, first, 0, delta, omega;
    const auto n = static_cast<Eigen::Index>(t.size());
    Eigen::MatrixXd J(n, 5);
    Eigen::VectorXd off(n);
    for (int step = 0; step < 60; ++step) {
        for (Eigen::Index i = 0; i < n; ++i) {
            const double at = t[static_cast<std::size_t>(i)] - t[0], e = std::exp(-fit.p(3) * at),
                         c = std::cos(fit.p(4) * at), s = std::sin(fit.p(4) * at), swing = fit.p(1) * c + fit.p(2) * s;
            off(i) = x[static_cast<std::size_t>(i)] - fit.p(0) - e * swing;
            J(i, 0) = 1, J(i, 1) = e * c, J(i, 2) = e * s, J(i, 3) = -at * e * swing;
            J(i, 4) = at * e * (fit.p(2) * c - fit.p(1) * s);
        }
        const Eigen::Vector<double, 5> change = J.colPivHouseholderQr().solve(off);
        fit.p += change;
        if (!fit.p.allFinite() || !(fit.p(4) > 0.2 * omega) || !(fit.p(4) < 5 * omega)) return fit;
        if (std::abs(change(3)) + std::abs(change(4)) < 1e-10 * omega) {
            fit.rms = off.norm() / std::sqrt(static_cast<double>(n));
            fit.found = true;
            return fit;
        }
    }
    return fit;
}

/// Length of a body [m]; of a record without its shape 0.1.
double length_of(const RunRecord& r, const std::string& body) {
    const auto shape = std::ranges::find(r.bodies, body_table(body), &BodyShape::table);
    return shape == r.bodies.end() ? 0.1 : shape->surface.bounds().size().maxCoeff();
}

/// Half width of the mean of values [their unit]; none of fewer than three.
double half_width_of(const std::vector<double>& values) {
    return values.size() < 3 ? NAN : mean_of_independent(values).half_width;
}

}  // namespace

FreeDecay free_decay(std::span<const double> t, std::span<const double> x, double smallest) {
    FreeDecay out;
    const auto none = [&](std::string why) {
        out.why_not = why;
        out.period = out.damping = unknown_value(std::move(why));
        return out;
    };
    if (t.size() < 20) return none("too few samples");
    // the level about which it swings: that of the last third of the record to begin with, then that of the fit
    double level = 0;
    const std::size_t last = t.size() - t.size() / 3;
    for (std::size_t i = last; i < t.size(); ++i) level += x[i] / static_cast<double>(t.size() - last);
    std::vector<TurningPoint> extremes;
    Fit fit;
    for (int round = 0; round < 3; ++round) {
        extremes = extremes_about(t, x, level);
        leave_small_ones(extremes, smallest);
        if (static_cast<int>(extremes.size()) <= fewest_half_swings)
            return none(fmt::format("it swings to and fro fewer than {} times", fewest_half_swings));
        const double half = (extremes.back().t - extremes.front().t) / static_cast<double>(extremes.size() - 1),
                     delta = std::log(std::abs(extremes.front().x / extremes.back().x)) /
                             (extremes.back().t - extremes.front().t);
        const auto begin = static_cast<std::size_t>(std::ranges::lower_bound(t, extremes.front().t) - t.begin()),
                   end =
                       static_cast<std::size_t>(std::ranges::upper_bound(t, extremes.back().t + half / 2) - t.begin());
        if (end - begin < 20) return none("too few samples");
        fit = fitted(t.subspan(begin, end - begin), x.subspan(begin, end - begin), delta, pi / half, level,
                     extremes.front().x);
        if (!fit.found || !(fit.p(3) > 0)) return none("it is no oscillation that dies out");
        level = fit.p(0);
    }
    if (!(fit.rms < largest_misfit * std::abs(extremes.front().x))) return none("it is no oscillation that dies out");
    const double omega = fit.p(4), delta = fit.p(3), period = 2 * pi / omega;
    std::vector<double> periods, dampings;
    for (std::size_t i = 1; i < extremes.size(); ++i) {
        const double decrement = std::log(std::abs(extremes[i - 1].x / extremes[i].x)) / pi;
        periods.push_back(2 * (extremes[i].t - extremes[i - 1].t));
        dampings.push_back(decrement / std::hypot(1, decrement));
    }
    out.half_swings = static_cast<int>(extremes.size()) - 1;
    out.level = level;
    out.period = known_value(period, half_width_of(periods), extremes.front().t, extremes.back().t);
    out.damping =
        known_value(delta / std::hypot(delta, omega), half_width_of(dampings), extremes.front().t, extremes.back().t);
    return out;
}

void add_free_decay(Comparison& comparison) {
    std::set<std::string> bodies;
    for (const RunRecord& r : comparison.sources) {
        if (number_of(r, "wave_period", 0) > 0 || !text_of(r, "sea").empty() || number_of(r, "speed", 0) > 0) return;
        for (const auto& [name, table] : r.tables)
            if (name.starts_with("body_") && table.find("z") && table.find("q0") && table.find("qx") &&
                table.find("qy"))
                bodies.insert(name.substr(5));
    }
    struct Motion {
        const char *name, *label, *column;
    };
    constexpr Motion motions[] = {{"heave", "heave", "z"}, {"pitch", "pitch", "qy"}, {"roll", "roll", "qx"}};
    for (const std::string& body : bodies)
        for (const Motion& motion : motions) {
            Quantity period = new_quantity(fmt::format("{}_period:{}", motion.name, body),
                                           fmt::format("Period of the free {} of {}", motion.label, body), "s",
                                           "of an exponentially damped oscillation fitted to the record from its first "
                                           "extreme on; interval by the half swings"),
                     damping = new_quantity(fmt::format("{}_damping:{}", motion.name, body),
                                            fmt::format("Damping of the free {} of {}", motion.label, body), "-",
                                            "share of the critical damping, by the same fit");
            bool any = false;
            for (const RunRecord& r : comparison.sources) {
                const auto table = r.tables.find(body_table(body));
                MeanValue none = unknown_value(not_given);
                if (table == r.tables.end() || !table->second.find(motion.column)) {
                    period.values.push_back(none), damping.values.push_back(none);
                    continue;
                }
                const Table& rows = table->second;
                const bool turns = motion.column[0] == 'q';
                const WaveSamples s = samples_between(rows.time, -HUGE_VAL, HUGE_VAL, [&](std::size_t i) {
                    const double v = rows.find(motion.column)->values[i];
                    return turns ? 2 * std::atan2(v, rows.find("q0")->values[i]) : v;
                });
                const FreeDecay decay =
                    free_decay(s.t, s.x, turns ? smallest_share : smallest_share * length_of(r, body));
                any |= decay.period.known;
                period.values.push_back(decay.period), damping.values.push_back(decay.damping);
            }
            if (!any) continue;
            for (Quantity* q : {&period, &damping}) {
                beside(*q);
                q->judged_in_grid_study = true;
                comparison.quantities.push_back(std::move(*q));
            }
        }
}

}  // namespace tw
