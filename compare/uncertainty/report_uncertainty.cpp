#include "compare/uncertainty/report_uncertainty.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <nlohmann/json.hpp>

#include "compare/report/escape.h"

namespace tw {

namespace {

using Json = nlohmann::ordered_json;

/// What the three methods have in common.
struct MethodRow {
    std::string name;
    std::size_t levels;  ///< how many it uses
    double order;
    Convergence convergence;
    double limit, uncertainty;
    std::string why_not;
};

std::vector<MethodRow> rows_of(const Estimate& e) {
    const EcaHoekstra& eca = e.eca_hoekstra;
    const CelikGci& gci = e.celik_gci;
    const XingStern& fs = e.xing_stern;
    const std::size_t n = e.levels.size();
    return {{"least squares (Eca & Hoekstra)", n, eca.p, eca.convergence, eca.phi0, eca.uncertainty, eca.why_not},
            {n == 2 ? "GCI, order assumed" : "GCI (Celik)", std::min<std::size_t>(n, 3), gci.p, gci.convergence,
             gci.phi_ext, gci.uncertainty, gci.why_not},
            {"factor of safety (Xing & Stern)", std::min<std::size_t>(n, 3), fs.p, fs.convergence, fs.limit,
             fs.uncertainty, fs.why_not}};
}

/// A name of the user's may neither steer the terminal nor break the table.
std::string plain(const std::string& text) {
    std::string out;
    for (const char c : for_terminal(text)) {
        if (c == '|') out += '\\';
        out += c;
    }
    return out;
}

std::string number(double v, const char* digits = "{:.6g}") {
    return std::isfinite(v) ? fmt::format(fmt::runtime(digits), v) : "-";
}

std::string markdown(const std::vector<std::vector<std::string>>& rows) {
    std::vector<std::size_t> width(rows[0].size(), 3);
    for (const auto& row : rows)
        for (std::size_t c = 0; c < row.size(); ++c) width[c] = std::max(width[c], row[c].size());
    std::string out;
    for (std::size_t r = 0; r < rows.size(); ++r) {
        for (std::size_t c = 0; c < width.size(); ++c) out += fmt::format("| {:<{}} ", rows[r][c], width[c]);
        out += "|\n";
        if (r > 0) continue;
        for (const std::size_t w : width) out += fmt::format("|{:-<{}}", "", w + 2);
        out += "|\n";
    }
    return out;
}

Json method_json(const MethodRow& m) {
    Json json = {{"order", m.order},
                 {"limit", m.limit},
                 {"uncertainty", m.uncertainty},
                 {"class", to_string(m.convergence)},
                 {"levels", m.levels}};
    if (!m.why_not.empty()) json["why_not"] = m.why_not;
    return json;
}

/// The three methods, each with its own numbers behind the common ones.
Json methods_json(const Estimate& e) {
    const std::vector<MethodRow> rows = rows_of(e);
    Json eca = method_json(rows[0]), gci = method_json(rows[1]), fs = method_json(rows[2]);
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
    return {{"eca_hoekstra", eca}, {"celik_gci", gci}, {"factor_of_safety", fs}};
}

}  // namespace

std::string uncertainty_text(const std::vector<QuantityEstimate>& quantities, const std::string& spacing_name) {
    std::string out;
    for (const QuantityEstimate& q : quantities) {
        const Estimate& e = q.estimate;
        const double finest = e.levels.front().value;
        const std::string name = plain(q.name);
        out +=
            fmt::format("## {}\n\n{} level{}, {} = {:g}{}; finest value {:.6g}; order of the scheme {:g}\n\n", name,
                        e.levels.size(), e.levels.size() == 1 ? "" : "s", plain(spacing_name), e.levels.front().spacing,
                        e.levels.size() == 1 ? "" : fmt::format(" to {:g}", e.levels.back().spacing), finest, e.p_th);
        std::vector<std::vector<std::string>> table{{"method", "levels", "order", "class", "limit", "U", "U [%]"}};
        std::string notes;
        for (const MethodRow& m : rows_of(e)) {
            const double per_cent = finest != 0 ? 100 * m.uncertainty / std::abs(finest) : Estimate::nan;
            table.push_back({m.name, fmt::format("{}", m.levels), number(m.order, "{:.2f}"), to_string(m.convergence),
                             number(m.limit), number(m.uncertainty, "{:.3g}"), number(per_cent, "{:.2g}")});
            if (!m.why_not.empty()) notes += fmt::format("{}: {}\n", m.name, m.why_not);
        }
        out += markdown(table);
        if (!notes.empty()) out += "\n" + notes;
        out += fmt::format("\n{}: {}\n\n", name, verdict_sentence(e));
    }
    if (!out.empty()) out.pop_back();
    return out;
}

std::string uncertainty_json(const std::vector<QuantityEstimate>& quantities, const std::string& spacing_name) {
    Json list = Json::array();
    for (const QuantityEstimate& q : quantities) {
        const Estimate& e = q.estimate;
        Json levels = Json::array();
        for (const Level& l : e.levels) levels.push_back({{"spacing", l.spacing}, {"value", l.value}});
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
