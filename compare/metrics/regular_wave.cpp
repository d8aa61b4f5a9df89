#include "compare/metrics/regular_wave.h"

#include <fmt/format.h>
#include <Eigen/Dense>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <optional>
#include <set>

#include "compare/metrics/quantity.h"
#include "compare/metrics/wave_analysis.h"
#include "compare/verdict/judge.h"
#include "record/record_numbers.h"
#include "statistics/student_t.h"

namespace tw {
namespace {

using std::numbers::pi;

constexpr int harmonics = 3, unknowns = 1 + 2 * harmonics;
static_assert(fewest_in_a_period == 2 * unknowns);

/// Mean, then cosine and sine of each harmonic, by least squares. Over times that are no whole number of samples a
/// period the higher harmonics would else leak into the first.
Eigen::VectorXd fit_harmonics(std::span<const double> t, std::span<const double> values, double omega) {
    Eigen::MatrixXd A(t.size(), unknowns);
    Eigen::VectorXd b(t.size());
    for (std::size_t i = 0; i < t.size(); ++i) {
        const auto row = static_cast<Eigen::Index>(i);
        b(row) = values[i];
        A(row, 0) = 1;
        for (int j = 1; j <= harmonics; ++j) {
            A(row, 2 * j - 1) = std::cos(j * omega * t[i]);
            A(row, 2 * j) = std::sin(j * omega * t[i]);
        }
    }
    return A.colPivHouseholderQr().solve(b);
}

/// What one period of a gauge shows, drawn finely.
struct OnePeriod {
    double crest = -HUGE_VAL, trough = HUGE_VAL;
};
std::optional<OnePeriod> period_of(std::span<const double> t, std::span<const double> values, double omega) {
    constexpr int drawn = 360;
    if (static_cast<int>(t.size()) < 2 * unknowns) return {};
    const Eigen::VectorXd fit = fit_harmonics(t, values, omega);
    OnePeriod p;
    for (int i = 0; i < drawn; ++i) {
        const double angle = 2 * pi * i / drawn;
        double level = fit(0);
        for (int j = 1; j <= harmonics; ++j)
            level += fit(2 * j - 1) * std::cos(j * angle) + fit(2 * j) * std::sin(j * angle);
        p.crest = std::max(p.crest, level), p.trough = std::min(p.trough, level);
    }
    return p;
}

/// Height, crest and trough of one gauge in one record.
std::array<MeanValue, 3> values_at(const RunRecord& r, const std::string& gauge, const WavePeriods& periods) {
    if (!r.series("height", gauge))
        return {unknown_value(not_given), unknown_value(not_given), unknown_value(not_given)};
    std::vector<double> height, crest, trough;
    for (int k = 0; k < periods.count; ++k) {
        const double from = periods.from + k * periods.period;
        const WaveSamples s = samples_of(r, gauge, from, from + periods.period);
        const auto one = period_of(s.t, s.x, 2 * pi / periods.period);
        if (!one) continue;
        height.push_back(one->crest - one->trough), crest.push_back(one->crest), trough.push_back(one->trough);
    }
    return {mean_over(height, periods), mean_over(crest, periods), mean_over(trough, periods)};
}

struct Reflection {
    MeanValue reflected, loss;  ///< [%]
};
Reflection reflection_in(const RunRecord& r, const std::set<std::string>& gauges, const WavePeriods& periods) {
    const double end = periods.from + periods.count * periods.period, omega = 2 * pi / periods.period,
                 k = 2 * pi / number_of(r, "wave_length", 1);
    const GaugeHarmonics all = harmonics_at(r, gauges, periods.from, end, omega, 20);
    if (all.x.size() < 2) {
        const MeanValue none = unknown_value("fewer than two gauges recorded it");
        return {none, none};
    }
    const WaveParts parts = split_waves(all.x, all.amplitude, k);
    if (!parts.apart) {
        const MeanValue none = unknown_value("the gauges stand half a wave length apart, or nearly");
        return {none, none};
    }
    const DecayingParts whole = split_decaying_waves(all.x, all.amplitude, k);
    // two gauges always fit: their error is not known
    const double misfit = all.x.size() > 2 ? 200 * parts.misfit : NAN;
    Reflection out{
        known_value(100 * std::abs(parts.reflected) / std::abs(parts.incident), misfit, periods.from, end),
        unknown_value(all.x.size() < 3 ? "fewer than three gauges recorded it"
                                       : "the wave's length differs from the theory's by more than a tenth")};
    if (!whole.apart) return out;
    std::vector<std::complex<double>> ratios;
    std::vector<double> losses;
    const double length = 2 * pi / k;
    for (int n = 0; n < periods.count; ++n) {
        const double from = periods.from + n * periods.period;
        const GaugeHarmonics one = harmonics_at(r, gauges, from, from + periods.period, omega, 2 * unknowns);
        const DecayingParts here = split_decaying_waves(one.x, one.amplitude, k);
        if (one.x.size() != all.x.size() || !here.apart) continue;
        ratios.push_back(here.reflected / here.incident);
        losses.push_back(100 * (1 - std::exp(-here.kappa.imag() * length)));
    }
    if (ratios.size() < 3) return out;
    const IndependentComplexMean mean = mean_of_independent(ratios);
    out.reflected = known_value(100 * std::abs(mean.value), 100 * mean.half_width, periods.from, end);
    out.loss = mean_over(losses, periods);
    return out;
}

}  // namespace

double along_wave(const RunRecord& r, double x, double y) {
    return number_of(r, "wave_direction", 1) * x + number_of(r, "wave_across", 0) * y;
}

GaugeHarmonics harmonics_at(const RunRecord& r, const std::set<std::string>& gauges, double from, double to,
                            double omega, std::size_t fewest) {
    GaugeHarmonics h;
    for (const std::string& gauge : gauges) {
        const WaveSamples s = samples_of(r, gauge, from, to);
        const double at = number_of(r, "height_x_" + gauge, NAN);
        if (s.t.size() < fewest || !std::isfinite(at)) continue;
        h.x.push_back(along_wave(r, at, number_of(r, "height_y_" + gauge, 0)));
        h.amplitude.push_back(first_harmonic(s.t, s.x, omega));
    }
    return h;
}

std::complex<double> first_harmonic(std::span<const double> t, std::span<const double> values, double omega) {
    const Eigen::VectorXd fit = fit_harmonics(t, values, omega);
    return {fit(1), fit(2)};  // Re(A exp(-i omega t)) = a cos + b sin with A = a + i b
}

double mean_level(std::span<const double> t, std::span<const double> values, double omega) {
    return fit_harmonics(t, values, omega)(0);
}

MeanValue mean_lead(const PeriodHarmonics& harmonics, double k_x, const WavePeriods& periods) {
    std::complex<double> all = 0;
    for (const auto& one : harmonics) all += one.value_or(0);
    if (std::abs(all) == 0) return unknown_value("it does not oscillate");
    all *= std::polar(1.0, -k_x);
    std::vector<double> leads;
    for (const auto& one : harmonics)
        if (one) leads.push_back(-180 / pi * (std::arg(all) + std::arg(*one * std::polar(1.0, -k_x) / all)));
    return mean_over(leads, periods);
}

MeanValue mean_in_periods(const RunRecord& r, const std::string& table, const std::string& column,
                          const WavePeriods& periods) {
    const Column* c = r.series(table, column);
    if (!c) return unknown_value(not_given);
    std::vector<double> means;
    for (int n = 0; n < periods.count; ++n) {
        const double from = periods.from + n * periods.period;
        const WaveSamples s = samples_between(r.tables.at(table).time, from, from + periods.period,
                                              [&](std::size_t i) { return c->values[i]; });
        if (static_cast<int>(s.t.size()) >= fewest_in_a_period)
            means.push_back(mean_level(s.t, s.x, 2 * pi / periods.period));
    }
    return mean_over(means, periods);
}

void add_regular_wave(Comparison& comparison) {
    const WavePeriods periods = wave_periods(comparison);
    if (periods.period <= 0) return;
    const std::set<std::string> gauges = gauges_of(comparison);
    double crest = NAN, trough = NAN;  // an imported measurement has none
    for (const RunRecord& r : comparison.sources)
        if (!std::isfinite(crest)) crest = number_of(r, "wave_crest", NAN), trough = number_of(r, "wave_trough", NAN);
    struct Part {
        const char *name, *label;
        double theory;
    };
    const Part parts[] = {{"wave_height", "Wave height at", crest - trough},
                          {"wave_crest", "Wave crest at", crest},
                          {"wave_trough", "Wave trough at", trough}};
    const std::string definition =
        fmt::format("mean over {} whole periods, a mean and three harmonics fitted to each", periods.count);
    for (const std::string& gauge : gauges) {
        std::vector<std::array<MeanValue, 3>> found;
        for (const RunRecord& r : comparison.sources) found.push_back(values_at(r, gauge, periods));
        for (std::size_t part = 0; part < 3; ++part) {
            Quantity q = new_quantity(fmt::format("{}:{}", parts[part].name, gauge),
                                      fmt::format("{} {}", parts[part].label, gauge), "m", definition);
            for (const auto& values : found) q.values.push_back(values[part]);
            beside(q);
            q.judged_in_grid_study = true;
            q.scale = part == 0 || !std::isfinite(crest - trough) ? 0 : (crest - trough) / 2;
            if (std::isfinite(parts[part].theory)) {
                Reference reference;
                reference.quantity = q.name;
                reference.unit = "m";
                reference.source = "the wave as asked for";
                reference.value = parts[part].theory;
                reference.remark = "steady wave of the scene's theory";
                comparison.references.push_back(reference);
            }
            comparison.quantities.push_back(std::move(q));
        }
    }
    add_wave_responses(comparison, periods);
    add_hull_in_waves(comparison, periods);
    add_wave_forces(comparison, periods);
    const GaugeSides sides = gauge_sides(comparison);
    add_wave_transmission(comparison, sides, periods);
    if (sides.before.size() < 2) return;
    Quantity reflected =
                 new_quantity("wave_reflection", "Reflection of the wave", "%",
                              "reflected over incident amplitude of the first harmonic, by least squares over the "
                              "gauges; of three and more with the loss between them"),
             loss = new_quantity("wave_loss", "Loss of height in a wave length", "%",
                                 "of the incident first harmonic, by its decay over three gauges or more");
    for (const RunRecord& r : comparison.sources) {
        const Reflection found = reflection_in(r, sides.before, periods);
        reflected.values.push_back(found.reflected);
        loss.values.push_back(found.loss);
    }
    const bool decays = sides.before.size() > 2;
    // A wave that runs back against a stream has another length, and above U omega_e/g = 1/4 there is none.
    const bool in_stream = number_of(comparison.sources.front(), "speed", 0) > 0;
    for (Quantity* q : {&reflected, &loss}) {
        if (q == &loss ? !decays : in_stream) continue;
        beside(*q);
        q->judged_in_grid_study = true;
        comparison.quantities.push_back(std::move(*q));
    }
}

}  // namespace tw
