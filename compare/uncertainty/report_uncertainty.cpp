#include "compare/uncertainty/report_uncertainty.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "compare/report/report_table.h"

namespace tw {

namespace {

using Json = nlohmann::ordered_json;

/// The method's name for a table of its own, where there is room.
std::string long_name(const Estimate& e, const MethodEstimate& m) {
    if (m.method == "eca_hoekstra") return "least squares (Eca & Hoekstra)";
    if (m.method == "gci") return e.levels.size() == 2 ? "GCI, order assumed" : "GCI (Celik)";
    if (m.method == "factor_of_safety") return "factor of safety (Xing & Stern)";
    return uncertainty_method_label(m.method);
}

Json method_json(const MethodEstimate& m) {
    Json json = {{"order", m.order},
                 {"limit", m.limit},
                 {"uncertainty", m.uncertainty},
                 {"class", to_string(m.convergence)},
                 {"levels", m.levels}};
    if (!m.why_not.empty()) json["why_not"] = m.why_not;
    return json;
}

/// The methods, each with its own numbers behind the common ones.
Json methods_json(const Estimate& e) {
    const std::vector<MethodEstimate> rows = method_estimates(e);
    Json trend = method_json(rows[0]), eca = method_json(rows[1]), gci = method_json(rows[2]),
         fs = method_json(rows[3]);
    if (e.trend_noise.known)
        trend.update(Json{{"scatter", e.trend_noise.sigma},
                          {"trend_probability", e.trend_noise.trend},
                          {"limit_interval", e.trend_noise.phi0_interval},
                          {"finest_without_noise", e.trend_noise.phi1},
                          {"finest_without_noise_interval", e.trend_noise.phi1_interval}});
    if (e.eca_hoekstra.known)
        eca.update(Json{{"fit", to_string(e.eca_hoekstra.fit)},
                        {"weighted", e.eca_hoekstra.weighted},
                        {"sigma", e.eca_hoekstra.sigma},
                        {"data_range", e.eca_hoekstra.data_range},
                        {"safety_factor", e.eca_hoekstra.Fs}});
    if (e.celik_gci.known)
        gci.update(Json{{"safety_factor", e.celik_gci.Fs},
                        {"gci_fine", e.celik_gci.GCI21},
                        {"gci_medium", e.celik_gci.GCI32},
                        {"asymptotic", e.celik_gci.asymptotic},
                        {"approximate_error", e.celik_gci.e_a},
                        {"extrapolated_error", e.celik_gci.e_ext}});
    if (e.xing_stern.known)
        fs.update(Json{{"safety_factor", e.xing_stern.factor},
                       {"order_over_scheme", e.xing_stern.P},
                       {"richardson_error", e.xing_stern.delta_RE}});
    return {{"trend_and_noise", trend}, {"eca_hoekstra", eca}, {"celik_gci", gci}, {"factor_of_safety", fs}};
}

}  // namespace

std::string uncertainty_text(const std::vector<QuantityEstimate>& quantities, const std::string& spacing_name) {
    std::string out;
    for (const QuantityEstimate& q : quantities) {
        const Estimate& e = q.estimate;
        const double finest = e.levels.front().value;
        const auto place = [](double v) { return std::isfinite(v) ? fmt::format("{:.2f}", v) : "–"; };
        ReportTable table{q.name,
                          {words("method"), numbers("levels"), numbers("order"), words("class"),
                           numbers("limit", "", 6), numbers("U"), numbers("U", "%", 2)}};
        for (const MethodEstimate& m : method_estimates(e)) {
            const double per_cent = finest != 0 ? 100 * m.uncertainty / std::abs(finest) : nan;
            table.rows.push_back({{long_name(e, m), m.levels, place(m.order), to_string(m.convergence), m.limit,
                                   m.uncertainty, per_cent},
                                  m.why_not});
        }
        table.notes.push_back(
            fmt::format("{} level{}, {} = {:g}{}; finest value {:.6g}; order of the scheme {:g}", e.levels.size(),
                        e.levels.size() == 1 ? "" : "s", spacing_name, e.levels.front().h,
                        e.levels.size() == 1 ? "" : fmt::format(" to {:g}", e.levels.back().h), finest, e.p_th));
        table.notes.push_back(q.name + ": " + verdict_sentence(e));
        out += (out.empty() ? "" : "\n") + text_of(table);
    }
    return out;
}

std::string uncertainty_json(const std::vector<QuantityEstimate>& quantities, const std::string& spacing_name) {
    Json list = Json::array();
    for (const QuantityEstimate& q : quantities) {
        const Estimate& e = q.estimate;
        Json levels = Json::array();
        for (const StudyLevel& l : e.levels) levels.push_back({{"spacing", l.h}, {"value", l.value}});
        Json json = {{"name", q.name},
                     {"levels", levels},
                     {"scheme_order", e.p_th},
                     {"class", to_string(e.convergence)},
                     {"converged", e.converged},
                     {"method", e.method},
                     {"order", e.order},
                     {"limit", e.limit},
                     {"uncertainty", e.uncertainty},
                     {"verdict", verdict_sentence(e)}};
        json.update(methods_json(e));
        list.push_back(std::move(json));
    }
    Json all = {{"spacing", spacing_name}, {"quantities", list}};
    if (quantities.size() == 1) all.update(methods_json(quantities[0].estimate));
    return all.dump(2, ' ', false, Json::error_handler_t::replace);
}

}  // namespace tw
