#include "compare/metrics/volumes.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <set>

#include "compare/metrics/quantity.h"
#include "compare/metrics/wave_samples.h"
#include "compare/reference/overtopping.h"
#include "compare/verdict/judge.h"
#include "record/record_numbers.h"
#include "record/water_in_box.h"
#include "statistics/error_of_mean.h"
#include "statistics/time_bins.h"

namespace tw {
namespace {

bool is_volume(const std::string& table) { return table == volume_table; }

/// The number `name` of the first record that has it; NaN: none.
double first_known(const Comparison& comparison, const std::string& name) {
    for (const RunRecord& r : comparison.sources)
        if (const double known = number_of(r, name, NAN); std::isfinite(known)) return known;
    return NAN;
}
/// What the scene knows of the wall before a box (scene/solids/sea_wall.h); NaN: there is none.
double of_wall(const Comparison& comparison, const char* what, const std::string& box) {
    return first_known(comparison, fmt::format("wall_{}_{}", what, box));
}

/// The time that all records with such a table cover [s].
CommonTime covered(const Comparison& comparison) {
    CommonTime time{-HUGE_VAL, HUGE_VAL};
    for (const RunRecord& r : comparison.sources)
        if (const auto t = r.tables.find(volume_table); t != r.tables.end() && !t->second.time.empty()) {
            time.from = std::max(time.from, t->second.time.front());
            time.to = std::min(time.to, t->second.time.back());
        }
    return time;
}

MeanValue gain_of(const RunRecord& r, const std::string& box, const CommonTime& time) {
    const Column* c = r.series(volume_table, box);
    if (!c) return unknown_value(not_given);
    const std::vector<double>& t = r.tables.at(volume_table).time;
    const double gain = value_at(t, c->values, time.to) - value_at(t, c->values, time.from);
    if (!std::isfinite(gain)) return unknown_value("no value in the time that all records cover");
    return known_value(gain, 0, time.from, time.to);
}

/// Period of the records' waves [s] and whether each of them is like the one before; 0: there are none.
struct WaveTime {
    double period = 0;
    bool regular = false;
};
WaveTime wave_time(const Comparison& comparison) {
    WaveTime w;
    for (const RunRecord& r : comparison.sources)
        w = {std::max(w.period, period_of_waves(r)), w.regular || number_of(r, "wave_period", 0) > 0};
    return w;
}

/// A regular wave counts as the sea of the same energy and period.
void add_eurotop(Comparison& comparison, const std::string& box, const WaveTime& wave) {
    const double height = wave.regular ? std::numbers::sqrt2 * first_known(comparison, "wave_height")
                                       : first_known(comparison, "sea_significant_height");
    const double peak_over_mean = wave.regular ? 1 : 1.1;  // Tp / Tm-1,0 of a sea with one peak
    const WavesAtWall waves{height,
                            wave.period / peak_over_mean,
                            of_wall(comparison, "depth", box),
                            of_wall(comparison, "freeboard", box),
                            of_wall(comparison, "cot_slope", box),
                            first_known(comparison, "gravity")};
    const auto formula = eurotop_overtopping(waves);
    if (!formula) return;
    Reference r;
    r.quantity = "overtopping:" + box, r.unit = "m3/m/s", r.source = "EurOtop 2018";
    r.value = formula->rate, r.half_width = formula->half_width;
    r.in_range = formula->in_range && !wave.regular;
    r.remark = fmt::format(
        "Rc/Hm0 = {:.3g}, {}; {}", waves.freeboard / waves.height,
        waves.cot_slope > 0 ? fmt::format("slope 1 in {:.3g}", waves.cot_slope) : "vertical",
        wave.regular ? "a formula of irregular waves, Hm0 taken as sqrt(2) H, of the same energy: a hint at most"
        : r.in_range ? "± is 1.96 standard deviations of its coefficients"
                     : "outside the formula's range: a hint at most");
    comparison.references.push_back(r);
}

MeanValue rate_of(const RunRecord& r, const std::string& box, const WavePeriods& periods, bool regular, double width) {
    const Column* c = r.series(volume_table, box);
    if (!c) return unknown_value(not_given);
    const std::vector<double>& t = r.tables.at(volume_table).time;
    std::vector<double> rates;
    for (int n = 0; n < periods.count; ++n) {
        const double from = periods.from + n * periods.period, to = from + periods.period,
                     gain = value_at(t, c->values, std::min(to, t.back())) -
                            value_at(t, c->values, std::max(from, t.front()));  // they differ by rounding at most
        if (std::isfinite(gain)) rates.push_back(gain / periods.period / width);
    }
    MeanValue mean = mean_over(rates, periods);
    if (mean.known && !regular) mean.half_width = half_width_of_mean(rates);
    return mean;
}

}  // namespace

void add_volumes(Comparison& comparison) {
    std::set<std::pair<std::string, std::string>> boxes;  // name, unit
    for (const RunRecord& r : comparison.sources)
        if (const auto t = r.tables.find(volume_table); t != r.tables.end())
            for (const Column& c : t->second.columns) boxes.emplace(c.name, c.unit);
    const CommonTime whole = covered(comparison);
    const WaveTime wave = wave_time(comparison);
    const CommonTime settled = common_time(comparison, is_volume);
    const WavePeriods periods = wave.period > 0 ? last_periods(settled.from, settled.to, wave.period) : WavePeriods{};
    const auto add = [&](Quantity q) {
        beside(q);
        q.judged_in_grid_study = true;
        comparison.quantities.push_back(std::move(q));
    };
    for (const auto& [name, unit] : boxes) {
        Quantity gain =
            new_quantity("volume_gain:" + name, fmt::format("Water that came into {}", name), unit,
                         fmt::format("volume at {:.4g} s less that at {:.4g} s: what left again is taken off", whole.to,
                                     whole.from));
        for (const RunRecord& r : comparison.sources) gain.values.push_back(gain_of(r, name, whole));
        add(std::move(gain));
        if (!(wave.period > 0)) continue;
        const double width = of_wall(comparison, "width", name);
        const bool over_wall = std::isfinite(width);
        Quantity rate =
            new_quantity(over_wall ? "overtopping:" + name : "volume_rate:" + name,
                         over_wall ? fmt::format("Overtopping into {}, per metre of crest", name)
                                   : fmt::format("Water into {} per time", name),
                         over_wall ? "m3/m/s" : unit + "/s",
                         fmt::format("mean over {} whole {}periods of {:.4g} s of what the volume gains in each",
                                     periods.count, wave.regular ? "" : "peak ", wave.period));
        for (const RunRecord& r : comparison.sources)
            rate.values.push_back(rate_of(r, name, periods, wave.regular, over_wall ? width : 1));
        add(std::move(rate));
        if (over_wall) add_eurotop(comparison, name, wave);
    }
}

}  // namespace tw
