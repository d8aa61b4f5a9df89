#include <gtest/gtest.h>

#include <cmath>

#include "base/numbers.h"
#include "plate.h"
#include "structure/shell/gauge.h"

namespace tw::structure {
namespace laminate_plate_test {

/// Graphite-epoxy ratios of the literature's plates: E1/E2 = 25, G12 = G13 = E2/2, G23 = E2/5, nu12 = 1/4.
const PlyMaterial ply{25e9, 1e9, 0.25, 0.5e9, 0.5e9, 0.2e9, 1600};

Laminate cross_ply(double thickness) {
    std::vector<Ply> stack;
    for (const double degrees : {0., 90., 90., 0.}) stack.push_back({ply, degrees * pi / 180, thickness / 4});
    return Laminate(stack);
}

/// A simply supported cross-ply plate under q0 sin(pi x) sin(pi y): w = W sin sin, theta_y = X cos(pi x) sin(pi y),
/// -theta_x = Y sin(pi x) cos(pi y) solve first-order theory exactly (Navier; Reddy 2004, 7.2). Returns (W, X, Y).
Vec3 navier(const Laminate& l, double q0) {
    const auto& D = l.D();
    const double a = pi, S1 = l.S()(0, 0), S2 = l.S()(1, 1);
    Eigen::Matrix3d K;
    K << (S1 + S2) * a * a, S1 * a, S2 * a,                                           //
        S1 * a, D(0, 0) * a * a + D(2, 2) * a * a + S1, (D(0, 1) + D(2, 2)) * a * a,  //
        S2 * a, (D(0, 1) + D(2, 2)) * a * a, D(2, 2) * a * a + D(1, 1) * a * a + S2;
    return K.inverse() * Vec3(q0, 0, 0);
}

Eigen::VectorXd bent(const Shell& plate) {
    const int elements = static_cast<int>(plate.elements().size());
    Eigen::VectorXd p(elements);
    for (int e = 0; e < elements; ++e) {
        const Vec3 c = plate.elements()[static_cast<std::size_t>(e)].centre();
        p[e] = -std::sin(pi * c.x()) * std::sin(pi * c.y());
    }
    return solved(plate, supported(plate, "SSSS"), plate.pressure_load(p));
}

TEST(CrossPlyPlate, BendsAsNaviersSolutionSays) {
    for (const double thickness : {0.01, 0.1}) {
        const Laminate l = cross_ply(thickness);
        const double exact = navier(l, 1)[0];
        double error[2];
        for (int k = 0; k < 2; ++k) {
            const Shell plate = square_plate(10 << k, l);
            error[k] = bent(plate)[6 * nearest_node(plate.mesh().nodes, Vec3(0.5, 0.5, 0)) + 2] / exact - 1;
        }
        std::printf("thickness %.2f: %+.4f %% on 10 x 10, %+.4f %% on 20 x 20\n", thickness, 100 * error[0],
                    100 * error[1]);
        EXPECT_LT(std::abs(error[1]), 0.01);
        EXPECT_LT(std::abs(error[1]), 0.35 * std::abs(error[0]));
    }
}

/// Reddy 2004, Table 7.2.2 (first-order theory, k = 5/6, the same stack): 100 w E2 h^3 / (q0 a^4) = 0.6627 at a/h = 10
/// and 0.4337 at 100.
TEST(CrossPlyPlate, HasTheDeflectionOfTheLiterature) {
    EXPECT_NEAR(navier(cross_ply(0.1), 1)[0] * 100 * 1e9 * 1e-3, 0.6627, 2e-4);
    EXPECT_NEAR(navier(cross_ply(0.01), 1)[0] * 100 * 1e9 * 1e-6, 0.4337, 2e-4);
}

TEST(CrossPlyPlate, GaugesAndPliesReadTheStrainsOfNaviersSolution) {
    const Laminate l = cross_ply(0.1);
    const Shell plate = square_plate(20, l);
    const Eigen::VectorXd u = bent(plate);
    const Vec3 exact = navier(l, 1);
    const Vec3 at(0.475, 0.525, 0);  // the middle of an element, where its strains are most accurate
    // u = z theta_y, v = -z theta_x; at a place: eps_xx = z kappa_xx, kappa_xx = -X pi sin sin.
    const double waves = std::sin(pi * at.x()) * std::sin(pi * at.y());
    const double eps_x = -0.05 * exact[1] * pi * waves, eps_y = -0.05 * exact[2] * pi * waves;
    const GaugeReader top(plate, {.name = "top", .position = at, .direction = Vec3::UnitX(), .top = true});
    const GaugeReader bottom(plate, {.name = "bottom", .position = at, .direction = Vec3::UnitX(), .top = false});
    const GaugeReader across(plate, {.name = "across", .position = at, .direction = Vec3::UnitY(), .top = true});
    EXPECT_NEAR(top.strain(u) / eps_x, 1, 0.01);
    EXPECT_NEAR(bottom.strain(u) / -eps_x, 1, 0.01);
    EXPECT_NEAR(across.strain(u) / eps_y, 1, 0.01);
    EXPECT_GT(std::abs(eps_x / eps_y - 1), 0.1);  // or the directions would not tell them apart

    // The middle layers lie at 90 degrees: their direction 1 is the plate's y. Top of layer 3 is z = h/4.
    const PlyState s = top.state(u, 2, 1);
    EXPECT_NEAR(s.strain[0] / (eps_y / 2), 1, 0.01);
    EXPECT_NEAR(s.strain[1] / (eps_x / 2), 1, 0.01);
    const double d = 1 - 0.25 * 0.25 / 25;
    EXPECT_NEAR(s.stress[0] / ((25e9 * eps_y / 2 + 0.25e9 * eps_x / 2) / d), 1, 0.01);
    // gamma_xz = w,x + theta_y, and direction 2 of a layer at 90 degrees is -x.
    const double gamma_xz = (exact[0] * pi + exact[1]) * std::cos(pi * at.x()) * std::sin(pi * at.y());
    EXPECT_NEAR(s.shear_strain[1] / -gamma_xz, 1, 0.02);
}

/// A clamped plate of [45/0/45/90]s, which bends and twists together, against another code: CalculiX 2.20 with 24 x 24
/// S8R elements of eight layers (frequencies: 16 x 16). That element is a solid one through the thickness, which shears
/// without the factor 5/6: its shear part of the thick plate's deflection is 5/6 of ours.
TEST(AngledPlate, BendsAndVibratesAsInAnotherCode) {
    const PlyMaterial tape{40e9, 10e9, 0.25, 4e9, 4e9, 3e9, 1500};
    const auto stack = [&](double thickness) {
        return Laminate(read_layup("[45 P/0 P/45 P/90 P]s", {{"P", {tape, 0, thickness / 8}}}));
    };
    for (const auto& [thickness, other] : {std::pair{0.01, 7.346147e-4}, std::pair{0.05, 6.378102e-6}}) {
        const Shell plate = square_plate(40, stack(thickness));
        const Eigen::VectorXd p = Eigen::VectorXd::Constant(1600, -1000);
        const double w = solved(plate, supported(plate, "CCCC"),
                                plate.pressure_load(p))[6 * nearest_node(plate.mesh().nodes, Vec3(0.5, 0.5, 0)) + 2];
        std::printf("[45/0/45/90]s, thickness %.2f: deflection %+.2f %% of the other code's\n", thickness,
                    100 * (w / other - 1));
        EXPECT_NEAR(w / other, 1, thickness < 0.02 ? 0.01 : 0.03);
    }
    const Shell plate = square_plate(40, stack(0.01));
    const DegreesOfFreedom f = supported(plate, "CCCC");
    const SparseMatrix T = f.basis();
    const Modes modes = lowest_modes(reduced(plate.stiffness(), T), reduced(f.mass(plate.mass()), T), 4);
    const double other[] = {61.28313, 112.8888, 135.1916, 175.2090};
    for (int k = 0; k < 4; ++k) {
        const double hertz = modes.omega[k] / (2 * pi);
        std::printf("mode %d: %.2f Hz, %+.2f %% of the other code's\n", k + 1, hertz, 100 * (hertz / other[k] - 1));
        EXPECT_NEAR(hertz / other[k], 1, 0.01);
    }
}

}  // namespace laminate_plate_test
}  // namespace tw::structure
