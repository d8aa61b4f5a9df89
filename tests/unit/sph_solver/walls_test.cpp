#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "meshes/generate.h"
#include "meshes/mass_properties.h"
#include "sph_solver/bodies/dummies.h"
#include "sph_solver/bodies/samples.h"
#include "sph_solver/ghosts/mirrors.h"

namespace tw {
namespace {

const Box everywhere{Vec3::Constant(-100), Vec3::Constant(100)};

TEST(Dummies, CarryTheVolumeOfASharpEdgedHull) {
    const Surface hull =
        posed(make_hull("prismatic", {{"length", 4}, {"beam", 1}, {"deadrise", 0.35}}), {.trim = 0.087, .draft = 0.2});
    const Dummies d = make_dummies(SurfaceQuery(hull), hull.bounds(), 0.1, 10, everywhere, 3);
    const double volume = std::accumulate(d.volumes.begin(), d.volumes.end(), 0.0);
    EXPECT_NEAR(volume / mass_properties(hull).volume, 1, 0.005);  // lattice cells alone would be off by the staircase
    Vec3 centroid = Vec3::Zero();
    for (std::size_t k = 0; k < d.places.size(); ++k) centroid += d.volumes[k] / volume * d.places[k];
    EXPECT_LT((centroid - mass_properties(hull).centroid).norm(), 0.005);
}

TEST(Dummies, FillOnlyTheDepthThatKernelsReach) {
    const Surface box = make_hull("box", {});
    const Box b = box.bounds();
    const double dp = b.size().minCoeff() / 20, depth = 4 * dp;
    const SurfaceQuery query(box);
    for (const Vec3& p : make_dummies(query, b, dp, depth, everywhere, 3).places) {
        EXPECT_LE(query.nearest(p).distance, 1e-9);
        EXPECT_GE(query.nearest(p).distance, -depth - 1e-9);
    }
}

TEST(SurfaceSamples, AddUpToTheAreaVectorsOfTheSurface) {
    const Surface sphere = make_hull("sphere", {});
    SurfaceSamples samples(sphere, 0.05, everywhere);
    double area = 0;
    Vec3 closed = Vec3::Zero();
    for (const Vec3& a : samples.area) area += a.norm(), closed += a;
    EXPECT_NEAR(area, mass_properties(sphere).area, 1e-9 * area);
    EXPECT_LT(closed.norm(), 1e-9 * area);
    EXPECT_EQ(samples.patches().triangles.size(), samples.area.size());
    // hydrostatic pressure on all of it: Archimedes
    samples.points.support.assign(samples.area.size(), 0.5f);
    for (const Vec3& p : samples.points.places) samples.points.p.push_back(static_cast<float>(-9810 * (p.z() - 10)));
    Vec3 moment;
    EXPECT_NEAR(samples.pressure_force(Vec3::Zero(), moment).z(), 9810 * mass_properties(sphere).volume,
                0.002 * 9810 * mass_properties(sphere).volume);
}

TEST(Mirrors, ACornerParticleHasSevenImages) {
    Mirrors mirrors;
    mirrors.on = {{{true, false}, {true, false}, {true, false}}};
    Particles p;
    p.add(0.1, 0.1, 0.1, 1, 0, 0, Kind::fluid);
    const Box domain{Vec3::Zero(), Vec3::Constant(10)};
    EXPECT_EQ(make_mirror_images(mirrors, domain, p, 0.2).size(), 7u);
    EXPECT_EQ(make_mirror_images(mirrors, domain, p, 0.05).size(), 0u);
}

TEST(Mirrors, AnImageIsAsFarBehindThePlaneAndMovesAgainstIt) {
    const Box domain{Vec3(-1, 0, -1), Vec3(1, 1, 1)};
    const Quanta quanta(Vec3::Zero(), 1e-6);
    const MirrorPlanes planes(domain, quanta);
    const MirrorImage low_y{0, 1 << 3};
    const PlaceRecord image = planes.place({100000, 250000, -3, 1}, low_y);
    EXPECT_EQ(image.x, 100000);
    EXPECT_EQ(image.y, -250000);
    const VelocityDensityRecord m = mirrored(VelocityDensityRecord{1, 2, 3, 4}, low_y);
    EXPECT_EQ(m.u, 1);
    EXPECT_EQ(m.v, -2);
    EXPECT_EQ(m.w, 3);
    EXPECT_EQ(m.drho, 4);
}

TEST(Mirrors, BehindAWallThatHoldsTheWaterEverythingMovesAgainstIt) {
    Mirrors mirrors;
    mirrors.on[0] = mirrors.on[2] = {true, true};
    mirrors.holding[2][0] = true;
    const VelocityDensityRecord water{1, 2, 3, 4};
    const auto seen = [&](std::uint16_t planes) {
        const VelocityDensityRecord m = mirrored_by_holding(water, MirrorImage{0, planes}, mirrors);
        return Vec3(m.u, m.v, m.w);
    };
    EXPECT_EQ(seen(1 << 6), Vec3(-1, -2, -3)) << "the floor holds";
    EXPECT_EQ(seen(2 << 6), Vec3(1, 2, -3)) << "the lid does not";
    EXPECT_EQ(seen(1), Vec3(-1, 2, 3)) << "nor does the side";
    EXPECT_EQ(seen(1 | 1 << 6), Vec3(1, -2, -3)) << "in their corner: the side's mirror image of the floor's";
}
TEST(Mirrors, AParticleThatCrossedAPlaneIsReturned) {
    Mirrors mirrors;
    mirrors.on = {{{false, false}, {true, true}, {false, false}}};
    Particles p;
    p.add(0, -0.02, 0, 1, 0, 0, Kind::fluid);
    p.v[0] = -3;
    EXPECT_EQ(return_from_mirrors(mirrors, {Vec3(-1, 0, -1), Vec3(1, 1, 1)}, p), 1);
    EXPECT_DOUBLE_EQ(p.y[0], 0.02);
    EXPECT_EQ(p.v[0], 3);
}

}  // namespace
}  // namespace tw
