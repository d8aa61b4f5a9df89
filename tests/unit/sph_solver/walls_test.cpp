#include <gtest/gtest.h>

#include <cmath>
#include <numeric>

#include "meshes/generate.h"
#include "meshes/mass_properties.h"
#include "sph_solver/bodies/dummies.h"
#include "sph_solver/bodies/samples.h"
#include "sph_solver/bodies/slip_normal.h"

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

TEST(TimeToEdge, IsTheWayToWhereASharpEdgeIsLeftOverTheSpeed) {
    const SurfaceQuery box(box_surface({Vec3(-1, -1, 0), Vec3(0, 1, 1)}));
    const auto time = [](const SurfaceQuery& query, const Vec3& x, const Vec3& u, double reach) {
        const SurfaceQuery::Nearest found = query.nearest(x);
        EXPECT_TRUE(found.on_face()) << x.transpose();
        return time_to_edge(query, found, x, u, reach);
    };
    // under the bottom, 0.1 m before the edge at x = 0; what the velocity has towards the face is no way along it
    for (const Vec3& u : {Vec3(8, 0, 0), Vec3(8, 0, 1)}) {
        const auto found = time(box, Vec3(-0.1, 0.2, -0.05), u, 0.3);
        ASSERT_TRUE(found);
        EXPECT_NEAR(*found, 0.1 / 8, 0.3 / 64 / 8);
    }
    EXPECT_FALSE(time(box, Vec3(-0.5, 0.2, -0.05), Vec3(8, 0, 0), 0.3)) << "too far";
    EXPECT_FALSE(time(box, Vec3(-0.1, 0.2, -0.05), Vec3(-8, 0, 0), 0.3)) << "the other way";
    EXPECT_FALSE(time(box, Vec3(-0.1, 0.2, -0.05), Vec3(0, 0, 0), 0.3));
    // the facets of a round body end in edges that are none
    const SurfaceQuery sphere(make_hull("sphere", {}));
    Vec3 beside = sphere.nearest(Vec3(0.3, 0.2, -5)).point;
    beside += 0.01 * sphere.nearest(beside).normal;
    if (sphere.nearest(beside).on_face()) { EXPECT_FALSE(time(sphere, beside, Vec3(1, 1, 0), 0.3)); }
}

}  // namespace walls_test
}  // namespace tw
