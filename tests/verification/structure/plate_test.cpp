#include "plate.h"
#include "base/numbers.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tw::structure {
namespace plate_test {

/// Thin (a/1000), so that the exact answers of the Kirchhoff plate hold.
constexpr double E = 7e10, nu = 0.3, rho = 2700, t = 1e-3, D = E * t * t * t / (12 * (1 - nu * nu));
Laminate sheet(double thickness = t) { return Laminate({{isotropic(E, nu, rho), 0, thickness}}); }

/// The lowest frequencies as omega a^2 sqrt(rho h / D).
Eigen::VectorXd frequencies(const std::string& edges, int cells, int count) {
    const Shell plate = square_plate(cells, sheet());
    const DegreesOfFreedom f = supported(plate, edges);
    const SparseMatrix T = f.basis();
    return lowest_modes(reduced(plate.stiffness(), T), reduced(f.mass(plate.mass()), T), count).omega *
           std::sqrt(rho * t / D);
}

struct Plate {
    std::string edges;
    std::vector<double> exact;
};

/// SSSS: pi^2 (m^2 + n^2). The others: Ritz's method with 14 x 14 beam functions or polynomials (changes by less than
/// 8e-5 from 12 x 12), nu = 0.3; Leissa 1973, doi:10.1016/S0022-460X(73)80371-2, prints the same to four digits.
const Plate plates[] = {
    {"SSSS", {2 * pi * pi, 5 * pi* pi, 5 * pi* pi, 8 * pi* pi}},
    {"CCCC", {35.9851911, 73.3938457, 73.3938457, 108.216503}},
    {"CFFF", {3.47106857, 8.50671176, 21.285002, 27.1988896}},
    {"CFCF", {22.1666569, 26.4050358, 43.5942625, 61.1730871}},
};

TEST(Plates, VibrateWithinOnePercentOnTwentyByTwentyAndConvergeWithSecondOrder) {
    for (const Plate& p : plates) {
        const int count = static_cast<int>(p.exact.size());
        const Eigen::VectorXd coarse = frequencies(p.edges, 10, count), fine = frequencies(p.edges, 20, count);
        for (int k = 0; k < count; ++k) {
            const double exact = p.exact[static_cast<std::size_t>(k)];
            const double error = fine[k] / exact - 1,
                         order = std::log2(std::abs(coarse[k] / exact - 1) / std::abs(error));
            std::printf("%s mode %d: %9.4f against %9.4f, %+.3f %%, order %.2f\n", p.edges.c_str(), k + 1, fine[k],
                        exact, 100 * error, order);
            // The fourth mode has two waves of bending across the plate, ten cells each.
            EXPECT_LT(std::abs(error), k < 3 ? 0.01 : 0.0125) << p.edges << k;
            // Lumped masses lower a frequency and stiff elements raise it: near where the two cancel there is no order.
            EXPECT_TRUE(order > 1.7 || std::abs(error) < 0.001) << p.edges << k;
        }
    }
}

/// Centre deflection under unit pressure over a^4 / D.
double deflection(const std::string& edges, int cells, double thickness = t) {
    const Shell plate = square_plate(cells, sheet(thickness));
    const Eigen::VectorXd p = Eigen::VectorXd::Constant(static_cast<int>(plate.elements().size()), -1);
    const Eigen::VectorXd u = solved(plate, supported(plate, edges), plate.pressure_load(p));
    return u[6 * nearest_node(plate.mesh().nodes, Vec3(0.5, 0.5, 0)) + 2] * D * std::pow(thickness / t, 3);
}

/// Timoshenko & Woinowsky-Krieger 1959; the clamped one by Ritz's method with more digits.
TEST(Plates, BendUnderPressureWithinOnePercentAndConvergeWithSecondOrder) {
    for (const auto& [edges, exact] : {std::pair{"SSSS", 0.00406235266}, std::pair{"CCCC", 0.00126531909}}) {
        const double coarse = deflection(edges, 10) / exact - 1, fine = deflection(edges, 20) / exact - 1;
        std::printf("%s: %+.4f %% on 10 x 10, %+.4f %% on 20 x 20, order %.2f\n", edges, 100 * coarse, 100 * fine,
                    std::log2(coarse / fine));
        EXPECT_LT(std::abs(fine), 0.01) << edges;
        EXPECT_GT(std::log2(coarse / fine), 1.7) << edges;
    }
}

TEST(Plates, DoNotLockHoweverThinTheyAre) {
    const double thin = deflection("CCCC", 10, 1e-3);
    for (const double thickness : {1e-4, 1e-5, 1e-6}) EXPECT_NEAR(deflection("CCCC", 10, thickness) / thin, 1, 1e-4);
    // A thick plate gives way in shear as well, so the thickness does reach the element.
    EXPECT_GT(deflection("CCCC", 10, 0.1) / thin, 1.1);
}

/// First-order theory itself, on a thick plate (a/10): w = sum of sine waves with the shear compliance (Reddy 2004,
/// 5.2).
TEST(Plates, OfModerateThicknessGiveWayInShear) {
    const double h = 0.1, Dh = D * 1e6, S = 5.0 / 6 * E / (2 * (1 + nu)) * h;
    double exact = 0;
    for (int m = 1; m < 200; m += 2)
        for (int n = 1; n < 200; n += 2) {
            const double k2 = pi * pi * (m * m + n * n), q = 16 / (pi * pi * m * n);
            exact += q * (1 / (Dh * k2 * k2) + 1 / (S * k2)) * std::sin(m * pi / 2) * std::sin(n * pi / 2);
        }
    const double w = deflection("SSSS", 20, h) / Dh;
    std::printf("thick: %.4f of Mindlin's, %.4f of Kirchhoff's\n", w / exact, w / (0.00406235266 / Dh));
    EXPECT_NEAR(w / exact, 1, 0.005);
    EXPECT_GT(w / (0.00406235266 / Dh), 1.04);
}

}  // namespace plate_test
}  // namespace tw::structure
