#include <gtest/gtest.h>

#include "structure/solid/solid.h"
#include "structure/tyre_static.h"
namespace tw::structure {
namespace {
TEST(TyreTry, Table) {
    Tyre t;
    t.around = std::atoi(getenv("AROUND")), t.across = std::atoi(getenv("ACROSS")), t.through_rubber = std::atoi(getenv("THROUGH"));
    const double f = std::atof(getenv("F")), k = std::atof(getenv("K")), b=std::atof(getenv("B"));
    std::vector<Hyperelastic> r{Hyperelastic::neo_hookean(2e6, 0.49, 1000), Hyperelastic::mooney_rivlin(f*6e5, f*1.5e5, b, 1100),
            Hyperelastic::mooney_rivlin(f*8e5, f*2e5, b, 1150)};
    Eigen::VectorXd u = blown_up(t, r, 1.38e5);
    std::printf("blown up by %g mm\n", 1e3 * u.maxCoeff());
    std::vector<double> d;
    for (int i = 1; i <= 12; ++i) d.push_back(i * 1e-3);
    for (const Pressed& p : press(t, r, 1.38e5, k, d)) std::printf("%g mm %g N %g mm\n", 1e3 * p.deflection, p.load, 1e3 * p.patch);
}
}
}
