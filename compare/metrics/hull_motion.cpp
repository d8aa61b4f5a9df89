#include "compare/metrics/hull_motion.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <functional>

#include "compare/metrics/forces.h"
#include "compare/metrics/quantity.h"
#include "record/record_numbers.h"
#include "compare/verdict/judge.h"
#include "methods/methods.h"
#include "record/hull_motion.h"

namespace tw {
namespace {

constexpr double least_pitch = 0.25;  ///< [deg]
constexpr double least_heave = 0.01;  ///< of the beam
/// Standard errors that are fine whatever the mean: what a towing tank reads off [deg]; of the spacing at the hull.
constexpr double fine_trim = 0.05, fine_height = 0.05;

std::optional<Oscillation> oscillation_of(const RunRecord& record, const char* column, double least) {
    const Column* c = record.series(hull_motion_table, column);
    if (!c) return {};
    const auto found =
        sustained_oscillation(record.tables.at(hull_motion_table).time, c->values, number_of(record, "mean_from", 0));
    return found && found->amplitude >= least ? found : std::nullopt;
}

/// Settled mean of a column less the value at rest.
MeanValue from_rest(const RunRecord& record, const char* column, const char* at_rest, const CompareOptions& options) {
    MeanValue m = mean_of(record, hull_motion_table, column, options, fine_height * number_of(record, "near_hull", 0));
    if (!m.known) return m;
    const double rest = number_of(record, at_rest, std::nan(""));
    if (!std::isfinite(rest)) {
        m = {};
        m.why_not = "the hull does not float at rest";
        return m;
    }
    m.value -= rest;
    return m;
}

void add_means(Comparison& comparison, const CompareOptions& options) {
    const auto add = [&](const char* name, const char* label, const char* unit, const char* definition, double scale,
                         const std::function<MeanValue(const RunRecord&)>& value) {
        Quantity q = new_quantity(name, label, unit, definition);
        q.scale = scale;
        for (const RunRecord& r : comparison.sources) q.values.push_back(value(r));
        judge(q, comparison.names, comparison.agree_within);
        comparison.quantities.push_back(std::move(q));
    };
    // a rise may be nothing at all: its target refers to the draft
    const double draft = std::abs(number_of(comparison.sources.front(), "rest_transom_draft", 0));
    add("running_trim", "Running trim", "deg", "trim of the free hull, bow up", 0,
        [&](const RunRecord& r) { return mean_of(r, hull_motion_table, "trim", options, fine_trim); });
    add("rise", "Rise of the centre of gravity", "m",
        "from where the hull floats at rest; negative: it sinks in (sinkage)", draft,
        [&](const RunRecord& r) { return from_rest(r, "z", "rest_z", options); });
    add("transom_sinkage", "Sinkage of the transom's keel", "m", "downward from where it lies at rest", draft,
        [&](const RunRecord& r) { return from_rest(r, "transom_draft", "rest_transom_draft", options); });
}

void add_porpoising(Comparison& comparison) {
    std::vector<std::optional<Porpoising>> found;
    for (const RunRecord& r : comparison.sources) found.push_back(porpoising(r));
    if (std::ranges::none_of(found, [](const auto& p) { return p.has_value(); })) return;
    for (std::size_t i = 0; i < found.size(); ++i)
        if (found[i])
            comparison.banners.push_back(fmt::format(
                "{}: the hull porpoises, {:.3g} deg in pitch and {:.3g} m in heave to each side every {:.3g} s, and "
                "this does not die out; its running trim, rise and forces are means of that oscillation.",
                method_label(comparison.names[i]), found[i]->pitch.amplitude, found[i]->heave.amplitude,
                found[i]->period()));
    const auto add = [&](const char* name, const char* label, const char* unit, const char* definition,
                         const std::function<double(const Porpoising&)>& value) {
        Quantity q = new_quantity(name, label, unit, definition);
        for (const auto& p : found) {
            MeanValue m;
            m.known = p.has_value();
            if (p)
                m.value = value(*p);
            else
                m.why_not = "it does not porpoise";
            q.values.push_back(m);
        }
        beside(q);
        comparison.quantities.push_back(std::move(q));
    };
    add("porpoising_pitch", "Porpoising, amplitude in pitch", "deg",
        "half the distance from lowest to highest, mean of the cycles",
        [](const Porpoising& p) { return p.pitch.amplitude; });
    add("porpoising_heave", "Porpoising, amplitude in heave", "m",
        "half the distance from lowest to highest, mean of the cycles",
        [](const Porpoising& p) { return p.heave.amplitude; });
    add("porpoising_period", "Porpoising, period", "s", "mean of the cycles",
        [](const Porpoising& p) { return p.period(); });
}

}  // namespace

std::optional<Porpoising> porpoising(const RunRecord& record) {
    if (record.numbers.contains("wave_period")) return {};  // a wave drives it
    const auto pitch = oscillation_of(record, "trim", least_pitch);
    const auto heave = oscillation_of(record, "z", least_heave * number_of(record, "beam", HUGE_VAL));
    if (!pitch && !heave) return {};
    return Porpoising{pitch.value_or(Oscillation{}), heave.value_or(Oscillation{})};
}

void add_hull_motion(Comparison& comparison, const CompareOptions& options) {
    if (std::ranges::none_of(comparison.sources,
                             [](const RunRecord& r) { return r.tables.contains(hull_motion_table); }))
        return;
    add_means(comparison, options);
    add_porpoising(comparison);
}

}  // namespace tw
