#include <cmath>
#include <nlohmann/json.hpp>

#include "compare/compare.h"
#include "compare/metrics/box_walls.h"
#include "compare/verdict/left_out.h"
#include "record/record_numbers.h"

namespace tw {

namespace {
using Json = nlohmann::ordered_json;

Json number(double v) { return std::isfinite(v) ? Json(v) : Json(nullptr); }

Json quantity_json(const Comparison& comparison, const Quantity& q) {
    Json values = Json::array(), intervals = Json::array(), sources = Json::array();
    for (std::size_t i = 0; i < q.values.size(); ++i) {
        const MeanValue& m = q.values[i];
        const OuterInterval outer = outer_interval(q, m, comparison.sources[i]);
        values.push_back(m.known ? number(m.value) : Json(nullptr));
        intervals.push_back(m.known ? number(m.bar()) : Json(nullptr));
        Json s = {{"name", comparison.names[i]},
                  {"known", m.known},
                  {"scatter", number(m.half_width)},
                  {"discretisation", number(m.discretisation)},
                  {"choices", number(m.choices)},
                  {"outer_interval", number(outer_half_width(q, m, comparison.sources[i]))},
                  {"outer", {number(m.value - outer.below), number(m.value + outer.above)}},
                  {"no_interval", m.no_uncertainty},
                  {"not_resolved", m.not_resolved},
                  {"from", m.from},
                  {"to", m.to},
                  {"independent_samples", number(m.n_effective)},
                  {"second_interval", number(m.second_opinion)},
                  {"unreliable", m.unreliable}};
        if (!m.known) {
            s["why_not"] = m.why_not;
            s["seconds_needed"] = number(m.seconds_needed);
        }
        for (const LeftOut& l : left_out_of(q, m, comparison.sources[i]))
            s["left_out"].push_back({{"name", l.name},
                                     {"influence", l.influence},
                                     {"bound", number(l.bound)},
                                     {"below", std::isfinite(l.bound) ? number(l.below) : Json(nullptr)},
                                     {"above", std::isfinite(l.bound) ? number(l.above) : Json(nullptr)}});
        sources.push_back(std::move(s));
    }
    Json json = {{"name", q.name},
                 {"label", q.label},
                 {"unit", q.unit},
                 {"definition", q.definition},
                 {"judged", q.judged},
                 {"not_resolved", q.not_resolved},
                 {"values", values},
                 {"intervals", intervals},
                 {"difference", number(q.difference)},
                 {"interval", number(q.interval)},
                 {"per_cent", number(q.per_cent)},
                 {"verdict", to_string(q.verdict)},
                 {"caveat", q.caveat},
                 {"sentence", q.sentence},
                 {"remark", q.remark},
                 {"sources", sources}};
    for (const Difference& d : q.pairs)
        json["pairs"].push_back({{"sources", {comparison.names[d.a], comparison.names[d.b]}},
                                 {"difference", number(d.difference)},
                                 {"interval", number(d.interval)},
                                 {"per_cent", number(d.per_cent)},
                                 {"verdict", to_string(d.verdict)},
                                 {"sentence", d.sentence},
                                 {"remark", d.remark}});
    return json;
}

Json cost_json(const RunRecord& r, const std::string& name) {
    Json phases = Json::array();
    double wall = 0, cpu = 0;
    for (const Phase& p : r.phases) {
        phases.push_back({{"name", p.name}, {"wall", number(p.wall)}, {"cpu", number(p.cpu)}});
        wall += p.wall;
        cpu += p.cpu;
    }
    return {{"source", name},
            {"wall", number(wall)},
            {"cpu", number(cpu)},
            {"peak_memory", number(r.peak_memory)},
            {"elements", number(r.elements)},
            {"steps", number(r.steps)},
            {"phases", phases}};
}

}  // namespace

std::string comparison_json(const Comparison& comparison) {
    Json sources = Json::array(), quantities = Json::array(), references = Json::array(), checks = Json::array(),
         cost = Json::array();
    for (std::size_t i = 0; i < comparison.sources.size(); ++i) {
        const RunRecord& r = comparison.sources[i];
        Json numbers = Json::object();
        for (const auto& [name, value] : r.numbers) numbers[name] = number(value);
        sources.push_back({{"name", comparison.names[i]},
                           {"state", r.state},
                           {"reason", r.reason},
                           {"attributes", r.attributes},
                           {"numbers", numbers}});
        cost.push_back(cost_json(r, comparison.names[i]));
    }
    for (const Quantity& q : comparison.quantities) quantities.push_back(quantity_json(comparison, q));
    for (const Reference& r : comparison.references)
        references.push_back({{"quantity", r.quantity},
                              {"unit", r.unit},
                              {"source", r.source},
                              {"value", number(r.value)},
                              {"interval", number(r.half_width)},
                              {"remark", r.remark}});
    for (const ValidityCheck& g : comparison.checks)
        checks.push_back({{"name", g.name},
                          {"source", g.source},
                          {"unit", g.unit},
                          {"value", number(g.value)},
                          {"limit", number(g.limit)},
                          {"pass", g.pass},
                          {"warns", g.warns},
                          {"remark", g.remark}});
    const Json all = {{"agree_within", comparison.agree_within},
                      {"discretisation_from", comparison.discretisation_from},
                      {"banners", all_banners(comparison)},
                      {"sources", sources},
                      {"quantities", quantities},
                      {"references", references},
                      {"gates", checks},
                      {"cost", cost}};
    // Names and titles come from users' files: bytes that are no UTF-8 are replaced, not thrown at.
    return all.dump(1, ' ', false, Json::error_handler_t::replace) + "\n";
}

}  // namespace tw
