#include <gtest/gtest.h>

#include <cmath>

#include "base/numbers.h"
#include "meshes/generate.h"
#include "motion/rigid_mass.h"

namespace tw {
namespace rigid_mass_test {

void expect_within(const Vec3& got, const Vec3& exact, double share) {
    for (int a = 0; a < 3; ++a) EXPECT_NEAR(got[a] / exact[a], 1, share) << "axis " << a;
}

TEST(RigidMass, OfABoxACylinderAndASphereAreTheFormulasWithinHalfAPercent) {
    {
        const RigidMass m = solid_mass(make_hull("box", {{"length", 2}, {"beam", 0.5}, {"height", 0.25}}), 800);
        EXPECT_NEAR(m.mass, 800 * 0.25, 1e-9);
        expect_within(m.inertia.diagonal(), 200.0 / 12 * Vec3(0.25 + 0.0625, 4 + 0.0625, 4 + 0.25), 1e-12);
    }
    {
        const double r = 0.025, l = 0.2, mass = 1370 * pi * r * r * l;
        const RigidMass m = solid_mass(make_hull("cylinder", {{"diameter", 2 * r}, {"span", l}}), 1370);
        EXPECT_NEAR(m.mass / mass, 1, 5e-3);
        const double across = mass * (3 * r * r + l * l) / 12;
        expect_within(m.inertia.diagonal(), Vec3(across, mass * r * r / 2, across), 5e-3);
        EXPECT_LT((m.centre - Vec3(0, 0, r)).norm(), 1e-5 * r);
    }
    {
        const double r = 0.5, mass = 500 * 4 * pi / 3 * r * r * r;
        const RigidMass m = solid_mass(make_hull("sphere", {{"diameter", 2 * r}}), 500);
        EXPECT_NEAR(m.mass / mass, 1, 5e-3);
        expect_within(m.inertia.diagonal(), Vec3::Constant(0.4 * mass * r * r), 5e-3);
    }
}

TEST(RigidMass, AboutAnotherCentreFollowsTheParallelAxisTheorem) {
    const RigidMass at_centroid = solid_mass(make_hull("box", {{"length", 1}, {"beam", 1}, {"height", 1}}), 600);
    const RigidMass aside =
        with_centre(with_centre(at_centroid, at_centroid.centre + Vec3(0.3, 0, 0)), at_centroid.centre);
    // there and back again: each step takes m d^2 from the two axes across the shift
    EXPECT_NEAR(aside.inertia(0, 0), at_centroid.inertia(0, 0), 1e-9);
    EXPECT_NEAR(aside.inertia(1, 1), at_centroid.inertia(1, 1) - 2 * 600 * 0.09, 1e-9);
}

TEST(RigidMass, ThatNoBodyCanHaveIsNamed) {
    const RigidMass box = solid_mass(make_hull("box", {}), 1000);
    EXPECT_EQ(impossible(box), "");
    RigidMass bad = box;
    bad.mass = 0;
    EXPECT_EQ(impossible(bad), "a mass of 0 kg");
    bad.mass = -3;
    EXPECT_EQ(impossible(bad), "a mass of -3 kg");
    bad = box;
    bad.inertia = Vec3(1, 1, 2.1).asDiagonal();
    EXPECT_NE(impossible(bad).find("larger than the sum"), std::string::npos);
    bad.inertia = Vec3(1, 1, 2).asDiagonal();  // a thin plate
    EXPECT_EQ(impossible(bad), "");
    bad.inertia = Vec3(1, -1, 1).asDiagonal();
    EXPECT_NE(impossible(bad).find("not positive"), std::string::npos);
}

}  // namespace rigid_mass_test
}  // namespace tw
