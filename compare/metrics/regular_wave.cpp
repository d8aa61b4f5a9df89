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
#include "compare/verdict/judge.h"
#include "record/record_numbers.h"
#include "statistics/student_t.h"

namespace tw {
namespace {

using std::numbers::pi;

constexpr int harmonics = 3, unknowns = 1 + 2 * harmonics;

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

/// The last whole periods within the time that all records cover [s].
struct Periods {
    double from = 0, period = 0;
    int count = 0;
};
Periods periods_of(const Comparison& c) {
    Periods p;
    double from = 0, to = HUGE_VAL;
    for (const RunRecord& r : c.sources) {
        for (const auto& [name, table] : r.tables) {
            if ((name != "height" && !name.starts_with("body_")) || table.time.empty()) continue;
            from = std::max({from, table.time.front(), number_of(r, "mean_from", 0)});
            to = std::min(to, table.time.back());
        }
        p.period = std::max(p.period, number_of(r, "wave_period", 0));
    }
    if (!(p.period > 0) || !std::isfinite(to)) return p;
    p.count = std::max(0, static_cast<int>(std::floor((to - from) / p.period + 1e-6)));
    p.from = to - p.count * p.period;
    return p;
}

struct Samples {
    std::vector<double> t, x;
};
/// The known values after `from`, up to `to` [s]; `of_row`: the value in a row.
template <class OfRow>
Samples samples_between(const std::vector<double>& time, double from, double to, OfRow of_row) {
    Samples s;
    for (std::size_t i = 0; i < time.size(); ++i)
        if (time[i] > from && time[i] <= to * (1 + 1e-12) && std::isfinite(of_row(i)))
            s.t.push_back(time[i]), s.x.push_back(of_row(i));
    return s;
}

Samples samples_of(const RunRecord& r, const std::string& gauge, double from, double to) {
    const Column* c = r.series("height", gauge);
    if (!c) return {};
    return samples_between(r.tables.at("height").time, from, to, [&](std::size_t i) { return c->values[i]; });
}

MeanValue unknown(const std::string& why) {
    MeanValue m;
    m.why_not = why;
    return m;
}

MeanValue mean_of(const std::vector<double>& values, const Periods& periods) {
    if (periods.count < 3) return unknown("fewer than three whole periods were recorded");
    if (values.size() < 3)
        return unknown(
            fmt::format("fewer than {} samples a period were recorded; shorten [sampling] interval", 2 * unknowns));
    MeanValue m;
    const double n = static_cast<double>(values.size());
    double squares = 0;
    m.value = 0;
    for (const double v : values) m.value += v / n;
    for (const double v : values) squares += (v - m.value) * (v - m.value);
    m.known = true;
    m.why_not.clear();
    m.half_width = student_t_95(n - 1) * std::sqrt(squares / (n - 1) / n);
    m.from = periods.from, m.to = periods.from + periods.count * periods.period;
    return m;
}

/// Height, crest and trough of one gauge in one record.
std::array<MeanValue, 3> values_at(const RunRecord& r, const std::string& gauge, const Periods& periods) {
    if (!r.series("height", gauge)) return {unknown(not_given), unknown(not_given), unknown(not_given)};
    std::vector<double> height, crest, trough;
    for (int k = 0; k < periods.count; ++k) {
        const double from = periods.from + k * periods.period;
        const Samples s = samples_of(r, gauge, from, from + periods.period);
        const auto one = period_of(s.t, s.x, 2 * pi / periods.period);
        if (!one) continue;
        height.push_back(one->crest - one->trough), crest.push_back(one->crest), trough.push_back(one->trough);
    }
    return {mean_of(height, periods), mean_of(crest, periods), mean_of(trough, periods)};
}

/// First harmonic of a body's motion over `of_wave`, its amplitude in the wave. `of_row`: the motion in a row of its table.
template <class OfRow>
MeanValue response_in(const Table& table, const Periods& periods, double of_wave, OfRow of_row) {
    std::vector<double> found;
    for (int k = 0; k < periods.count; ++k) {
        const double from = periods.from + k * periods.period;
        const Samples s = samples_between(table.time, from, from + periods.period, of_row);
        if (static_cast<int>(s.t.size()) >= 2 * unknowns)
            found.push_back(std::abs(first_harmonic(s.t, s.x, 2 * pi / periods.period)) / of_wave);
    }
    return mean_of(found, periods);
}

/// How far bodies heave and pitch in the wave.
void add_responses(Comparison& comparison, const Periods& periods) {
    std::set<std::string> bodies;
    double height = NAN, length = NAN;
    for (const RunRecord& r : comparison.sources) {
        if (!std::isfinite(height))
            height = number_of(r, "wave_height", NAN), length = number_of(r, "wave_length", NAN);
        for (const auto& [name, table] : r.tables)
            if (name.starts_with("body_") && table.find("z") && table.find("q0") && table.find("q2"))
                bodies.insert(name.substr(5));
    }
    if (!(height > 0) || !(length > 0)) return;
    for (const std::string& body : bodies)
        for (const bool heave : {true, false}) {
            Quantity q = new_quantity(
                fmt::format("{}_response:{}", heave ? "heave" : "pitch", body),
                fmt::format("{} response of {}", heave ? "Heave" : "Pitch", body), "-",
                fmt::format("amplitude of the first harmonic over {}, mean over {} whole periods",
                            heave ? "half of the wave's height" : "the wave's slope pi H / L", periods.count));
            double largest = 0;
            for (const RunRecord& r : comparison.sources) {
                const auto table = r.tables.find(body_table(body));
                const auto column = [&](const char* name) { return table->second.find(name); };
                if (table == r.tables.end() || !column("z") || !column("q0") || !column("q2"))
                    q.values.push_back(unknown(not_given));
                else if (heave)
                    q.values.push_back(response_in(table->second, periods, height / 2,
                                                   [&](std::size_t i) { return column("z")->values[i]; }));
                else
                    q.values.push_back(response_in(table->second, periods, pi * height / length, [&](std::size_t i) {
                        return 2 * std::atan2(column("q2")->values[i], column("q0")->values[i]);
                    }));
                if (q.values.back().known) largest = std::max(largest, q.values.back().value);
            }
            if (largest < 1e-6) continue;  // it is not free to
            beside(q);
            q.judged_in_ladder = true;
            comparison.quantities.push_back(std::move(q));
        }
}

MeanValue reflection_in(const RunRecord& r, const std::set<std::string>& gauges, const Periods& periods) {
    const double end = periods.from + periods.count * periods.period, direction = number_of(r, "wave_direction", 1);
    std::vector<double> x;
    std::vector<std::complex<double>> amplitudes;
    for (const std::string& gauge : gauges) {
        const Samples s = samples_of(r, gauge, periods.from, end);
        const double at = number_of(r, "height_x_" + gauge, NAN);
        if (s.t.size() < 20 || !std::isfinite(at)) continue;
        x.push_back(direction * at);
        amplitudes.push_back(first_harmonic(s.t, s.x, 2 * pi / periods.period));
    }
    if (x.size() < 2) return unknown("fewer than two gauges recorded it");
    const WaveParts parts = split_waves(x, amplitudes, 2 * pi / number_of(r, "wave_length", 1));
    if (!parts.apart) return unknown("the gauges stand half a wave length apart, or nearly");
    MeanValue m;
    m.known = true;
    m.why_not.clear();
    m.value = 100 * std::abs(parts.reflected) / std::abs(parts.incident);
    if (x.size() > 2) m.half_width = 100 * 2 * parts.misfit;  // two gauges always fit: their error is not known
    m.from = periods.from, m.to = end;
    return m;
}

}  // namespace

std::complex<double> first_harmonic(std::span<const double> t, std::span<const double> values, double omega) {
    const Eigen::VectorXd fit = fit_harmonics(t, values, omega);
    return {fit(1), fit(2)};  // Re(A exp(-i omega t)) = a cos + b sin with A = a + i b
}

WaveParts split_waves(std::span<const double> x, std::span<const std::complex<double>> amplitude, double k) {
    using Complex = std::complex<double>;
    WaveParts parts;
    const double n = static_cast<double>(x.size());
    Complex cross = 0, of_incident = 0, of_reflected = 0;
    for (std::size_t m = 0; m < x.size(); ++m) {
        const Complex wave = std::polar(1.0, k * x[m]);
        cross += std::conj(wave) * std::conj(wave);
        of_incident += std::conj(wave) * amplitude[m];
        of_reflected += wave * amplitude[m];
    }
    const double determinant = n * n - std::norm(cross);
    parts.apart = x.size() >= 2 && determinant > 0.05 * n * n;
    if (!parts.apart) return parts;
    parts.incident = (n * of_incident - cross * of_reflected) / determinant;
    parts.reflected = (n * of_reflected - std::conj(cross) * of_incident) / determinant;
    double squares = 0;
    for (std::size_t m = 0; m < x.size(); ++m)
        squares += std::norm(amplitude[m] - parts.incident * std::polar(1.0, k * x[m]) -
                             parts.reflected * std::polar(1.0, -k * x[m]));
    if (x.size() > 2) parts.misfit = std::sqrt(squares / (n - 2)) / std::abs(parts.incident);
    return parts;
}

void add_regular_wave(Comparison& comparison) {
    const Periods periods = periods_of(comparison);
    if (periods.period <= 0) return;
    std::set<std::string> gauges;
    for (const RunRecord& r : comparison.sources)
        if (const auto found = r.tables.find("height"); found != r.tables.end())
            for (const Column& c : found->second.columns) gauges.insert(c.name);
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
            q.judged_in_ladder = true;
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
    add_responses(comparison, periods);
    if (gauges.size() < 2) return;
    Quantity q =
        new_quantity("wave_reflection", "Reflection of the wave", "%",
                     "reflected over incident amplitude of the first harmonic, by least squares over the gauges");
    for (const RunRecord& r : comparison.sources) q.values.push_back(reflection_in(r, gauges, periods));
    beside(q);
    q.judged_in_ladder = true;
    comparison.quantities.push_back(std::move(q));
}

}  // namespace tw
