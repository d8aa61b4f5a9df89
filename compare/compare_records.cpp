#include "compare/compare.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>

#include "base/errors.h"
#include "compare/checks/checks.h"
#include "compare/metrics/bodies.h"
#include "compare/metrics/box_walls.h"
#include "compare/metrics/elevation.h"
#include "compare/metrics/entry.h"
#include "compare/metrics/forces.h"
#include "compare/metrics/free_decay.h"
#include "compare/metrics/hull_motion.h"
#include "compare/metrics/probes.h"
#include "compare/metrics/regular_wave.h"
#include "compare/metrics/sea.h"
#include "compare/metrics/splash.h"
#include "compare/metrics/tank_loads.h"
#include "compare/metrics/volumes.h"
#include "compare/metrics/walls.h"
#include "compare/metrics/wave_peaks.h"
#include "compare/read/prepare.h"
#include "compare/reference/planing.h"
#include "compare/verdict/judge.h"
#include "methods/methods.h"
#include "record/measured_value.h"
#include "record/record_numbers.h"
#include "text/units.h"

namespace tw {

const Quantity* Comparison::find(const std::string& name) const {
    const auto found = std::ranges::find(quantities, name, &Quantity::name);
    return found == quantities.end() ? nullptr : &*found;
}

namespace {

/// The method's name, numbered where several sources share it.
std::vector<std::string> source_names(const std::vector<RunRecord>& sources) {
    std::vector<std::string> names;
    for (const RunRecord& r : sources) {
        const std::string method = text_of(r, "method", "unnamed");
        std::string name = method;
        for (int k = 2; std::ranges::find(names, name) != names.end(); ++k) name = fmt::format("{} {}", method, k);
        names.push_back(name);
    }
    return names;
}

/// Same scene, same hull: refuses a difference, or with `force` puts it on a banner.
void check_same(Comparison& comparison, const std::string& attribute, const std::string& what, bool force) {
    const auto& s = comparison.sources;
    for (std::size_t i = 1; i < s.size(); ++i) {
        const std::string a = text_of(s[0], attribute), b = text_of(s[i], attribute);
        if (a == b) continue;
        const auto brief = [](const std::string& hash) {
            return hash.empty() ? std::string("none") : hash.substr(0, 12);
        };
        const std::string difference =
            fmt::format("{} ({} {}) and {} ({} {}) were not made from the same {}", method_label(comparison.names[0]),
                        attribute, brief(a), method_label(comparison.names[i]), attribute, brief(b), what);
        if (!force)
            throw InputError(
                difference +
                ": their difference would not be one of method; compare runs of one scene, or force the comparison");
        comparison.banners.push_back("Forced comparison: " + difference +
                                     ". The differences below are not those of the methods.");
    }
}

/// A column of one name has one unit in all sources.
void check_units(const Comparison& comparison) {
    std::map<std::pair<std::string, std::string>, std::pair<std::string, std::string>> first;  // -> unit, source
    for (std::size_t i = 0; i < comparison.sources.size(); ++i)
        for (const auto& [table, content] : comparison.sources[i].tables)
            for (const Column& c : content.columns) {
                const auto at = first.try_emplace({table, c.name}, c.unit, method_label(comparison.names[i])).first;
                if (at->second.first != c.unit)
                    throw InputError(fmt::format(
                        "{} of table {} is in {} in {} and in {} in {}; expected one unit: import "
                        "with a unit, or convert the record",
                        c.name, table, at->second.first, at->second.second, c.unit, method_label(comparison.names[i])));
            }
}

/// A name that no method of this version has is either an import's, which says so, or unknown.
void add_unknown_methods(Comparison& comparison) {
    for (const RunRecord& r : comparison.sources) {
        const std::string method = text_of(r, "method", "unnamed");
        if (find_method(method) || r.attributes.contains("import_kind")) continue;
        comparison.banners.push_back(
            fmt::format("{}: no method of this version ({}), and no import; its record is compared as it stands.",
                        method, fmt::join(method_names(), ", ")));
    }
}

void add_state_banners(Comparison& comparison) {
    if (comparison.sources.size() == 1)
        comparison.banners.push_back("One run only, " + method_label(comparison.names[0]) +
                                     ": its values are shown without a comparison.");
    for (std::size_t i = 0; i < comparison.sources.size(); ++i) {
        const RunRecord& r = comparison.sources[i];
        if (r.state == "finished" || comparison.failed(i)) continue;  // a failure is the first thing that is said
        comparison.banners.push_back(
            fmt::format("{} did not finish (state: {}{}{}); what it recorded is {} as far as it goes.",
                        method_label(comparison.names[i]), r.state, r.reason.empty() ? "" : ": ", r.reason,
                        comparison.sources.size() > 1 ? "compared" : "shown"));
    }
}

void add_tuned(Comparison& comparison) {
    for (std::size_t i = 0; i < comparison.sources.size(); ++i) {
        const std::string calibrated = text_of(comparison.sources[i], "calibrated");
        if (!calibrated.empty() && calibrated != "none")
            comparison.tuned.push_back(
                fmt::format("{} was tuned: {}. Agreement with the data used for that is no validation.",
                            method_label(comparison.names[i]), calibrated));
    }
}

/// A run that went wrong says nothing of its method: what it recorded is compared with nothing.
void set_failed_aside(Comparison& c) {
    if (c.sources.size() < 2) return;
    for (Quantity& q : c.quantities) {
        for (Difference& d : q.differences())
            for (const std::size_t s : {d.b, d.a})
                if (c.failed(s)) d = Difference{.a = d.a, .b = d.b, .remark = method_label(c.names[s]) + " failed"};
        if (!q.pairs.empty()) take_farthest(q);
    }
}

/// The formula at what each run itself finds wet: what it says of the lift apart from where the water meets the keel.
void add_savitsky_at_wetted_lengths(Comparison& comparison, const PlaningState& state) {
    const Quantity* wet = comparison.find("wetted_length");
    for (std::size_t i = 0; wet && i < wet->values.size(); ++i) {
        if (!wet->values[i].known || comparison.failed(i)) continue;
        const double keel = wet->values[i].value / std::cos(state.trim);  // the record's is along x
        const Savitsky s = savitsky_at_keel(state, keel);
        const auto add = [&](const char* quantity, double value) {
            comparison.references.push_back(
                {quantity, "N", fmt::format("Savitsky 1964 at {}'s wetted length", method_label(comparison.names[i])),
                 value, 0.1 * std::abs(value), fmt::format("the keel is wet over {:.3g} m", keel), s.in_range, true});
        };
        add("lift", s.lift);
        if (comparison.find("total_drag")) add("total_drag", s.drag);
    }
}

void add_savitsky(Comparison& comparison) {
    // A method may keep the hull as its mesh sees it, with edges cut: the first surface that is a clean prism is taken.
    std::optional<PrismaticHull> hull;
    for (const RunRecord& record : comparison.sources)
        if (!hull) hull = prismatic_hull(record);
    const RunRecord& first = comparison.sources.front();
    if (!hull || number_of(first, "dimensions", 3) == 2 || text_of(first, "motion") == "none") return;
    const bool friction = std::ranges::any_of(comparison.sources, [](const RunRecord& r) {
        const Column* c = r.series("forces", "fx_viscous");
        return c && std::ranges::any_of(c->values, [](double v) { return std::isfinite(v) && v != 0; });
    });
    Savitsky s;
    if (text_of(first, "hull_free") == "heave pitch") {
        const PlaningMass mass{number_of(first, "hull_mass", 0) * hull->state.gravity, number_of(first, "hull_lcg", 0),
                               number_of(first, "hull_vcg", 0), friction};
        const auto running = savitsky_free(hull->state, mass);
        if (!running) return;
        s = running->second;
        const double trim = running->first.trim * 180 / std::numbers::pi;
        comparison.references.push_back({"running_trim", "deg", "Savitsky 1964", trim, 0.1 * trim,
                                         "of weight and centre of gravity, towed through that", s.in_range});
    } else if (!text_of(first, "hull_free").empty()) {
        return;
    } else {
        s = savitsky_at_draft(hull->state, hull->draft);
    }
    // a hull that would have to be longer than it is does not plane on a prism
    const auto length = first.numbers.find("length");
    if (length != first.numbers.end() && s.keel_wetted_length > length->second) return;
    constexpr double told = 0.01;  // of the bottom
    const std::string range =
        (s.in_range ? "empirical, about ±10 %" : "outside the formula's range: a hint at most") +
        (hull->bow > told
             ? fmt::format("; a bow of another shape is {:.1f} % of the bottom below still water", 100 * hull->bow)
             : std::string());
    const std::string source = "Savitsky 1964";
    const auto add = [&](const char* quantity, double value, const std::string& remark) {
        comparison.references.push_back({quantity, "N", source, value, 0.1 * std::abs(value), remark, s.in_range});
    };
    const std::string above = fmt::format("measured lifts lie {:.0f} to {:.0f} % above this formula",
                                          100 * (measured_over_savitsky[0] - 1), 100 * (measured_over_savitsky[1] - 1));
    add("lift", s.lift, range + (s.in_range ? "; " + above : ""));
    if (s.in_range) comparison.references.back().bias = above;
    if (friction)
        add("drag", s.drag, range + "; with ITTC-57 friction");
    else
        add("drag", s.pressure_drag, range + "; pressure part only, as the runs have no friction");
    if (comparison.find("total_drag")) add("total_drag", s.drag, range + "; with ITTC-57 friction");
    comparison.references.push_back(
        {"wetted_length", "m", source, s.keel_wetted_length, 0.1 * s.keel_wetted_length,
         text_of(first, "hull_free").empty() ? "of the keel, from the draft alone" : "of the keel", true});
    if (text_of(first, "hull_free").empty()) add_savitsky_at_wetted_lengths(comparison, hull->state);
}

void add_planing_plate(Comparison& comparison) {
    // The first surface that is a clean plate, as above.
    for (const RunRecord& record : comparison.sources) {
        std::vector<Reference> of_plate = planing_plate_references(record);
        if (of_plate.empty()) continue;
        std::ranges::move(of_plate, std::back_inserter(comparison.references));
        return;
    }
}

/// A record may come from elsewhere, with any text as its unit.
bool measures_the_same(const std::string& text, const Unit& unit) {
    try {
        return parse_unit(text).dimension == unit.dimension;
    } catch (const UnitError&) { return false; }
}

/// What the scene gives of measurements, in the units of the quantities.
void add_measured(Comparison& comparison) {
    for (const MeasuredValue& m : measured_values(comparison.sources.front())) {
        const Quantity* q = comparison.find(m.quantity);
        if (!q) {
            comparison.banners.push_back(fmt::format(
                "The scene gives a measured value of {}, and these runs have no such quantity; the names are "
                "in quantities.csv.",
                m.quantity));
            continue;
        }
        const Unit unit = parse_unit(q->unit);
        if (!measures_the_same(m.unit, unit)) {
            comparison.banners.push_back(fmt::format(
                "The scene gives a measured value of {} in {}, and the quantity has the unit {}: it is not shown.",
                m.quantity, m.unit, q->unit));
            continue;
        }
        comparison.references.push_back(
            {m.quantity, q->unit, fmt::format("the measured value ({})", m.source), m.value / unit.factor,
             m.half_width / unit.factor,
             m.half_width > 0 ? "± is that of the measurement" : "the measurement's uncertainty is not known"});
        comparison.references.back().measured = true;
    }
}

}  // namespace

Comparison compare_records(std::vector<RunRecord> sources, const CompareOptions& options) {
    if (sources.empty()) throw InputError("no run record to compare; give at least one record.h5");
    if (!(options.agree_within > 0))
        throw InputError(
            fmt::format("the target of agreement is {}; expected a fraction above 0, e.g. 0.05", options.agree_within));
    Comparison comparison;
    comparison.agree_within = options.agree_within;
    comparison.names = source_names(sources);
    comparison.sources = std::move(sources);
    check_same(comparison, "scene_hash", "scene", options.force);
    check_same(comparison, "hull_hash", "hull", options.force);
    check_units(comparison);
    add_unknown_methods(comparison);
    add_state_banners(comparison);
    add_tuned(comparison);
    const Vec3 reference = moment_reference_of(comparison.sources.front());
    for (RunRecord& record : comparison.sources) {
        crop_to_domain(record);
        complete_half_hull(record);
        refer_moments_to(record, reference);
    }
    for (std::size_t i = 0; i < comparison.sources.size(); ++i) {
        const double factor = number_of_text(comparison.sources[i], "symmetry_factor", 1);
        if (factor > 1 && i == 0)
            comparison.banners.push_back(fmt::format(
                "Half model: one half was solved; forces, moments, areas and volumes are those of the whole hull "
                "(multiplied by {:g}, once).",
                factor));
        comparison.analyses.push_back(analyse(comparison.sources[i]));
    }
    add_box(comparison);
    add_forces(comparison, options);
    add_total_drag(comparison, options);
    add_resistance(comparison, options);
    add_wetted_length(comparison, options);
    add_hull_motion(comparison, options);
    add_splash(comparison, options);
    add_elevation(comparison, options);
    add_probes(comparison, options);
    add_regular_wave(comparison);
    add_added_by_waves(comparison, options);
    add_sea(comparison);
    add_wave_peaks(comparison);
    add_volumes(comparison);
    add_free_decay(comparison);
    add_bodies(comparison);
    add_tank_loads(comparison);
    add_entries(comparison);
    add_gauges(comparison);
    add_walls(comparison);
    set_failed_aside(comparison);
    add_measured(comparison);
    add_savitsky(comparison);
    add_planing_plate(comparison);
    for (std::size_t i = 0; i < comparison.sources.size(); ++i)
        for (ValidityCheck& check : checks_of(comparison.sources[i], comparison.names[i]))
            comparison.checks.push_back(std::move(check));
    return comparison;
}

}  // namespace tw
