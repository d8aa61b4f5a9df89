#include "compare/report/comparison_tables.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "compare/metrics/quantity.h"
#include "compare/report/numbers.h"
#include "compare/verdict/left_out.h"
#include "compare/verdict/quantity_kinds.h"
#include "methods/methods.h"
#include "record/influence_words.h"
#include "record/record_numbers.h"
#include "text/plain_number.h"

namespace tw {

namespace {

void add_source_columns(ReportTable& table, const Comparison& c, bool right) {
    for (std::size_t s = 0; s < c.names.size(); ++s) {
        table.columns.push_back(right ? numbers(method_label(c.names[s])) : words(method_label(c.names[s])));
        table.columns.back().source = static_cast<int>(s);
    }
}

/// Why a value is missing, where the method could have given it.
std::string missing_text(const Comparison& c, const Quantity& q) {
    std::string text;
    for (std::size_t s = 0; s < q.values.size(); ++s) {
        const std::string& why = q.values[s].why_not;
        if (q.values[s].known || why.empty() || why == not_given || q.remark.find(why) != q.remark.npos) continue;
        text += (text.empty() ? "" : "; ") + method_label(c.names[s]) + ": " + why;
    }
    return text;
}

/// Of the difference in per cent of the values.
double relative_interval(const Difference& d) { return d.size > 0 ? 100 * d.interval / d.size : std::nan(""); }

ReportCell mark_of(const ValidityCheck& g) {
    if (g.pass) return {"met", Mark::good};
    return g.warns ? ReportCell("warning", Mark::open) : ReportCell("not met", Mark::bad);
}

std::string phases_text(double seconds) { return seconds > 0 ? time_text(seconds) : "–"; }

}  // namespace

ReportCell verdict_cell(Verdict verdict) {
    const Mark mark = verdict == Verdict::agree            ? Mark::good
                      : verdict == Verdict::differ         ? Mark::bad
                      : verdict == Verdict::not_comparable ? Mark::faint
                                                           : Mark::open;
    return {verdict_label(verdict), mark};
}

namespace {

/// Remark, caveat, why it is not resolved and why values are missing, each once.
std::string row_remark(const Comparison& c, const Quantity& q) {
    std::string remark = q.remark;
    const auto add = [&](const std::string& more) {
        if (!more.empty()) remark += (remark.empty() ? "" : "; ") + more;
    };
    add(q.caveat);
    if (remark.find(q.not_resolved) == remark.npos) add(q.not_resolved);
    add(missing_text(c, q));
    return remark;
}

/// A row for each pair of sources, or one where there is a single source; the values stand in the first.
void add_rows(ReportTable& table, const Comparison& c, const Quantity& q, bool judged) {
    const std::size_t sources = c.sources.size();
    ReportRow row{{q.label, q.unit}, row_remark(c, q)};
    for (const MeanValue& m : q.values) row.cells.emplace_back(mean_text(m));
    if (sources < 2) table.rows.push_back(std::move(row));
    for (const Difference& d : sources > 1 ? q.differences() : std::span<const Difference>()) {
        if (sources > 2) {
            if (!std::isfinite(d.difference) && (std::isfinite(q.difference) || &d != &q.pairs.front()))
                continue;  // a value is missing: said once
            const std::string between = method_label(c.names[d.b]) + " − " + method_label(c.names[d.a]);
            row.cells.resize(2 + sources);
            row.cells.emplace_back(between);
            if (!d.remark.empty() && std::isfinite(d.difference))
                row.remark += (row.remark.empty() ? "" : "; ") + between + ": " + d.remark;
        }
        row.cells.emplace_back(signed_text(d.difference, d.interval));
        row.cells.emplace_back(difference_text(d.per_cent, relative_interval(d),
                                               of_scale(d.size, q.values[d.a].value, q.values[d.b].value, q.unit)));
        if (judged) row.cells.push_back(verdict_cell(d.verdict));
        table.rows.push_back(row);
        row = {std::vector<ReportCell>(2 + sources)};
        row.cells.front() = q.label;
    }
    for (const Reference& r : c.references)
        if (r.quantity == q.name)
            table.rows.push_back(
                {{q.label + ", " + r.source, r.unit, value_text(r.value, r.half_width)}, r.remark, true});
}

/// What the values and their intervals are, and what a verdict means.
void add_notes(ReportTable& table, const Comparison& c, bool judged) {
    const bool pair = c.sources.size() > 1;
    if (!judged) {
        table.notes.push_back(
            "± is the scatter of the means (95 %), or what else limits them (raster, time between frames); the "
            "discretisation error is not in it.");
        return;
    }
    const std::string values = is_stream(c.sources.front())
                                   ? "Values are settled means. "
                                   : "Values of forces are settled means, of splash the largest of the run. ";
    if (c.discretisation_from.empty()) {
        table.notes.push_back(values +
                              "± is the statistical scatter of the mean (95 %), or what else limits it (raster, "
                              "draft); the discretisation error is not in it.");
        if (pair)
            table.notes.push_back(
                "Runs of one size each show how far apart the methods are at this size. Whether they agree needs the "
                "discretisation error, which takes several sizes: twinwake run without --no-twins, or twinwake "
                "ladder.");
        return;
    }
    table.notes.push_back(values +
                          "± is the 95 % interval of the statistical scatter of the mean, of the "
                          "discretisation error (from " +
                          c.discretisation_from +
                          ") and of other choices (box, sound speed, time step) and of uncertain input as far as runs "
                          "were made for them.");
    if (pair)
        table.notes.push_back(fmt::format(
            "Agree: the difference lies inside the joint interval, and that is at most {:g} % of the value, or both "
            "together are. Differ: it lies outside. Undecided: inside, but the interval is too wide for a verdict. The "
            "influence of the walls of the "
            "box is not part of the joint interval, because both methods solve the same box.",
            100 * c.agree_within));
}

}  // namespace

ReportTable quantities_table(const Comparison& c, bool judged) {
    const bool pair = c.sources.size() > 1, matrix = c.sources.size() > 2;
    ReportTable table{judged ? (pair ? "Difference by quantity" : "Values") : "Also measured, without a verdict",
                      {words("Quantity"), words("unit")}};
    add_source_columns(table, c, true);
    if (pair) {
        if (matrix) table.columns.push_back(words("between"));
        table.columns.push_back(
            numbers(matrix ? "difference" : method_label(c.names[1]) + " − " + method_label(c.names[0])));
        table.columns.push_back(numbers("relative"));
        if (judged) table.columns.push_back(words("verdict"));
    }
    std::string zero, unknown;  // rows that would say nothing are named below the table
    for (const Quantity& q : c.quantities) {
        if (q.judged != judged) continue;
        if (std::ranges::none_of(q.values, &MeanValue::known)) {
            const std::string why = missing_text(c, q);
            unknown += (unknown.empty() ? "" : "; ") + q.label + (why.empty() ? "" : " (" + why + ")");
        } else if (std::ranges::all_of(q.values,
                                       [](const MeanValue& m) { return m.known && m.value == 0 && !(m.bar() > 0); })) {
            zero += (zero.empty() ? "" : ", ") + q.label;
        } else {
            add_rows(table, c, q, judged);
        }
    }
    if (!zero.empty()) table.notes.push_back("0 in every run: " + zero + ".");
    if (!unknown.empty()) table.notes.push_back("Without a value in any run: " + unknown + ".");
    add_notes(table, c, judged);
    return table;
}

namespace {

/// "1492 ± 96", or from where to where of an interval that is wider to one side.
std::string outer_text(const MeanValue& m, const OuterInterval& outer) {
    if (!std::isfinite(outer.below)) return "–";
    const double most = std::max(outer.below, outer.above);
    if (std::abs(outer.above - outer.below) < 0.01 * most) return value_text(m.value, most);
    return value_text(m.value - outer.below, most) + " … " + value_text(m.value + outer.above, most);
}

}  // namespace

ReportTable left_out_table(const Comparison& c) {
    ReportTable table{"Not in these intervals",
                      {words("Quantity"), words("unit"), words("left out, with its influence")}};
    add_source_columns(table, c, true);
    std::vector<const Quantity*> all;
    for (const Quantity* q : main_quantities(c.quantities)) all.push_back(q);
    for (const Quantity& q : c.quantities)
        if (q.judged && std::ranges::find(all, &q) == all.end()) all.push_back(&q);
    for (const Quantity* q : all) {
        std::vector<ReportCell> outer;
        std::vector<std::pair<std::string, std::vector<std::size_t>>>
            found;  // in words, and which sources leave it out
        std::size_t known = 0;
        for (std::size_t s = 0; s < c.sources.size(); ++s) {
            known += q->values[s].known ? 1 : 0;
            for (const LeftOut& l : left_out_of(*q, q->values[s], c.sources[s])) {
                const std::string here = l.name + (l.influence.empty() ? "" : " (" + l.influence + ")");
                auto same = std::ranges::find(found, here, &std::pair<std::string, std::vector<std::size_t>>::first);
                if (same == found.end()) same = found.insert(same, {here, {}});
                same->second.push_back(s);
            }
            outer.emplace_back(outer_text(q->values[s], outer_interval(*q, q->values[s], c.sources[s])));
        }
        std::string left_out;
        for (const auto& [what, by] : found) {
            std::string who;
            for (const std::size_t s : by) who += (who.empty() ? " by " : " and ") + method_label(c.names[s]);
            left_out += (left_out.empty() ? "" : ", ") + what + (by.size() < known ? who + " alone" : "");
        }
        if (left_out.empty()) continue;
        ReportRow row{{q->label, q->unit, left_out}};
        row.cells.insert(row.cells.end(), outer.begin(), outer.end());
        table.rows.push_back(std::move(row));
    }
    table.notes.push_back(
        std::string("Values with outer intervals: root of the sum of squares of the interval and of the influences "
                    "that have a bound.") +
        (c.sources.size() > 1 ? " What both methods leave out cancels in their difference." : ""));
    return table;
}

namespace {

std::string half_width_text(double half_width, const MeanValue& m) {
    if (!m.known) return "–";
    return half_width <= 1e-9 * std::abs(m.value) ? "0" : value_text(half_width, 0);  // no more than rounding
}

std::string settling_remark(const MeanValue& m) {
    if (!m.known) return m.why_not;
    if (!m.limited_by.empty()) return "± is that of " + m.limited_by;
    return m.unreliable ? "the two estimates differ by more than a factor of 1.5; the wider is used" : "";
}

}  // namespace

ReportTable settling_table(const Comparison& c) {
    ReportTable table{"",
                      {words("Quantity"), words("run"), numbers("window"), numbers("independent samples"),
                       numbers("± by autocorrelation"), numbers("± by batch means"), words("")}};
    for (const Quantity& q : c.quantities)
        for (std::size_t s = 0; s < q.values.size(); ++s) {
            const MeanValue& m = q.values[s];
            if (!q.judged || !(m.n_effective > 0)) continue;
            table.rows.push_back(
                {{q.label, run_cell(method_label(c.names[s]), s), fmt::format("{:.3g} … {:.3g} s", m.from, m.to),
                  m.n_effective, half_width_text(m.half_width, m), half_width_text(m.second_opinion, m),
                  settling_remark(m)}});
        }
    return table;
}

ReportTable checks_table(const std::vector<ValidityCheck>& checks, bool failed_only) {
    ReportTable table{
        failed_only ? "Checks not met" : "Soundness of the runs",
        {words("Check"), words("run"), numbers("value"), words("unit"), numbers("limit"), words(""), words("remark")}};
    for (const ValidityCheck& g : checks)
        if (!failed_only || !g.pass)
            table.rows.push_back({{g.name, method_label(g.source), g.value, g.unit == "-" ? "" : g.unit, g.limit,
                                   mark_of(g), g.remark}});
    return table;
}

ReportTable effects_table(const Comparison& c) {
    ReportTable table{"Effects solved and left out",
                      {words("Effect"), words("solved"), words("reason"), words("expected influence"), words("cost")}};
    const auto with = std::ranges::find_if(c.sources, [](const RunRecord& r) { return !r.effects.empty(); });
    if (with == c.sources.end()) return table;
    for (const EffectChoice& e : with->effects)
        table.rows.push_back({{e.name, std::string(e.on ? "yes" : "no") + (e.forced ? " (asked for)" : ""), e.reason,
                               influence_in_words(e.influence, is_stream(*with)),
                               e.cost > 0 ? fmt::format("{:.0f} % of a particle run", 100 * e.cost) : ""}});
    return table;
}

ReportTable cost_table(const Comparison& c) {
    ReportTable table{"What it cost", {words("")}};
    add_source_columns(table, c, true);
    const auto row = [&](const std::string& name, const auto& value) {
        ReportRow line{{name}};
        for (const RunRecord& r : c.sources) line.cells.emplace_back(r.phases.empty() ? "–" : value(r));
        table.rows.push_back(std::move(line));
    };
    if (std::ranges::all_of(c.sources, [](const RunRecord& r) { return r.phases.empty(); })) return table;
    const auto total = [](const RunRecord& r, double Phase::*part) {
        double sum = 0;
        for (const Phase& p : r.phases) sum += p.*part;
        return sum;
    };
    const auto predicted = [](const char* name, const auto& in_words) {
        return [=](const RunRecord& r) {
            const double v = number_of(r, name, 0);
            return v > 0 ? in_words(v) : std::string("–");
        };
    };
    const auto megabytes = [](double bytes) { return plain_number(bytes / 1e6) + " MB"; };
    row(elements_of_all(), [](const RunRecord& r) { return fmt::format("{:.0f}", r.elements); });
    row("time steps", [](const RunRecord& r) { return fmt::format("{:.0f}", r.steps); });
    row("wall time", [&](const RunRecord& r) { return time_text(total(r, &Phase::wall)); });
    row("processor time", [&](const RunRecord& r) { return time_text(total(r, &Phase::cpu)); });
    row("predicted: particles with walls, or cells",
        predicted("predicted_elements", [](double n) { return plain_number(n); }));
    row("predicted: wall time", predicted("predicted_seconds", time_text));
    row("predicted: memory", predicted("predicted_memory", megabytes));
    row("peak memory", [&](const RunRecord& r) { return megabytes(r.peak_memory); });
    row("element steps per processor second", [&](const RunRecord& r) {
        const double cpu = total(r, &Phase::cpu);
        return cpu > 0 ? plain_number(r.elements * r.steps / cpu) : std::string("–");
    });
    std::vector<std::string> phases;
    for (const RunRecord& r : c.sources)
        for (const Phase& p : r.phases)
            if (std::ranges::find(phases, p.name) == phases.end()) phases.push_back(p.name);
    for (const std::string& phase : phases)
        row("of which " + phase + " (wall)", [&](const RunRecord& r) {
            double wall = 0;
            for (const Phase& p : r.phases)
                if (p.name == phase) wall += p.wall;
            return phases_text(wall);
        });
    return table;
}

ReportTable provenance_table(const Comparison& c) {
    std::set<std::string> names;
    for (const RunRecord& r : c.sources)
        for (const auto& [name, text] : r.attributes)
            if (!name.starts_with("hull_finding_") && !name.starts_with("hull_repair_") && name != "title")
                names.insert(name);
    ReportTable table{"Provenance", {words("")}};
    add_source_columns(table, c, false);
    for (const std::string& name : names) {
        ReportRow row{{name}};
        const std::string first = text_of(c.sources.front(), name, "–");
        if (std::ranges::all_of(c.sources, [&](const RunRecord& r) { return text_of(r, name, "–") == first; })) {
            row.cells.emplace_back(first);
            row.cells.back().wide = true;
        } else {
            for (const RunRecord& r : c.sources) row.cells.emplace_back(text_of(r, name, "–"));
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

}  // namespace tw
