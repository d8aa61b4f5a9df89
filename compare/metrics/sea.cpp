#include "compare/metrics/sea.h"

#include <fmt/format.h>
#include <Eigen/Dense>

#include <algorithm>
#include <cmath>
#include <complex>
#include <locale>
#include <numbers>
#include <numeric>
#include <optional>
#include <sstream>

#include "compare/metrics/gauge_sides.h"
#include "compare/metrics/quantity.h"
#include "compare/metrics/wave_analysis.h"
#include "compare/metrics/wave_samples.h"
#include "compare/verdict/judge.h"
#include "record/record_numbers.h"
#include "statistics/student_t.h"

namespace tw {
namespace {

using std::numbers::pi;

constexpr int fewest_waves = 9;       ///< for the mean of the highest third
constexpr double fewest_samples = 8;  ///< in a peak period

struct Component {
    double f, k, amplitude, phase;  ///< [1/s], [1/m], [m], [rad]
};

/// What the records say of the sea, and the time over which it is judged.
struct SeaAsked {
    std::string kind;
    std::vector<Component> waves;
    double peak_period = 0, repeat = 0;  ///< [s]
    double from = 0, time = 0;           ///< [s]
    bool whole = false;                  ///< repeat periods
    bool focused() const { return kind == "focused"; }
    bool two() const { return kind == "bichromatic"; }
    double to() const { return from + time; }
};

SeaAsked sea_of(const Comparison& c) {
    SeaAsked sea;
    for (const RunRecord& r : c.sources) {
        if (!sea.kind.empty() || text_of(r, "sea").empty()) continue;
        sea.kind = text_of(r, "sea");
        sea.peak_period = number_of(r, "sea_peak_period", 0);
        sea.repeat = number_of(r, "sea_repeat_period", 0);
        std::istringstream text(text_of(r, "sea_components"));
        text.imbue(std::locale::classic());
        for (Component w; text >> w.f >> w.k >> w.amplitude >> w.phase;) sea.waves.push_back(w);
    }
    if (sea.waves.empty() || !(sea.peak_period > 0)) return {};
    const auto [from, to] = common_time(c, [](const std::string& table) { return table == "height"; });
    if (!std::isfinite(to)) return {};
    const double repeats = sea.repeat > 0 ? std::floor((to - from) / sea.repeat + 1e-3) : 0;
    sea.whole = repeats >= 1;
    sea.time = sea.whole ? repeats * sea.repeat : to - from;
    sea.from = to - sea.time;
    return sea;
}

/// Levels of a gauge at equal steps over the time that is judged; none, with the reason, where there are too few.
struct Levels {
    std::vector<double> values;
    double step = 0;  ///< [s]
    std::string why_not;
};
Levels levels_of(const RunRecord& r, const std::string& gauge, const SeaAsked& sea) {
    if (!r.series("height", gauge)) return {{}, 0, not_given};
    const WaveSamples s = samples_of(r, gauge, sea.from - sea.peak_period, sea.to());
    const double most = sea.peak_period / fewest_samples;
    double gap = 0;
    for (std::size_t i = 1; i < s.t.size(); ++i)
        if (s.t[i] > sea.from) gap = std::max(gap, s.t[i] - s.t[i - 1]);
    if (s.t.size() < 4 || gap > most)
        return {{},
                0,
                fmt::format("fewer than {:g} samples a peak period were recorded; shorten [sampling] interval",
                            fewest_samples)};
    const int count = static_cast<int>(std::ceil(sea.time / sea.peak_period * 32));
    const double step = sea.time / count;
    return {at_equal_steps(s.t, s.x, sea.from, step, count), step, {}};
}

/// Of a record's line, A exp(-2 pi i f t) with t from the record's own zero.
std::complex<double> line_of(const Levels& levels, double from, double f) {
    std::complex<double> A = 0;
    for (std::size_t i = 0; i < levels.values.size(); ++i)
        A += levels.values[i] * std::polar(1.0, 2 * pi * f * (from + static_cast<double>(i) * levels.step));
    return 2.0 / static_cast<double>(levels.values.size()) * A;
}

void add_judged(Comparison& comparison, Quantity q, double theory, double half_width = 0) {
    beside(q);
    q.judged_in_grid_study = true;
    if (std::isfinite(theory)) {
        Reference reference;
        reference.quantity = q.name;
        reference.unit = q.unit;
        reference.source = "the sea as asked for";
        reference.value = theory;
        reference.half_width = half_width;
        reference.remark = half_width > 0 ? "linear theory; its interval is that of a record of this length"
                                          : "linear theory, of this very sea";
        comparison.references.push_back(reference);
    }
    comparison.quantities.push_back(std::move(q));
}

struct OfGauge {
    MeanValue height, crossing, period;
    WaveSpectrum spectrum;
};
OfGauge spectrum_at(const RunRecord& r, const std::string& gauge, const SeaAsked& sea) {
    OfGauge out;
    const Levels levels = levels_of(r, gauge, sea);
    if (levels.values.empty()) {
        out.height = out.crossing = out.period = unknown_value(levels.why_not);
        return out;
    }
    const double fp = 1 / sea.peak_period;
    out.spectrum = spectrum_of(levels.values, sea.time, 0.3 * fp, 3 * fp);
    // lines of a sample scatter by as much as they are high
    const std::vector<double> even = smoothed(out.spectrum, 0.1 * fp);
    if (!sea.whole) set_certainty(out.spectrum, even);
    const double height = 4 * std::sqrt(out.spectrum.variance);
    // over whole repeat periods the sea is known exactly; else this is a sample of it
    const double sampling = sea.whole ? NAN : height * (out.spectrum.high - out.spectrum.low) / 2;
    out.height = known_value(height, sampling, sea.from, sea.to());
    std::vector<double> heights = crossing_heights(levels.values);
    if (static_cast<int>(heights.size()) < fewest_waves) {
        out.crossing = unknown_value(fmt::format("fewer than {} waves were recorded", fewest_waves));
    } else {
        std::ranges::sort(heights, std::greater());
        const std::size_t third = heights.size() / 3;
        out.crossing =
            known_value(std::accumulate(heights.begin(), heights.begin() + static_cast<std::ptrdiff_t>(third), 0.0) /
                            static_cast<double>(third),
                        sampling, sea.from, sea.to());
    }
    std::vector<double> f, energy;
    if (sea.whole) {
        for (const Component& w : sea.waves)
            f.push_back(w.f), energy.push_back(std::norm(line_of(levels, sea.from, w.f)) / 2);
    } else {
        f = out.spectrum.f, energy = even;
    }
    out.period = known_value(peak_period_of(f, energy), NAN, sea.from, sea.to());
    return out;
}

void add_spectrum(Comparison& comparison, const SeaAsked& sea, const std::string& gauge) {
    std::vector<OfGauge> found;
    for (const RunRecord& r : comparison.sources) found.push_back(spectrum_at(r, gauge, sea));
    std::vector<double> f, energy;
    double variance = 0;
    for (const Component& w : sea.waves)
        f.push_back(w.f), energy.push_back(w.amplitude * w.amplitude / 2), variance += energy.back();
    std::string window = fmt::format("over {:.4g} s", sea.time), certainty;
    if (sea.whole) window += fmt::format(", {:.0f} repeat period(s) of the sea", sea.time / sea.repeat);
    double asked_interval = 0;
    for (const OfGauge& g : found)
        if (g.height.known && certainty.empty()) {
            certainty = fmt::format(
                "; as a sample of the sea state it has {:.3g} degrees of freedom: 95 % from {:.3g} to {:.3g} of it "
                "(chi-square)",
                g.spectrum.degrees, g.spectrum.low, g.spectrum.high);
            if (!sea.whole) asked_interval = 4 * std::sqrt(variance) * (g.spectrum.high - g.spectrum.low) / 2;
        }
    Quantity height = new_quantity("significant_height:" + gauge, "Significant height at " + gauge, "m",
                                   "4 standard deviations of the level " + window + certainty),
             crossing = new_quantity("crossing_height:" + gauge, "Highest third of the waves at " + gauge, "m",
                                     "mean of the highest third of the heights between zero up-crossings " + window),
             period = new_quantity("peak_period:" + gauge, "Peak period at " + gauge, "s",
                                   "sum E^4 / sum f E^4 over the lines of the spectrum, " + window);
    for (const OfGauge& g : found) {
        height.values.push_back(g.height);
        crossing.values.push_back(g.crossing);
        period.values.push_back(g.period);
    }
    add_judged(comparison, std::move(height), 4 * std::sqrt(variance), asked_interval);
    add_judged(comparison, std::move(crossing), NAN);
    add_judged(comparison, std::move(period), sea.whole ? peak_period_of(f, energy) : sea.peak_period);
}

/// Heights of two waves, fitted with their bound waves and a mean to each beat.
void add_two(Comparison& comparison, const SeaAsked& sea, const std::string& gauge) {
    const double f1 = sea.waves[0].f, f2 = sea.waves[1].f, beat = sea.repeat;
    const double lines[] = {f1, f2, 2 * f1, 2 * f2, f1 + f2, f2 - f1};
    Quantity q[2] = {new_quantity("first_wave:" + gauge, "First wave at " + gauge, "m", ""),
                     new_quantity("second_wave:" + gauge, "Second wave at " + gauge, "m", "")};
    for (const RunRecord& r : comparison.sources) {
        std::vector<double> heights[2];
        const int beats = sea.whole ? static_cast<int>(std::round(sea.time / beat)) : 0;
        for (int b = 0; b < beats; ++b) {
            const WaveSamples s = samples_of(r, gauge, sea.from + b * beat, sea.from + (b + 1) * beat);
            if (s.t.size() < 26) continue;
            Eigen::MatrixXd A(s.t.size(), 13);
            for (std::size_t i = 0; i < s.t.size(); ++i) {
                const auto row = static_cast<Eigen::Index>(i);
                A(row, 0) = 1;
                for (int j = 0; j < 6; ++j)
                    A(row, 2 * j + 1) = std::cos(2 * pi * lines[j] * s.t[i]),
                                   A(row, 2 * j + 2) = std::sin(2 * pi * lines[j] * s.t[i]);
            }
            const Eigen::VectorXd fit =
                A.colPivHouseholderQr().solve(Eigen::Map<const Eigen::VectorXd>(s.x.data(), A.rows()));
            for (int j = 0; j < 2; ++j) heights[j].push_back(2 * std::hypot(fit(2 * j + 1), fit(2 * j + 2)));
        }
        for (int j = 0; j < 2; ++j) {
            if (heights[j].empty()) {
                q[j].values.push_back(unknown_value(r.series("height", gauge)
                                                        ? "no whole beat was recorded with two samples a fitted number"
                                                        : not_given));
                continue;
            }
            // how far the beats differ; of one alone nothing is known
            const IndependentMean mean = mean_of_independent(heights[j]);
            q[j].values.push_back(known_value(mean.value, mean.half_width, sea.from, sea.to()));
        }
    }
    for (int j = 0; j < 2; ++j) {
        q[j].definition =
            fmt::format("of {:.4g} s; both waves, their bound ones and a mean fitted to each beat of {:.4g} s",
                        1 / sea.waves[static_cast<std::size_t>(j)].f, beat);
        add_judged(comparison, std::move(q[j]), 2 * sea.waves[static_cast<std::size_t>(j)].amplitude);
    }
}

void add_focused(Comparison& comparison, const SeaAsked& sea, const std::string& gauge) {
    Quantity crest = new_quantity("focused_crest:" + gauge, "Focused crest at " + gauge, "m",
                                  "highest level within two peak periods of the focus time, a parabola through the "
                                  "highest samples"),
             time = new_quantity("focused_crest_time:" + gauge, "Time of the focused crest at " + gauge, "s",
                                 "of the highest level");
    std::optional<double> theory[2][2];
    for (const RunRecord& r : comparison.sources) {
        for (const int order : {0, 1}) {
            const std::string name = order == 0 ? "first_" : "second_";
            const double height = number_of(r, "sea_crest_" + name + gauge, NAN),
                         at = number_of(r, "sea_crest_time_" + name + gauge, NAN);
            if (std::isfinite(height) && !theory[order][0]) theory[order][0] = height, theory[order][1] = at;
        }
        const double focus = number_of(r, "sea_focus_time", NAN);
        const WaveSamples s = samples_of(r, gauge, focus - 2 * sea.peak_period, focus + 2 * sea.peak_period);
        std::size_t best = 0;
        for (std::size_t i = 0; i < s.x.size(); ++i)
            if (s.x[i] > s.x[best]) best = i;
        if (best == 0 || best + 1 >= s.x.size()) {
            const MeanValue none = unknown_value("its time was not recorded whole");
            crest.values.push_back(none), time.values.push_back(none);
            continue;
        }
        const TurningPoint highest = turning_point(s.t, s.x, best, 0);
        crest.values.push_back(known_value(highest.x, NAN, focus, focus));
        time.values.push_back(known_value(highest.t, NAN, focus, focus));
    }
    const std::string crest_name = crest.name, time_name = time.name;
    time.scale = sea.peak_period;
    add_judged(comparison, std::move(crest), theory[0][0].value_or(NAN));
    add_judged(comparison, std::move(time), theory[0][1].value_or(NAN));
    if (!theory[1][0]) return;
    for (const int part : {0, 1}) {
        Reference reference;
        reference.quantity = part == 0 ? crest_name : time_name;
        reference.unit = part == 0 ? "m" : "s";
        reference.source = "second order";
        reference.value = *theory[1][part];
        reference.remark = "with the bound waves of all pairs (Sharma & Dean 1981)";
        comparison.references.push_back(reference);
    }
}

MeanValue reflection_of(const RunRecord& r, const std::set<std::string>& gauges, const SeaAsked& sea) {
    const double direction = number_of(r, "wave_direction", 1);
    std::vector<double> x;
    std::vector<Levels> levels;
    for (const std::string& gauge : gauges) {
        Levels one = levels_of(r, gauge, sea);
        const double at = number_of(r, "height_x_" + gauge, NAN);
        if (one.values.empty() || !std::isfinite(at)) continue;
        x.push_back(direction * at);
        levels.push_back(std::move(one));
    }
    if (x.size() < 2) return unknown_value("fewer than two gauges recorded it");
    if (!sea.whole) return unknown_value("no whole repeat period was recorded");
    double incident = 0, reflected = 0, misfit = 0;
    for (const Component& w : sea.waves) {
        std::vector<std::complex<double>> amplitudes;
        for (const Levels& l : levels) amplitudes.push_back(line_of(l, sea.from, w.f));
        const WaveParts parts = split_waves(x, amplitudes, w.k);
        if (!parts.apart) continue;
        incident += std::norm(parts.incident);
        reflected += std::norm(parts.reflected);
        misfit += std::norm(parts.incident) * parts.misfit * parts.misfit;
    }
    if (!(incident > 0)) return unknown_value("the gauges stand half a wave length apart, or nearly");
    return known_value(100 * std::sqrt(reflected / incident), x.size() > 2 ? 200 * std::sqrt(misfit / incident) : NAN,
                       sea.from, sea.to());
}

}  // namespace

void add_sea(Comparison& comparison) {
    const SeaAsked sea = sea_of(comparison);
    if (sea.kind.empty()) return;
    const std::set<std::string> gauges = gauges_of(comparison);
    for (const std::string& gauge : gauges) {
        if (sea.focused())
            add_focused(comparison, sea, gauge);
        else if (sea.two())
            add_two(comparison, sea, gauge);
        else
            add_spectrum(comparison, sea, gauge);
    }
    const GaugeSides sides = gauge_sides(comparison);
    // what runs back against a stream has other lengths
    const bool in_stream = number_of(comparison.sources.front(), "speed", 0) > 0;
    if (sides.before.size() < 2 || sea.focused() || in_stream) return;
    Quantity q =
        new_quantity("wave_reflection", "Reflection of the waves", "%",
                     "root of reflected over incident energy, by least squares over the gauges at each frequency");
    for (const RunRecord& r : comparison.sources) q.values.push_back(reflection_of(r, sides.before, sea));
    add_judged(comparison, std::move(q), NAN);
}

}  // namespace tw
