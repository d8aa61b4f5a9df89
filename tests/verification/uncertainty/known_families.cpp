#include "tests/verification/uncertainty/known_families.h"

#include <cmath>
#include <functional>
#include <random>
#include <stdexcept>

#include "base/atomic_file.h"
#include "text/csv_columns.h"

namespace tw::test {

namespace {

struct Trend {
    std::string name;
    std::function<double(double x, int i)> f;
};

const std::vector<Trend> trends{
    {"h", [](double x, int) { return x; }},
    {"h^1.5", [](double x, int) { return std::pow(x, 1.5); }},
    {"h^2", [](double x, int) { return x * x; }},
    {"h and h^2", [](double x, int) { return (x + x * x) / 2; }},
    {"2h - h^2/4", [](double x, int) { return 2 * x - x * x / 4; }},
    {"oscillation", [](double x, int i) { return i % 2 ? -x : x; }},
    {"none", [](double, int) { return 0.0; }},
};

const double root2 = std::sqrt(2.0);
const std::vector<std::vector<double>> usual_sizes{
    {1, root2, 2},
    {1, root2, 2, 2 * root2},
    {1, 1.25, 1.5, 2, 2.5},
    {1, 1.25, 1.5, 1.9, 2.4, 3},
    {1, 40 / 28.0, 40 / 24.0, 2, 40 / 18.0, 2.5, 40 / 14.0, 40 / 12.0},
};

}  // namespace

std::vector<KnownFamily> manufactured_families(int repetitions, unsigned seed) {
    return manufactured_families(repetitions, seed, usual_sizes);
}

std::vector<KnownFamily> manufactured_families(int repetitions, unsigned seed,
                                               const std::vector<std::vector<double>>& sizes, bool known) {
    constexpr double error = 0.02;
    std::mt19937 random(seed);
    std::normal_distribution<double> normal;
    std::vector<KnownFamily> families;
    for (const Trend& trend : trends)
        for (const double noise : {0.0, 0.1, 0.3, 1.0, 3.0})
            for (const bool grows : {false, true})
                for (const std::vector<double>& x : sizes)
                    for (int r = 0; r < (noise > 0 ? repetitions : 1); ++r) {
                        if (noise == 0 && (grows || trend.name == "none")) continue;
                        KnownFamily family{.name = {}, .trend = trend.name, .noise = noise, .levels = {}, .truth = 1};
                        for (std::size_t i = 0; i < x.size(); ++i) {
                            const double deviation = noise * (grows ? x[i] : 1), e = deviation * normal(random);
                            family.levels.push_back({x[i], 1 + error * (trend.f(x[i], static_cast<int>(i)) + e),
                                                     known ? 1.96 * error * deviation : 0});
                        }
                        families.push_back(std::move(family));
                    }
    return families;
}

std::vector<KnownFamily> exact_families(const std::filesystem::path& csv) {
    const CsvColumns table(read_text(csv), csv.string());
    const std::vector<std::string> names = table.texts("quantity");
    const auto &spacings = table.values("spacings"), &values = table.values("value"), &exact = table.values("exact");
    std::vector<KnownFamily> families;
    for (std::size_t i = 0; i < table.rows(); ++i) {
        if (families.empty() || families.back().name != names[i])
            families.push_back({.name = names[i], .trend = {}, .noise = 0, .levels = {}, .truth = exact[i]});
        families.back().levels.push_back({1 / spacings[i], values[i]});
    }
    return families;
}

}  // namespace tw::test
