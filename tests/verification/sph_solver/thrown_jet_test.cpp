// A jet of known thickness and speed that flies as a parabola, and the splash height that the report gives of it. A
// slab of water of depth H and speed U runs up a ramp of angle alpha and length l, whose edge it leaves
// (studies/thrown_jet.toml).
//
//   q = U H, E = U^2/2 + g H; at the edge, z_e = l sin(alpha) high:   V^2 = 2 (E - g (z_e + h cos(alpha))), h = q / V
//   along the ramp           u_s = V + g_n h / (2 V),   g_n = g cos(alpha)       (its pressure becomes speed)
//   normal to it             u_n = -(2 ln 2 / pi) g_n h / V - V d                (first order in g_n h / V^2)
//   direction, weightless    alpha - d = (2 alpha / pi) atan(sqrt(b - 1))
//                            l / H = (1/pi) int_1^b ((xi + xi_1)/(xi - xi_1))^(alpha/pi) dt/t,
//                            xi = sqrt(t / (b - t)), xi_1 = 1 / sqrt(b - 1)
//   apex                     u_x = u_s cos(alpha) - u_n sin(alpha) stays;  top = (E - u_x^2/2) / g + q / (2 u_x)
//
// Heights above the floor. Free streamlines: docs/theory.md. The neglected part is of the order of (g H / U^2)^2, 0.1
// %.
#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>

#include "base/atomic_file.h"
#include "compare/compare.h"
#include "tests/run_of.h"
#include "test_paths.h"

namespace tw {
namespace thrown_jet_test {

using std::numbers::pi;

constexpr double H = 0.03, U = 3.5, g = 9.81, alpha = pi / 4, edge = 0.085, l = edge * std::numbers::sqrt2;

/// l / H of the ramp whose edge is at t = b (corner at t = 1), by the midpoint rule in s, xi = xi_1 exp(s^m): no
/// singularity is left at the corner.
double length_of(double b) {
    const double xi_1 = 1 / std::sqrt(b - 1), m = 1 / (1 - alpha / pi), last = std::pow(40, 1 / m);
    constexpr int parts = 4000;
    double sum = 0;
    for (int k = 0; k < parts; ++k) {
        const double s = (k + 0.5) * last / parts, y = std::pow(s, m), xi = xi_1 * std::exp(y);
        sum += std::pow((xi + xi_1) / (xi - xi_1), alpha / pi) * 2 / (1 + xi * xi) * m * std::pow(s, m - 1);
    }
    return sum * last / parts / pi;
}

/// By how much the ramp of this length falls short of turning the weightless slab by alpha [rad].
double shortfall(double length) {
    double low = 0, high = 30;  // of ln(b - 1)
    for (int i = 0; i < 50; ++i) {
        const double middle = 0.5 * (low + high);
        (length_of(1 + std::exp(middle)) < length ? low : high) = middle;
    }
    return alpha - 2 * alpha / pi * std::atan(std::exp(0.5 * low));
}

/// Of the jet's upper surface above the floor [m].
double apex() {
    const double q = U * H, E = U * U / 2 + g * H, g_n = g * std::cos(alpha);
    double h = H, V = U;
    for (int i = 0; i < 50; ++i) V = std::sqrt(2 * (E - g * (edge + h * std::cos(alpha)))), h = q / V;
    const double u_s = V + g_n * h / (2 * V), u_n = -2 * std::log(2.0) / pi * g_n * h / V - V * shortfall(l / H);
    const double u_x = u_s * std::cos(alpha) - u_n * std::sin(alpha);
    return (E - u_x * u_x / 2) / g + q / (2 * u_x);
}

/// Where the slab's water would rest in a tank 3.9 m long, beside the ramp and its mirror image behind the edge.
double still_level() {
    const double room = 3.9 - 2 * edge, water = 2.3 * H;  // room z + z^2 = water
    return 0.5 * (std::sqrt(room * room + 4 * water) - room);
}

TEST(ThrownJet, AShortRampTurnsTheSlabByLess) {
    EXPECT_LT(shortfall(4), 0.003);
    EXPECT_GT(shortfall(1), 0.15) << "10 degrees";
}

TEST(ThrownJet, TheReportsSplashHeightIsTheApexOfTheParabola) {
    const std::string scene = read_text(TWINWAKE_SOURCE "/studies/thrown_jet.toml");
    const RunRecord record = run_of(scene, "thrown_jet");
    ASSERT_EQ(record.state, "finished") << record.reason;
    const Comparison report = compare_records({record});
    const Quantity* splash = report.find("splash_sheet_height");
    ASSERT_TRUE(splash && splash->values.at(0).known);
    const double exact = apex() - still_level(), found = splash->values[0].value;
    std::printf("thrown jet, 3 spacings deep: apex %.4f m above still water (%+.1f %%)\n", found,
                100 * (found / exact - 1));
    EXPECT_NEAR(exact, 0.3728, 0.0005) << "as the study and its page say";
    EXPECT_NEAR(found, exact, 0.05 * exact);
}

}  // namespace thrown_jet_test
}  // namespace tw
