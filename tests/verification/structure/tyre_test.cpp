#include "structure/tyre.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "structure/equilibrium.h"
#include "structure/solid/solid.h"

namespace tw::structure {
namespace tyre_test {

/// Assumed: the study prints no constants.
std::vector<Hyperelastic> rubbers() {
    return {Hyperelastic::neo_hookean(2e6, 0.49, 1000), Hyperelastic::mooney_rivlin(6e5, 1.5e5, 1e8, 1100),
            Hyperelastic::mooney_rivlin(8e5, 2e5, 1e8, 1150)};
}

/// A coarse one, blown up to the study's 0.138 MPa: it finds its balance, grows, and nothing pushes it anywhere.
TEST(Tyre, IsBlownUpByItsPressure) {
    Tyre t;
    t.around = 16;
    t.across = 12;
    t.through_rubber = 1;
    const Solid s(tyre_mesh(t), rubbers());
    DegreesOfFreedom f(s.mesh().nodes, 3);
    f.clamp(s.mesh().sets.at("rim"));
    const SparseMatrix T = f.basis();
    Eigen::VectorXd u = Eigen::VectorXd::Zero(s.dofs());
    for (int k = 1; k <= 4; ++k) {
        const double p = 1.38e5 * k / 4;
        u = equilibrium(u, T,
                        {[&](const Eigen::VectorXd& at) -> Eigen::VectorXd {
                             return s.pressure_load(at, "inside", p) - s.internal_force(at);
                         },
                         [&](const Eigen::VectorXd& at) -> SparseMatrix {
                             return s.tangent(at) - s.pressure_tangent(at, "inside", p);
                         }},
                        1e-6);
    }
    double before = 0, after = 0;
    for (int n = 0; 3 * n < s.dofs(); ++n) {
        const Vec3 X = s.mesh().nodes[static_cast<std::size_t>(n)], x = X + u.segment<3>(3 * n);
        before = std::max(before, std::hypot(X.x(), X.z()));
        after = std::max(after, std::hypot(x.x(), x.z()));
    }
    std::printf("tyre: outer radius %.1f mm, blown up %.1f mm\n", 1e3 * before, 1e3 * after);
    EXPECT_GT(after, before + 0.001);
    EXPECT_LT(after, 1.3 * before);
    Vec3 sum = Vec3::Zero();
    const Eigen::VectorXd f_inside = s.pressure_load(u, "inside", 1.38e5);
    for (int n = 0; 3 * n < s.dofs(); ++n) sum += f_inside.segment<3>(3 * n);
    EXPECT_LT(sum.norm(), 1e-6 * f_inside.norm());
}

}  // namespace tyre_test
}  // namespace tw::structure
