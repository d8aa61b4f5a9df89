#include "suite/read_truth.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>
#include <set>

#include "base/read_file.h"
#include "suite/formulas.h"
#include "text/csv_columns.h"
#include "text/did_you_mean.h"
#include "text/units.h"

namespace tw {
namespace {

namespace fs = std::filesystem;

double by_formula(Section& s, const std::string& name, SuiteQuantity& q) {
    const TruthFormula* formula = find_formula(name);
    if (!formula) {
        std::vector<std::string> known;
        for (const TruthFormula& f : truth_formulas()) known.push_back(f.name);
        s.fail("formula",
               fmt::format("not known; expected one of: {}{}", fmt::join(known, ", "), did_you_mean(name, known)));
    }
    if (formula->unit != q.judged.unit)
        s.fail("formula", fmt::format("is in {}, and the quantity's unit is {}", formula->unit, q.judged.unit));
    Section given = s.section("parameters");
    std::set<std::string> names;
    for (const TruthFormula::Parameter& p : formula->parameters) names.insert(p.name);
    refuse_others_than(names, given);
    std::vector<double> values;
    for (const TruthFormula::Parameter& p : formula->parameters) {
        const std::optional<double> value = given.number(p.name, p.unit);
        if (!value && !std::isfinite(p.fallback)) {
            const std::string missing = fmt::format("missing; {} needs it [{}]", name, p.unit);
            if (!given.present())
                s.fail("parameters." + p.name, missing);  // at the quantity, as there is no such table
            given.fail(p.name, missing);
        }
        values.push_back(value.value_or(p.fallback));
    }
    const double value = formula->value(values);
    if (!std::isfinite(value)) s.fail("formula", "gives no finite number with these parameters");
    q.judged.truth.half_width = formula->half_width * std::abs(value);
    if (q.judged.truth.source.empty()) q.judged.truth.source = formula->text + "; " + formula->source;
    return value;
}

/// Whether a row is meant by [row]: texts alike, numbers equal.
std::vector<std::size_t> rows_meant(Section& row, const TextValue* table, const CsvColumns& csv) {
    std::vector<std::size_t> rows;
    for (std::size_t r = 0; r < csv.rows(); ++r) rows.push_back(r);
    for (const auto& [column, wanted] : table->members) {
        row.know(column);
        if (wanted.kind == TextValue::Kind::text) {
            const std::vector<std::string> cells = csv.texts(column);
            std::erase_if(rows, [&, &text = wanted.text](std::size_t r) { return cells[r] != text; });
        } else if (wanted.kind == TextValue::Kind::number) {
            const std::vector<double>& cells = csv.values(column);
            const double number = wanted.number;
            std::erase_if(rows,
                          [&](std::size_t r) { return !(std::abs(cells[r] - number) <= 1e-9 * std::abs(number)); });
        } else {
            row.fail(column, "expected a number or a text: what stands in this column of the row");
        }
    }
    return rows;
}

/// One cell, or a value between two rows: linear in the column `along` at `at`.
double from_csv(Section& s, const TextValue& raw, const std::string& name) {
    const fs::path file = s.file().parent_path() / name;
    const CsvColumns csv(read_text_within(file, largest_document), file.string());
    const std::optional<std::string> column = s.text("column");
    if (!column) s.fail("column", "missing; expected one of: " + csv.header_list());
    const std::vector<double>& values = csv.values(*column);
    Section row = s.section("row");
    std::vector<std::size_t> rows;
    if (row.present()) {
        rows = rows_meant(row, raw.find("row"), csv);
        row.finish();
    } else {
        for (std::size_t r = 0; r < csv.rows(); ++r) rows.push_back(r);
    }
    const std::optional<std::string> along = s.text("along");
    const std::optional<double> at = s.number("at", "-");
    if (along.has_value() != at.has_value())
        s.fail(along ? "along" : "at", "a value between rows needs both along (a column) and at (a number of it)");
    double value = nan;
    if (along) {
        const std::vector<double>& x = csv.values(*along);
        for (std::size_t k = 0; k + 1 < rows.size(); ++k) {
            const double a = x[rows[k]], b = x[rows[k + 1]];
            if (std::min(a, b) <= *at && *at <= std::max(a, b) && a != b)
                value = values[rows[k]] + (values[rows[k + 1]] - values[rows[k]]) * (*at - a) / (b - a);
        }
        if (!std::isfinite(value))
            s.fail("at", fmt::format("{}: no two rows of {} have it between them", file.string(), *along));
    } else {
        if (rows.size() != 1)
            s.fail("row",
                   fmt::format("{}: {} rows are meant; expected one: row = {{ column = value }}, or along and at",
                               file.string(), rows.size()));
        value = values[rows.front()];
        if (!std::isfinite(value))
            s.fail("column", fmt::format("{}:{}: the cell holds no number", file.string(), csv.line(rows.front())));
    }
    return value;
}

}  // namespace

void refuse_others_than(const std::set<std::string>& known, Section section) {
    for (const std::string& key : known) section.know(key);
    section.finish();  // of this copy: what is known and not read is still found by the section's own
}

std::optional<SizeOrShare> size_or_share(Section& s, const TextValue& raw, const std::string& key,
                                         const std::string& unit) {
    const TextValue* given = raw.find(key);
    if (!given) return {};
    const bool share = given->kind == TextValue::Kind::text && given->text.ends_with('%');
    return SizeOrShare{*s.number(key, share ? "-" : unit, not_negative), share};
}

void read_truth(Section& s, const TextValue& raw, SuiteQuantity& q) {
    Truth& truth = q.judged.truth;
    truth.source = s.text("source", "");
    const std::optional<double> number = s.number("truth", q.judged.unit);
    const std::optional<std::string> formula = s.text("formula"), csv = s.text("csv"), record = s.text("record");
    std::vector<const char*> given;
    for (const char* way : {"truth", "formula", "csv", "record"})
        if (s.has(way)) given.push_back(way);
    if (given.size() != 1)
        s.fail(given.empty() ? "truth" : given.back(), "expected exactly one of truth, formula, csv and record");
    if (number) truth.value = *number;
    if (formula) truth.value = by_formula(s, *formula, q);
    if (csv) truth.value = from_csv(s, raw, *csv);
    if (formula || csv)  // of a formula or a table in other units or axes than the runs
        truth.value = s.number("factor", 1, "-") * truth.value + s.number("offset", 0, "-");
    if (record) q.measured = s.file().parent_path() / *record;
    truth.standing =
        s.choice("standing", record || csv ? "measured" : "exact", {"exact", "measured", "digitised", "derived"});
    if (truth.source.empty()) s.fail("source", "missing; expected where the truth is from, in words");
    if (const auto scale = s.number("scale", q.judged.unit, positive)) q.judged.scale = *scale;
    if (!std::isfinite(q.judged.scale) && truth.value != 0)
        q.judged.scale = std::abs(truth.value);  // of a record: later
    const auto uncertainty = size_or_share(s, raw, "uncertainty", q.judged.unit),
               goal = size_or_share(s, raw, "goal", q.judged.unit);
    if (!goal) s.fail("goal", "missing; expected the error that is aimed at, e.g. \"2 %\"");
    for (const auto& [key, given_size] : {std::pair{"uncertainty", uncertainty}, {"goal", goal}})
        if (given_size && given_size->share && !record && !std::isfinite(q.judged.scale))
            s.fail(key,
                   "per cent of a truth of 0; expected a size in " + q.judged.unit + ", or scale = what they refer to");
    q.own_uncertainty = uncertainty.has_value();
    if (uncertainty)
        truth.half_width = uncertainty->share && record ? -uncertainty->size : uncertainty->of(q.judged.scale);
    if (goal->share && record && !std::isfinite(q.judged.scale))
        q.goal_share = goal->size;
    else
        q.judged.goal = goal->of(q.judged.scale);
}

}  // namespace tw
