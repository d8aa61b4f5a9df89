#include <nlohmann/json.hpp>

#include "compare/grid_study/grid_study_report.h"

namespace tw {

namespace {

using Json = nlohmann::ordered_json;

Json json_of(const GridStudyRun& r) {
    return {{"spacing", r.spacing},
            {"elements", r.elements},
            {"steps", r.steps},
            {"wall_seconds", r.seconds},
            {"predicted_seconds", r.predicted_seconds},
            {"core_seconds", r.core_seconds},
            {"memory_bytes", r.memory}};
}

Json json_of(const CostOfAccuracy& c) {
    Json points = Json::array();
    for (const CostPoint& p : c.points)
        points.push_back({{"spacing", p.spacing},
                          {"wall_seconds", p.seconds},
                          {"core_seconds", p.core_seconds},
                          {"memory_bytes", p.memory},
                          {"uncertainty", p.uncertainty}});
    return {{"points", points},
            {"slope", c.slope},
            {"price_of_halving", c.known() ? c.price_of_halving() : nan},
            {"why_not", c.why_not}};
}

Json json_of(const GridStudyValue& v, double size) {
    Json levels = Json::array(), sensitivities = Json::array(), seconds_to = Json::object();
    for (std::size_t i = 0; i < v.levels.size(); ++i)
        levels.push_back({{"spacing", v.levels[i].h}, {"value", v.levels[i].value}, {"statistical", v.half_widths[i]}});
    for (const Sensitivity& s : v.sensitivities)
        sensitivities.push_back({{"name", s.name},
                                 {"spacing", s.spacing},
                                 {"value", s.value},
                                 {"varied", s.varied},
                                 {"box", s.box},
                                 {"input", s.input},
                                 {"refused", s.refused},
                                 {"uncertainty", s.uncertainty}});
    if (v.cost.known() && !v.levels.empty())
        for (const auto& [name, share] : {std::pair{"5%", 0.05}, {"2%", 0.02}, {"1%", 0.01}})
            seconds_to[name] = v.cost.seconds_for(share * size);
    Json cost = json_of(v.cost);
    cost["seconds_to"] = seconds_to;
    return {{"levels", levels},
            {"absent", v.absent},
            {"statistical", v.statistical},
            {"order", v.estimate.order},
            {"class", to_string(v.estimate.convergence)},
            {"resolution", v.estimate.uncertainty},
            {"method", v.estimate.method},
            {"scatter", v.estimate.trend_noise.sigma},
            {"eca_hoekstra", v.estimate.eca_hoekstra.uncertainty},
            {"gci", v.estimate.celik_gci.uncertainty},
            {"factor_of_safety", v.estimate.xing_stern.uncertainty},
            {"disagreement", v.estimate.disagreement},
            {"limit", v.estimate.limit},
            {"sensitivities", sensitivities},
            {"choices", v.choices},
            {"box", v.box},
            {"input", v.input},
            {"uncertainty", v.uncertainty},
            {"cost", cost}};
}

Json json_of(const GridStudy& grid_study, const GridStudyQuantity& q, const GridStudyDifference& d) {
    return {{"difference", d.difference},
            {"interval", d.interval},
            {"per_cent", d.per_cent},
            {"verdict", to_string(d.verdict)},
            {"sentence", grid_study_sentence(grid_study, q, d)},
            {"seconds_to_target", d.seconds_to_target},
            {"reason", d.reason}};
}

}  // namespace

std::string grid_study_json(const GridStudy& grid_study) {
    Json sides = Json::array(), quantities = Json::array();
    for (const GridStudySide& s : grid_study.sides) {
        Json runs = Json::array(), variations = Json::array();
        for (const GridStudyRun& r : s.runs) runs.push_back(json_of(r));
        for (const GridStudyVariation& v : s.variations) {
            variations.push_back(json_of(v.run));
            variations.back()["name"] = v.name;
            variations.back()["factor"] = v.factor;
            variations.back()["refused"] = v.refused;
        }
        sides.push_back({{"method", s.method}, {"similar", s.similar}, {"runs", runs}, {"variations", variations}});
    }
    for (const GridStudyQuantity& q : grid_study.quantities) {
        Json values = Json::array();
        for (const GridStudyValue& v : q.values) values.push_back(json_of(v, q.size));
        Json held = Json::array();
        for (const Held& h : q.held) {
            Json validations = Json::array();
            for (std::size_t k = 0; k < h.validations.size(); ++k)
                validations.push_back({{"method", grid_study.sides[k].method},
                                       {"difference", h.validations[k].E},
                                       {"interval", h.validations[k].U_val},
                                       {"verdict", to_string(h.validations[k].verdict)}});
            held.push_back({{"source", h.source},
                            {"value", h.value.value},
                            {"interval", h.value.half_width},
                            {"validations", validations}});
        }
        quantities.push_back({{"name", q.name}, {"unit", q.unit}, {"values", values}, {"held_against", held}});
        quantities.back().update(json_of(grid_study, q, q));
        for (const GridStudyDifference& d : q.pairs) {
            Json pair{{"methods", {grid_study.sides[d.a].method, grid_study.sides[d.b].method}}};
            pair.update(json_of(grid_study, q, d));
            quantities.back()["pairs"].push_back(pair);
        }
    }
    const Json all = {{"title", grid_study.title},
                      {"left_out", grid_study.left_out},
                      {"notes", grid_study.notes},
                      {"calibrated", grid_study.calibrated},
                      {"agree_within", grid_study.agree_within},
                      {"sides", sides},
                      {"quantities", quantities}};
    return all.dump(2, ' ', false, Json::error_handler_t::replace);
}

}  // namespace tw
