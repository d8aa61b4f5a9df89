#include <fmt/format.h>
#include <fmt/ranges.h>
#include <nlohmann/json.hpp>
#include <stdexcept>

#include "base/errors.h"
#include "base/own_json.h"
#include "compare/truth/validation_report.h"

namespace tw {
namespace {

using ValidationJson = nlohmann::ordered_json;
using Read = nlohmann::json;

ValidationJson json_of(const ValueBasis& b) {
    return {{"scene", b.scene}, {"definition", b.definition}, {"truth", b.truth}};
}

ValidationJson json_of(const ValidatedValue& v) {
    ValidationJson spacings = ValidationJson::array(), by_size = ValidationJson::array();
    for (const auto& [spacing, value] : v.sizes) spacings.push_back(spacing), by_size.push_back(value);
    ValidationJson by_method = ValidationJson::array();
    for (const MethodEstimate& m : v.by_method)
        by_method.push_back({{"estimator", m.method},
                             {"sizes", m.levels},
                             {"order", m.order},
                             {"class", to_string(m.convergence)},
                             {"limit", m.limit},
                             {"uncertainty", m.uncertainty},
                             {"why_not", m.why_not}});
    return {{"method", v.method},
            {"value", v.value},
            {"statistical", v.statistical},
            {"discretisation", v.discretisation},
            {"choices", v.choices},
            {"input", v.input},
            {"inputs", v.inputs},
            {"own_discretisation", v.own_discretisation},
            {"discretisation_by", by_method},
            {"outer_below", v.outer_below},
            {"outer_above", v.outer_above},
            {"order", v.order},
            {"convergence", v.convergence},
            {"spacings", spacings},
            {"value_by_spacing", by_size},
            {"E", v.E},
            {"U_num", v.U_num},
            {"U_val", v.U_val},
            {"outcome", to_string(v.outcome)},
            {"why_not", v.why_not},
            {"version", v.version},
            {"date", v.date},
            {"made_for", json_of(v.made_for)},
            {"kept", v.kept},
            {"kept_note", v.kept_note}};
}

ValidationJson json_of(const ValidatedQuantity& q) {
    ValidationJson values = ValidationJson::array(), basis = ValidationJson::object();
    for (const ValidatedValue& v : q.values) values.push_back(json_of(v));
    for (const auto& [method, is] : q.basis) basis[method] = json_of(is);
    return {{"name", q.name},
            {"label", q.label},
            {"unit", q.unit},
            {"truth",
             {{"value", q.truth.value},
              {"half_width", q.truth.half_width},
              {"standing", q.truth.standing},
              {"source", q.truth.source}}},
            {"goal", q.goal},
            {"scale", q.scale},
            {"known_miss", q.known_miss},
            {"basis", basis},
            {"values", values}};
}

ValidationJson json_of(const ValidatedCase& c) {
    ValidationJson quantities = ValidationJson::array(), costs = ValidationJson::array();
    for (const ValidatedQuantity& q : c.quantities) quantities.push_back(json_of(q));
    for (const CaseCost& k : c.costs)
        costs.push_back(
            {{"method", k.method}, {"core_seconds", k.core_seconds}, {"seconds", k.seconds}, {"runs", k.runs}});
    return {{"name", c.name},           {"title", c.title},   {"family", c.family},
            {"tier", c.tier},           {"why", c.why},       {"shows", c.shows},
            {"shows_not", c.shows_not}, {"scenes", c.scenes}, {"why_not", c.why_not},
            {"quantities", quantities}, {"costs", costs}};
}

double number_or_nan(const Read& from, const char* key) {
    const Read& value = from.at(key);
    return value.is_null() ? nan : value.get<double>();
}

Convergence convergence_of(const std::string& name) {
    for (int k = 0; k <= static_cast<int>(Convergence::irregular); ++k)
        if (const auto c = static_cast<Convergence>(k); to_string(c) == name) return c;
    throw InputError("no class of convergence is called " + name);
}

ValueBasis basis_in(const Read& from) { return {from.at("scene"), from.at("definition"), from.at("truth")}; }

ValidatedValue value_in(const Read& from) {
    ValidatedValue v;
    v.method = from.at("method"), v.value = number_or_nan(from, "value");
    v.statistical = number_or_nan(from, "statistical"), v.discretisation = number_or_nan(from, "discretisation");
    v.choices = number_or_nan(from, "choices"), v.input = number_or_nan(from, "input");
    v.outer_below = number_or_nan(from, "outer_below"), v.outer_above = number_or_nan(from, "outer_above");
    v.order = number_or_nan(from, "order"), v.convergence = from.at("convergence");
    const Read &spacings = from.at("spacings"), &by_size = from.at("value_by_spacing");
    for (std::size_t k = 0; k < spacings.size(); ++k)
        v.sizes.emplace_back(spacings.at(k).get<double>(), by_size.at(k).get<double>());
    v.E = number_or_nan(from, "E"), v.U_num = number_or_nan(from, "U_num"), v.U_val = number_or_nan(from, "U_val");
    v.why_not = from.at("why_not");
    v.version = from.value("version", ""), v.date = from.value("date", ""), v.kept = from.value("kept", false);
    v.kept_note = from.value("kept_note", "");
    if (from.contains("made_for")) v.made_for = basis_in(from["made_for"]);  // earlier reports do not say it
    if (from.contains("inputs")) v.inputs = from["inputs"].get<std::map<std::string, double>>();
    v.own_discretisation =
        from.contains("own_discretisation") ? number_or_nan(from, "own_discretisation") : v.discretisation;
    if (const auto by_method = from.find("discretisation_by"); by_method != from.end())  // earlier reports have none
        for (const Read& m : *by_method)
            v.by_method.push_back({m.at("estimator"), m.at("sizes").get<std::size_t>(), number_or_nan(m, "order"),
                                   convergence_of(m.at("class")), number_or_nan(m, "limit"),
                                   number_or_nan(m, "uncertainty"), m.at("why_not")});
    try {
        v.outcome = outcome_of(from.at("outcome"));
    } catch (const std::out_of_range& e) { throw InputError(e.what()); }
    return v;
}

ValidatedQuantity quantity_in(const Read& from) {
    ValidatedQuantity q;
    q.name = from.at("name"), q.label = from.at("label"), q.unit = from.at("unit");
    const Read& truth = from.at("truth");
    q.truth = {number_or_nan(truth, "value"), number_or_nan(truth, "half_width"), truth.at("standing"),
               truth.at("source")};
    q.goal = number_or_nan(from, "goal"), q.scale = number_or_nan(from, "scale");
    q.known_miss = from.at("known_miss").get<std::map<std::string, std::string>>();
    for (const Read& v : from.at("values")) q.values.push_back(value_in(v));
    if (from.contains("basis"))
        for (const auto& [method, is] : from["basis"].items()) q.basis[method] = basis_in(is);
    return q;
}

ValidatedCase case_in(const Read& from) {
    ValidatedCase c;
    c.name = from.at("name"), c.title = from.at("title"), c.family = from.at("family"), c.tier = from.at("tier");
    c.why = from.at("why"), c.shows = from.at("shows"), c.shows_not = from.at("shows_not");
    c.scenes = from.at("scenes").get<std::vector<std::string>>(), c.why_not = from.at("why_not");
    for (const Read& q : from.at("quantities")) c.quantities.push_back(quantity_in(q));
    for (const Read& k : from.at("costs"))
        c.costs.push_back(
            {k.at("method"), number_or_nan(k, "core_seconds"), number_or_nan(k, "seconds"), k.at("runs").get<int>()});
    return c;
}

/// Earlier reports name the version once for a case and the day once for all.
void date_all(ValidatedCase& c, const std::vector<std::string>& versions, const std::string& date) {
    for (ValidatedQuantity& q : c.quantities)
        for (ValidatedValue& v : q.values)
            if (v.outcome != Outcome::not_run) v.version = fmt::format("{}", fmt::join(versions, ", ")), v.date = date;
}

}  // namespace

std::string validation_json(const ValidationReport& report) {
    ValidationJson cases = ValidationJson::array(), families = ValidationJson::array();
    for (const ValidatedCase& c : report.cases) cases.push_back(json_of(c));
    for (const FamilySummary& f : summaries_of(report))
        families.push_back({{"family", f.family},
                            {"method", f.method},
                            {"values", f.values},
                            {"without_interval", f.without_interval},
                            {"inner", f.inner},
                            {"outer", f.outer},
                            {"narrow", f.narrow},
                            {"narrow_inner", f.narrow_inner},
                            {"met", f.met},
                            {"fall_short", f.fall_short},
                            {"median_error_per_cent", f.median_error},
                            {"core_seconds", f.core_seconds}});
    ValidationJson estimators = ValidationJson::array();
    for (const EstimatorSummary& e : estimators_of(report))
        estimators.push_back({{"estimator", e.estimator},
                              {"method", e.method},
                              {"values", e.values},
                              {"given", e.given},
                              {"holds", e.holds},
                              {"narrow", e.narrow},
                              {"narrow_holds", e.narrow_holds},
                              {"median_U_per_cent", e.median_U}});
    const ValidationJson all = {{"title", report.title},         {"tier", report.tier},
                                {"version", report.version},     {"machine", report.machine},
                                {"date", report.date},           {"command", report.command},
                                {"estimator", report.estimator}, {"families", families},
                                {"estimators", estimators},      {"cases", cases}};
    return all.dump(1, ' ', false, ValidationJson::error_handler_t::replace) + "\n";
}

ValidationReport read_validation(const std::filesystem::path& file) {
    ValidationReport report;
    read_own_json(file, [&](const Read& from) {
        report.title = from.at("title"), report.tier = from.at("tier"), report.version = from.at("version");
        report.machine = from.at("machine"), report.date = from.at("date"), report.command = from.at("command");
        report.estimator = from.value("estimator", "");
        for (const Read& c : from.at("cases")) {
            report.cases.push_back(case_in(c));
            if (c.contains("versions")) date_all(report.cases.back(), c["versions"], report.date);
        }
    });
    return report;
}

}  // namespace tw
