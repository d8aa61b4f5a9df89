#include <gtest/gtest.h>

#include <cmath>
#include <cstdio>
#include <numbers>

#include "structure/equilibrium.h"
#include "structure/generate.h"
#include "structure/solid/plane_contact.h"
#include "structure/tyre_static.h"

namespace tw::structure {
namespace tyre_press_test {
using Eigen::VectorXd;

std::vector<Hyperelastic> calibrated() {
    std::vector<Hyperelastic> rubbers;
    for (const Vec3& c : {assumed_inner_tyre, calibrated_sidewall, calibrated_tread})
        rubbers.push_back(Hyperelastic::mooney_rivlin(c[0], c[1], c[2], 1100));
    return rubbers;
}

/// A cube that a pressure on its top presses on the plane: the plane bears the load, and the bottom stands p / k in it.
TEST(PlaneContact, BearsTheLoadAtTheDepthThatItsStiffnessSays) {
    const double p = 1e4, k = 1e9;
    const Solid cube(block_mesh({3, 3, 3}, [](const Vec3& at) { return Vec3(0.1 * at); }),
                     {Hyperelastic::neo_hookean(1e6, 0.0, 1000)});
    const PlaneContact plane(cube, "z_min", 0, k);
    DegreesOfFreedom f(cube.mesh().nodes, 3);
    for (int n = 0; 3 * n < cube.dofs(); ++n) f.hold(std::vector{n}, {0, 1});
    VectorXd start = VectorXd::Zero(cube.dofs());
    for (int n = 0; 3 * n < cube.dofs(); ++n) start[3 * n + 2] = -1e-6;
    const VectorXd u =
        equilibrium(start, f.basis(),
                    {[&](const VectorXd& at) -> VectorXd {
                         return cube.pressure_load(at, "z_max", p) + plane.force(at) - cube.internal_force(at);
                     },
                     [&](const VectorXd& at) -> SparseMatrix {
                         return cube.tangent(at) + plane.tangent(at) - cube.pressure_tangent(at, "z_max", p);
                     }},
                    1e-9);
    EXPECT_NEAR(plane.total(u), p * 0.01, 1e-6 * p * 0.01);
    EXPECT_NEAR(plane.energy(u), p * p / k / 2 * 0.01, 1e-6 * p * p / k / 2 * 0.01);
    EXPECT_NEAR(u[2], -p / k, 1e-9);
    EXPECT_EQ(plane.force(VectorXd::Zero(cube.dofs())).norm(), 0) << "a body that only touches is not pushed";
}

/// Blown up alike all round is blown up in balance: nothing of the whole tyre is out of balance but its rim.
TEST(TyreStatic, BlownUpOfOneSectionIsInBalanceAllRound) {
    Tyre t;
    t.around = 16, t.across = 12;
    const double p = 1.38e5;
    const Solid s(tyre_mesh(t), calibrated());
    const VectorXd u = blown_up(t, calibrated(), p);
    DegreesOfFreedom f(s.mesh().nodes, 3);
    f.clamp(s.mesh().sets.at("rim"));
    const VectorXd load = s.pressure_load(u, "inside", p);
    EXPECT_LT((f.basis().transpose() * VectorXd(load - s.internal_force(u))).norm(), 1e-6 * load.norm());
    EXPECT_GT(u.maxCoeff(), 1e-3) << "or nothing was blown up";
}

/// The study's static test, and the one number that the rubber was calibrated on: 800 N press it 10 mm flat.
TEST(TyreStatic, EightHundredNewtonsPressTheCalibratedTyreTenMillimetres) {
    const Tyre t;
    std::vector<double> deflections;
    for (const int mm : {4, 7, 10}) deflections.push_back(1e-3 * mm);
    const std::vector<Pressed> rows = press(t, calibrated(), 1.38e5, 1e10, deflections);
    for (const Pressed& row : rows)
        std::printf("tyre pressed %.0f mm: %.1f N, contact %.0f mm long\n", 1e3 * row.deflection, row.load,
                    1e3 * row.patch);
    EXPECT_NEAR(rows.back().load, 800, 8);
    for (std::size_t k = 1; k < rows.size(); ++k) EXPECT_GT(rows[k].load, rows[k - 1].load);
    const double soft = press(t, calibrated(), 1.38e5, 1e9, deflections).back().load;
    std::printf("tyre pressed 10 mm on a plane a tenth as stiff: %.1f N\n", soft);
    EXPECT_NEAR(soft, rows.back().load, 0.03 * rows.back().load);
    EXPECT_LT(soft, rows.back().load);
}

}  // namespace tyre_press_test
}  // namespace tw::structure
