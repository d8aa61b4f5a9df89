// Prints how often the 95 % intervals of the discretisation error hold the truth (docs/results/coverage.md), and writes
// the page's figure:   coverage_table EXACT_FAMILIES.csv [FIGURE.svg]
#include <fmt/format.h>
#include <fmt/ranges.h>

#include <cmath>
#include <exception>
#include <fstream>

#include "compare/report/report_table.h"
#include "compare/report/page.h"
#include "compare/report/svg_plot.h"
#include "tests/verification/uncertainty/coverage.h"

namespace tw::test {
namespace {

constexpr int repetitions = 40;
constexpr unsigned seed = 1;

struct Part {
    std::string name;
    std::function<bool(const Estimated&)> which;
};

ReportTable table_of(const std::string& title, const std::vector<Estimated>& all, const std::vector<Part>& parts) {
    ReportTable table{title, {words("families"), numbers("number")}};
    for (const Estimator& e : estimators) table.columns.push_back(words(e.name));
    for (const Part& part : parts) {
        ReportRow row{{part.name, coverage_of(all, estimators[0], part.which).families}};
        for (const Estimator& e : estimators) {
            const Coverage c = coverage_of(all, e, part.which);
            row.cells.emplace_back(
                c.given == 0
                    ? "–"
                    : fmt::format("{:.0f} %, ± {:.2g} %{}", c.share_held(), c.median_width(),
                                  c.given < c.families ? fmt::format(" ({:.0f} % given)", c.share_given()) : ""));
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

std::vector<Part> parts_of_manufactured() {
    std::vector<Part> parts{{"all", [](const Estimated&) { return true; }}};
    for (const double noise : {0.0, 0.1, 0.3, 1.0, 3.0})
        parts.push_back(
            {fmt::format("noise {:g}", noise), [=](const Estimated& e) { return e.family.noise == noise; }});
    for (const char* trend : {"h", "h^1.5", "h^2", "h and h^2", "2h - h^2/4", "oscillation", "none"})
        parts.push_back({fmt::format("trend {}", trend), [=](const Estimated& e) { return e.family.trend == trend; }});
    for (const std::size_t n : {3u, 4u, 5u, 6u, 8u})
        parts.push_back({fmt::format("{} sizes", n), [=](const Estimated& e) { return e.family.levels.size() == n; }});
    return parts;
}

/// What more sizes are worth: of ratios 2^(k/2), at a cost that goes with h^-4.
ReportTable table_of_more_sizes() {
    ReportTable table{"More sizes, 2^(k/2)",
                      {words("k"), numbers("cost"), words("noise 0"), words("0.3"), words("1"), words("3")}};
    const std::vector<std::vector<double>> exponents{{0, 1, 2},
                                                     {0, 1, 1.5, 2},
                                                     {0, 1, 4. / 3, 5. / 3, 2},
                                                     {0, 1, 2, 2.5, 3},
                                                     {0, 1, 1.5, 2, 3},
                                                     {0, 0.5, 1, 1.5, 2},
                                                     {0, 1, 2, 3},
                                                     {0, 1, 1.5, 2, 2.5, 3},
                                                     {0, 0.5, 1, 1.5, 2, 2.5, 3},
                                                     {-1, 0, 1, 2, 3},
                                                     {0, 1, 2, 3, 4},
                                                     {0, 1, 2, 2.5, 3, 3.5, 4},
                                                     {0, 1, 1.5, 2, 2.5, 3, 3.5, 4}};
    for (const std::vector<double>& ks : exponents) {
        std::vector<double> x;
        double cost = 0;
        for (const double k : ks) x.push_back(std::pow(2, k / 2)), cost += std::pow(2, -2 * k);
        const std::vector<Estimated> all = estimate_all(manufactured_families(repetitions, seed, {x}));
        ReportRow row{{fmt::format("{:.2g}", fmt::join(ks, ", ")), fmt::format("{:.2f}", cost)}};
        for (const double noise : {0.0, 0.3, 1.0, 3.0}) {
            const Coverage c =
                coverage_of(all, estimators[0], [&](const Estimated& e) { return e.family.noise == noise; });
            row.cells.emplace_back(fmt::format("{:.0f} %, ± {:.2g} %", c.share_held(), c.median_width()));
        }
        table.rows.push_back(std::move(row));
    }
    return table;
}

ReportTable exact_table(const std::vector<Estimated>& exact) {
    ReportTable table{"Exact cases, in per cent of the exact value",
                      {words("case"), numbers("sizes"), numbers("error"), numbers("U", "", 2), words("class"),
                       words("held"), numbers("Eca & Hoekstra", "", 2), numbers("GCI", "", 2)}};
    for (const Estimated& e : exact)
        table.rows.push_back({{e.family.name, e.family.levels.size(), e.estimate.levels[0].value - e.family.truth,
                               e.estimate.uncertainty, to_string(e.estimate.convergence),
                               !std::isfinite(e.estimate.uncertainty)   ? "no interval"
                               : holds_truth(e, e.estimate.uncertainty) ? "yes"
                                                                        : "**no**",
                               e.estimate.eca_hoekstra.uncertainty, e.estimate.celik_gci.uncertainty}});
    return table;
}

/// Coverage and median width over the noise.
std::string figure(const std::vector<Estimated>& all) {
    Plot held{.title = "How often the 95 % interval holds the truth",
              .x_label = "noise over the finest error",
              .y_label = "%",
              .levels = {{"95 %", 95}}};
    Plot width{.title = "Median half width",
               .x_label = "noise over the finest error",
               .y_label = "% of the value",
               .log_y = true};
    for (std::size_t k = 0; k < estimators.size(); ++k) {
        PlotLine a;
        a.name = estimators[k].name, a.source = k, a.points = true;
        PlotLine b = a;
        for (const double noise : {0.0, 0.1, 0.3, 1.0, 3.0}) {
            const Coverage c =
                coverage_of(all, estimators[k], [&](const Estimated& e) { return e.family.noise == noise; });
            a.x.push_back(noise), a.y.push_back(c.share_held());
            b.x.push_back(noise), b.y.push_back(c.median_width());
        }
        held.lines.push_back(a), width.lines.push_back(b);
    }
    return fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 640 620\" width=\"640\" "
        "height=\"620\"><style>{}</style>"
        "<rect width=\"640\" height=\"620\" style=\"fill:var(--bg)\"/><svg width=\"640\" height=\"300\">{}</svg>"
        "<svg y=\"315\" width=\"640\" height=\"300\">{}</svg></svg>\n",
        report_style, svg(held), svg(width));
}

int print(int count, char** words) {
    if (count < 2 || count > 3) {
        fmt::print(stderr, "coverage_table EXACT_FAMILIES.csv [FIGURE.svg]\n");
        return 2;
    }
    const std::vector<Estimated> manufactured = estimate_all(manufactured_families(repetitions, seed)),
                                 exact = estimate_all(exact_families(words[1]));
    fmt::print("{}\n", text_of(table_of("Manufactured families", manufactured, parts_of_manufactured())));
    fmt::print("{}\n", text_of(table_of_more_sizes()));
    const auto sizes = [](std::size_t low, std::size_t high) {
        return [=](const Estimated& e) { return e.family.levels.size() >= low && e.family.levels.size() <= high; };
    };
    fmt::print("{}\n", text_of(table_of("Exact cases", exact,
                                        {{"two sizes", sizes(2, 2)},
                                         {"three", sizes(3, 3)},
                                         {"four, five", sizes(4, 5)},
                                         {"three and more", sizes(3, 9)}})));
    fmt::print("{}", text_of(exact_table(exact)));
    if (count == 3) {
        std::ofstream file(words[2]);
        if (!(file << figure(manufactured))) {
            fmt::print(stderr, "{}: cannot be written\n", words[2]);
            return 2;
        }
    }
    return 0;
}

}  // namespace
}  // namespace tw::test

int main(int count, char** words) {
    try {
        return tw::test::print(count, words);
    } catch (const std::exception& e) {
        fmt::print(stderr, "{}\n", e.what());
        return 2;
    }
}
