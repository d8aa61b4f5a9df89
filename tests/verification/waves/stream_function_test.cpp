// Steady waves against tables of another program of the same method, itself checked against published values
// (tests/data/README.md): 58 waves, kd 0.5 to deep, up to 88 % of the highest.
#include "waves/stream_function.h"

#include <gtest/gtest.h>

#include <cmath>
#include <fstream>
#include <map>
#include <numbers>
#include <sstream>

#include "test_paths.h"
#include "waves/steepness.h"

namespace tw {
namespace stream_function_test {

using std::numbers::pi;

/// Rows of a table whose first column may be the word "deep".
std::vector<std::vector<double>> rows_of(const std::string& name) {
    std::ifstream file(std::string(TWINWAKE_TEST_DATA "/") + name);
    std::string line;
    std::getline(file, line);
    std::vector<std::vector<double>> rows;
    while (std::getline(file, line)) {
        std::vector<double>& row = rows.emplace_back();
        std::stringstream cells(line);
        for (std::string cell; std::getline(cells, cell, ',');)
            row.push_back(cell == "deep" ? HUGE_VAL : cell == "3.14159" ? pi : cell.empty() ? NAN : std::stod(cell));
    }
    return rows;
}

const SteadyWave& wave_of(double kd, double steepness) {
    static std::map<std::pair<double, double>, SteadyWave> known;
    const auto [at, is_new] = known.try_emplace({kd, steepness});
    if (is_new) at->second = steady_wave(kd, 2 * pi * steepness);
    return at->second;
}

TEST(SteadyWave, AgreesWithTheTableInAllSixDigits) {
    const auto rows = rows_of("fenton_waves.csv");
    ASSERT_EQ(rows.size(), 58U);
    for (const std::vector<double>& row : rows) {
        const SteadyWave& w = wave_of(row[0], row[1]);
        const auto same = [&](double found, std::size_t column) {
            EXPECT_NEAR(found / row[column], 1, 6e-6) << "kd " << row[0] << " H/L " << row[1] << " column " << column;
        };
        same(w.speed, 4);
        same(w.crest / w.height, 7);
        same(-w.trough / w.height, 8);
        same(w.flux, 16);
        same(w.bernoulli, 18);
    }
}

/// The table's own waves have 20 terms (28 at kd 0.5), the last of which carry what further ones would: where the last
/// are not small, the others are not exact.
TEST(SteadyWave, AgreesWithTheCoefficients) {
    std::map<std::pair<double, double>, double> last;
    const auto rows = rows_of("fenton_coefficients.csv");
    for (const std::vector<double>& row : rows) last[{row[0], row[1]}] = std::abs(row[4]);
    int compared = 0;
    for (const std::vector<double>& row : rows) {
        const SteadyWave& w = wave_of(row[0], row[1]);
        const auto j = static_cast<std::size_t>(row[2]);
        if (j > w.B.size() || j > 12) continue;
        const double share = std::max(std::abs(w.B[j - 1] - row[3]), std::abs(w.E[j - 1] - row[4])) / w.height;
        EXPECT_LT(share, std::max(1e-9, last.at({row[0], row[1]}) / w.height)) << row[0] << " " << row[1] << " " << j;
        ++compared;
    }
    EXPECT_GT(compared, 400);
}

TEST(SteadyWave, IsFoundUpToNineTenthsOfTheHighest) {
    for (const double kd : {0.2, 1.0, HUGE_VAL}) {
        const double length = 2 * pi, depth = std::min(kd, 100.0), height = 0.9 * highest_wave(length, depth);
        const SteadyWave w = steady_wave(kd, height);
        EXPECT_NEAR(w.crest - w.trough, height, 1e-9);
        // at the crest the water is still slower than the wave: Bernoulli's constant says how much
        EXPECT_GT(w.bernoulli, w.crest);
        EXPECT_LT(2 * (w.bernoulli - w.crest), 0.3 * w.speed * w.speed) << kd;
    }
    EXPECT_THROW(steady_wave(1, 1.2 * highest_wave(2 * pi, 1)), std::domain_error);
}

}  // namespace stream_function_test
}  // namespace tw
