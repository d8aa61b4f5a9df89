#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "meshes/generate.h"
#include "meshes/mass_properties.h"
#include "sph_solver/bodies/dummies.h"
#include "sph_solver/bodies/samples.h"

namespace tw {
namespace walls_test {

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

}  // namespace walls_test
}  // namespace tw
