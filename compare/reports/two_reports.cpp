#include "compare/reports/two_reports.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>
#include <optional>
#include <set>

#include "base/errors.h"
#include "compare/report/numbers.h"
#include "compare/report/report_table.h"
#include "compare/verdict/quantity_kinds.h"
#include "methods/methods.h"
#include "text/plain_number.h"

namespace tw {
namespace {

constexpr std::size_t longest_text = 60;  ///< of an attribute in a table

/// Attributes that say what was solved. All others are provenance.
const std::set<std::string> attributes_of_scene = {
    "title",       "motion",      "hull_source", "symmetry_factor", "scene_hash",   "hull_hash",        "run_hash",
    "family_hash", "time_scheme", "compliance",  "mesh_motion",     "hull_release", "equation_of_state"};
/// Numbers that say what a run was expected to take; they differ whenever something else does.
bool is_forecast(const std::string& name) { return name.starts_with("predicted_") || name.starts_with("bytes_per_"); }

const ReportedQuantity* find(const ReportFacts& report, const std::string& name) {
    const auto q = std::ranges::find(report.quantities, name, &ReportedQuantity::name);
    return q == report.quantities.end() ? nullptr : &*q;
}
std::optional<std::size_t> place_of(const ReportFacts& report, const std::string& run) {
    const auto r = std::ranges::find(report.runs, run, &ReportedRun::name);
    if (r == report.runs.end()) return {};
    return static_cast<std::size_t>(r - report.runs.begin());
}

/// A definition without its numbers: sizes that stand in it (of a voxel, a spacing) differ between runs of one kind.
std::string without_numbers(std::string definition) {
    std::erase_if(definition, [](char c) { return (c >= '0' && c <= '9') || c == '.'; });
    return definition;
}

ReportChange change_of(const ReportedQuantity& a, const ReportedQuantity& b, const std::string& run, std::size_t in_a,
                       std::size_t in_b) {
    const ReportedValue first = a.values[in_a], second = b.values[in_b];
    ReportChange change{b.name,
                        b.label,
                        b.unit,
                        run,
                        first,
                        second,
                        second.value - first.value,
                        std::hypot(first.half_width, second.half_width)};
    if (a.unit != b.unit)
        change.why_not = fmt::format("{} against {}", a.unit, b.unit);
    else if (without_numbers(a.definition) != without_numbers(b.definition))
        change.why_not = "defined otherwise in the two reports";
    else if (!std::isfinite(change.difference))
        change.why_not = std::string("no value in ") + (std::isfinite(first.value)    ? "the second"
                                                        : std::isfinite(second.value) ? "the first"
                                                                                      : "either");
    if (!change.why_not.empty()) change.difference = change.interval = std::nan("");
    return change;
}

std::string number_or_dash(double v) { return std::isfinite(v) ? plain_number(v) : "–"; }

/// What one run says otherwise: its numbers, then its attributes.
std::vector<ReportOtherwise> otherwise_of(const ReportedRun& a, const ReportedRun& b) {
    std::vector<ReportOtherwise> list;
    const auto compare = [&](const auto& first, const auto& second, const auto& text, bool solved) {
        std::set<std::string> names;
        for (const auto* all : {&first, &second})
            for (const auto& [name, value] : *all) names.insert(name);
        for (const std::string& name : names) {
            const auto x = first.find(name), y = second.find(name);
            const std::string said = x == first.end() ? "–" : text(x->second);
            const std::string says = y == second.end() ? "–" : text(y->second);
            if (said != says && !is_forecast(name))
                list.push_back({name, a.name, said, says, !solved && !attributes_of_scene.contains(name)});
        }
    };
    compare(a.numbers, b.numbers, number_or_dash, true);
    compare(
        a.attributes, b.attributes, [](const std::string& text) { return text; }, false);
    return list;
}

/// Rows that every run has with the same words become one.
std::vector<ReportOtherwise> joined(const std::vector<std::vector<ReportOtherwise>>& of_runs) {
    std::vector<ReportOtherwise> list;
    const auto same = [](const ReportOtherwise& a, const ReportOtherwise& b) {
        return a.name == b.name && a.first == b.first && a.second == b.second;
    };
    for (std::size_t r = 0; r < of_runs.size(); ++r)
        for (const ReportOtherwise& row : of_runs[r]) {
            const bool in_all = of_runs.size() > 1 && std::ranges::all_of(of_runs, [&](const auto& rows) {
                                    return std::ranges::any_of(rows, [&](const auto& o) { return same(o, row); });
                                });
            if (in_all && r > 0) continue;
            list.push_back(row);
            if (in_all) list.back().run = "all";
        }
    std::ranges::stable_partition(list, [](const ReportOtherwise& o) { return !o.provenance; });
    return list;
}

std::string shortened(std::string text) {
    std::ranges::replace(text, '\n', ' ');
    if (text.size() <= longest_text) return text;
    std::size_t end = longest_text;
    while (end > 0 && (text[end] & 0xC0) == 0x80) --end;  // not within a character
    return text.substr(0, end) + "…";
}

std::string run_text(const std::string& run) { return run == "all" ? run : method_label(run); }

std::string value_or_dash(const ReportedValue& v) {
    return std::isfinite(v.value) ? value_text(v.value, v.half_width) : "–";
}

ReportTable headline_table(const TwoReports& t) {
    ReportTable table{"Headline quantities",
                      {words("quantity"), words("run"), words("unit"), numbers("first"), numbers("second"),
                       numbers("second − first"), numbers("%"), words("")}};
    for (const ReportChange& c : t.headline) {
        const bool known = std::isfinite(c.difference);
        table.rows.push_back(
            {{c.label, run_text(c.run), c.unit, value_or_dash(c.first), value_or_dash(c.second),
              known ? signed_text(c.difference, c.interval) : "–",
              known && c.first.value != 0 ? per_cent_text(100 * c.difference / std::abs(c.first.value)) : "–",
              !c.why_not.empty()           ? ReportCell(c.why_not, Mark::faint)
              : !std::isfinite(c.interval) ? ReportCell("no interval", Mark::faint)
              : c.beyond_interval()        ? ReportCell("beyond the interval", Mark::open)
                                           : ReportCell("within the interval")}});
    }
    table.notes.push_back(
        "Interval of a difference: root of the squares of both. An error that both values share, such as the "
        "discretisation error of two runs of one size, widens this interval but cancels in the difference.");
    return table;
}

ReportTable otherwise_table(const TwoReports& t, bool provenance) {
    ReportTable table{provenance ? "Provenance that differs" : "What differs in what was solved",
                      {words("what"), words("run"), words("first"), words("second")}};
    for (const ReportOtherwise& o : t.otherwise)
        if (o.provenance == provenance)
            table.rows.push_back({{o.name, run_text(o.run), shortened(o.first), shortened(o.second)}});
    return table;
}

}  // namespace

bool ReportChange::beyond_interval() const { return std::abs(difference) > interval; }

TwoReports compare_reports(ReportFacts first, ReportFacts second) {
    TwoReports t{std::move(first), std::move(second), {}, {}, {}};
    std::vector<std::vector<ReportOtherwise>> of_runs;
    for (const ReportedRun& run : t.first.runs)
        if (const auto other = place_of(t.second, run.name))
            of_runs.push_back(otherwise_of(run, t.second.runs[*other]));
        else
            t.in_one_of_them.push_back("run " + run.name + ": first report only");
    for (const ReportedRun& run : t.second.runs)
        if (!place_of(t.first, run.name)) t.in_one_of_them.push_back("run " + run.name + ": second report only");
    if (of_runs.empty()) {
        const auto names = [](const ReportFacts& report) {
            std::vector<std::string> all;
            for (const ReportedRun& run : report.runs) all.push_back(run.name);
            return fmt::format("{}", fmt::join(all, ", "));
        };
        throw InputError(
            fmt::format("{} has the runs {}, {} has {}: no run is in both, so there is nothing to compare; expected "
                        "two reports with a "
                        "run of the same method. To compare methods, give their records (twinwake compare A/sph B/fvm)",
                        t.first.file.string(), names(t.first), t.second.file.string(), names(t.second)));
    }
    t.otherwise = joined(of_runs);
    for (const ReportedQuantity* a : main_quantities(t.first.quantities)) {
        const ReportedQuantity* b = find(t.second, a->name);
        if (!b) {
            t.in_one_of_them.push_back(a->label + ": first report only");
            continue;
        }
        for (std::size_t k = 0; k < t.first.runs.size(); ++k)
            if (const auto other = place_of(t.second, t.first.runs[k].name))
                t.headline.push_back(change_of(*a, *b, t.first.runs[k].name, k, *other));
    }
    for (const ReportedQuantity* b : main_quantities(t.second.quantities))
        if (!find(t.first, b->name)) t.in_one_of_them.push_back(b->label + ": second report only");
    return t;
}

std::string text_of(const TwoReports& t) {
    std::string text = fmt::format("first:  {}\nsecond: {}\n\n", t.first.file.string(), t.second.file.string()) +
                       text_of(headline_table(t));
    if (!t.in_one_of_them.empty()) text += fmt::format("\nNot in both: {}.\n", fmt::join(t.in_one_of_them, "; "));
    for (const bool provenance : {false, true}) {
        const ReportTable table = otherwise_table(t, provenance);
        text += table.empty() ? fmt::format("\nNothing differs in {}.\n", provenance ? "provenance" : "what was solved")
                              : "\n" + text_of(table);
    }
    return text;
}

std::string json_of(const TwoReports& t) {
    using Json = nlohmann::ordered_json;
    Json changes = Json::array(), otherwise = Json::array();
    for (const ReportChange& c : t.headline)  // a number that is not finite is written as null
        changes.push_back({{"name", c.quantity},
                           {"label", c.label},
                           {"unit", c.unit},
                           {"source", c.run},
                           {"values", {c.first.value, c.second.value}},
                           {"intervals", {c.first.half_width, c.second.half_width}},
                           {"difference", c.difference},
                           {"interval", c.interval},
                           {"why_not", c.why_not}});
    for (const ReportOtherwise& o : t.otherwise)
        otherwise.push_back(
            {{"name", o.name}, {"source", o.run}, {"values", {o.first, o.second}}, {"provenance", o.provenance}});
    const Json all = {{"reports", {t.first.file.string(), t.second.file.string()}},
                      {"quantities", changes},
                      {"otherwise", otherwise},
                      {"in_one_of_them", t.in_one_of_them}};
    return all.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace tw
