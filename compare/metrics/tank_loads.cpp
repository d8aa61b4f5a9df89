#include "compare/metrics/tank_loads.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>
#include <tuple>
#include <vector>

#include "base/numbers.h"
#include "statistics/time_bins.h"
#include "compare/metrics/probes.h"
#include "compare/metrics/quantity.h"
#include "compare/metrics/sound.h"
#include "record/record_numbers.h"
#include "compare/verdict/judge.h"
#include "record/force_names.h"

namespace tw {

const Table* loads_of(const RunRecord& record) {
    for (const char* name : {"forces_total", "forces"})
        if (const auto found = record.tables.find(name);
            found != record.tables.end() && found->second.find("fx") && found->second.find("fz"))
            return &found->second;
    return nullptr;
}

namespace {

struct Load {
    std::vector<double> t, f;  ///< [s], [N]
};

/// The rows from `begin` to `end`, with the force of the air where the table has it beside the water's.
Load load_in(const Table& table, const std::string& column, double begin, double end) {
    Load load;
    const Column *water = table.find(column), *air = table.find(column + "_air");
    for (std::size_t i = 0; i < table.time.size(); ++i) {
        if (table.time[i] < begin || table.time[i] > end) continue;
        load.t.push_back(table.time[i]);
        load.f.push_back(water->values[i] + (air ? air->values[i] : 0));
    }
    return load;
}

double impulse_of(const Load& load) { return time_integral(load.t, load.f); }

double peak_of(const Load& load) {
    std::vector<double> turned = load.f;
    for (double& f : turned) f = -f;
    const double most = largest_window_mean(load.t, load.f, default_filter),
                 least = -largest_window_mean(load.t, turned, default_filter);
    return std::abs(least) > std::abs(most) ? least : most;
}

/// What of a load, or of its opposite, lasts at least so long [s].
Load lasting_load(Load load, double shortest, bool opposite) {
    const double sign = opposite ? -1 : 1;
    for (double& f : load.f) f *= sign;
    load.f = lasting(load.t, load.f, shortest);
    for (double& f : load.f) f *= sign;
    return load;
}

}  // namespace

void add_tank_loads(Comparison& comparison) {
    const std::vector<RunRecord>& sources = comparison.sources;
    if (std::ranges::any_of(sources, [](const RunRecord& r) { return is_stream(r) || has_moving_bodies(r); })) return;
    std::vector<const Table*> tables;
    double begin = 0, end = HUGE_VAL;
    for (const RunRecord& r : sources) {
        tables.push_back(loads_of(r));
        const Table* t = tables.back();
        if (!t || t->time.empty()) continue;
        begin = std::max(begin, t->time.front());
        end = std::min({end, t->time.back(), number_of(r, "duration", HUGE_VAL)});
    }
    if (!std::isfinite(end)) return;
    const auto largest_impulse = [&](const char* column) {
        double most = 0;
        for (const Table* t : tables)
            if (t) most = std::max(most, std::abs(impulse_of(load_in(*t, column, begin, end))));
        return most;
    };
    const double along = largest_impulse("fx"), up = largest_impulse("fz");
    const ForceNames called = force_names(false);
    for (const auto& [column, axis, impulse, other, words] :
         {std::tuple{"fx", 'x', along, up, called.along}, {"fz", 'z', up, along, called.up}}) {
        if (impulse <= 0.02 * other) continue;
        const auto add = [&](const char* kind, std::string label, const char* unit, std::string definition,
                             const std::function<double(const Load&)>& value_of) {
            Quantity q =
                new_quantity(fmt::format("load_{}_{}", kind, axis), std::move(label), unit, std::move(definition));
            for (const Table* t : tables) {
                MeanValue m;
                m.value = t ? value_of(load_in(*t, column, begin, end)) : nan;
                m.known = std::isfinite(m.value);
                if (m.known)
                    m.half_width = 0, m.from = begin, m.to = end;
                else
                    m.why_not = t ? "its record has gaps" : "its record does not hold it";
                q.values.push_back(m);
            }
            for (std::size_t i = 0; kind == std::string("peak") && i < sources.size(); ++i)
                if (const double shortest = sound_time(sources[i]); shortest > 0 && q.values[i].known)
                    set_sound_aside(q, i,
                                    value_of(lasting_load(load_in(*tables[i], column, begin, end), shortest,
                                                          q.values[i].value < 0)),
                                    shortest, comparison.names[i]);
            beside(q);
            q.judged_in_grid_study = true;
            comparison.quantities.push_back(std::move(q));
        };
        const bool flat =
            std::ranges::any_of(sources, [](const RunRecord& r) { return number_of(r, "dimensions", 3) == 2; });
        const std::string by = fmt::format(" by {:.4g} s", end), force = lower_case_first(words);
        add("impulse", "Impulse of the " + force + by, flat ? "N s/m" : "N s",
            "integral of the " + force + " on what stands in the tank, friction included where it is solved",
            impulse_of);
        add("peak", fmt::format("Largest {}, mean over {:g} ms", force, 1e3 * default_filter), flat ? "N/m" : "N",
            "its largest mean over that time, of either sign: shorter peaks are sound and sampling", peak_of);
    }
}

}  // namespace tw
