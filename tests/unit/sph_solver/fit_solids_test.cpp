// The fill of water round solids that do not fit its lattice.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "meshes/generate.h"
#include "meshes/query.h"
#include "sph_solver/even_packing.h"
#include "sph_solver/fit_solids.h"

namespace tw {
namespace fit_solids_test {

constexpr double dp = 0.02;

struct Filled {
    SimulationSetup setup;
    Box water;
    Fluid plain, fitted;
};

/// A tank of 0.6 m by 0.4 m, which 20 mm divide; in three dimensions 0.2 m wide.
Filled filled_round(int dimensions, const Box& solid) {
    Filled f;
    f.setup.dimensions = dimensions;
    f.setup.dp = dp;
    f.setup.domain = {Vec3(-0.3, dimensions == 3 ? -0.1 : -1, -0.4), Vec3(0.3, dimensions == 3 ? 0.1 : 1, 0.1)};
    f.setup.bodies = {box_surface(solid)};
    f.water = f.setup.domain;
    f.water.max.z() = 0;
    f.plain = fill_with_fluid(f.setup, {f.water});
    f.fitted = f.plain;
    fit_to_solids(f.setup, std::span(&f.water, 1), std::span(&f.fitted, 1));
    return f;
}

double nearest_to(const Surface& solid, const Fluid& fluid) {
    const SurfaceQuery query(solid);
    double least = 1;
    for (const Vec3& x : fluid.places) least = std::min(least, query.nearest(x).distance);
    return least;
}

/// Of the particles within three spacings of the solid.
Unevenness unevenness_of(const Filled& f, const Fluid& fluid) {
    const SurfaceQuery query(f.setup.bodies.front().surface);
    std::vector<char> near;
    for (const Vec3& x : fluid.places) near.push_back(query.nearest(x).distance < 3 * dp);
    const auto filled = [&](const Vec3& middle, double edge) {
        double share = std::clamp(0.5 + query.nearest(middle).distance / edge, 0.0, 1.0);
        for (int a = 0; a < 3; ++a)
            if (a != 1 || f.setup.dimensions == 3)
                share *=
                    std::clamp(0.5 + std::min(middle[a] - f.water.min[a], f.water.max[a] - middle[a]) / edge, 0.0, 1.0);
        return share;
    };
    return unevenness(fluid.places, near, {f.setup.dimensions, dp, fluid.volume, f.setup.h_over_dp * dp}, filled);
}

TEST(FitSolids, LeavesWaterAloneWhoseLatticeFitsTheSolid) {
    const Filled f = filled_round(2, {Vec3(-0.04, -3, -0.3), Vec3(0.04, 3, -0.1)});
    ASSERT_EQ(f.fitted.places.size(), f.plain.places.size());
    for (std::size_t i = 0; i < f.plain.places.size(); ++i) {
        EXPECT_EQ(f.fitted.places[i], f.plain.places[i]);
        EXPECT_EQ(f.fitted.depth[i], f.plain.depth[i]);
    }
}

void expect_fitted(int dimensions, const Box& solid) {
    const Filled f = filled_round(dimensions, solid);
    const double span = dimensions == 3 ? 0.2 : 1, inside = std::min(span, solid.size().y()),
                 space = 0.6 * 0.4 * span - solid.size().x() * solid.size().z() * inside;
    EXPECT_NEAR(double(f.fitted.places.size()) * f.fitted.volume / space, 1, 0.003);
    const Surface& surface = f.setup.bodies.front().surface;
    EXPECT_LT(nearest_to(surface, f.plain), 0.2 * dp) << "or it fits as it is";
    EXPECT_GT(nearest_to(surface, f.fitted), 0.24 * dp);
    const Unevenness plain = unevenness_of(f, f.plain), fitted = unevenness_of(f, f.fitted);
    std::printf(
        "%d dimensions: kernel sums near the solid off by %.2f %% in the mean and %.2f %% at most, before %.2f and "
        "%.2f %%\n",
        dimensions, 100 * fitted.mean, 100 * fitted.most, 100 * plain.mean, 100 * plain.most);
    EXPECT_LT(fitted.mean, 0.015);
    EXPECT_LT(fitted.most, 0.04);
    EXPECT_GT(plain.most, 0.08);
    for (std::size_t i = 0; i < f.fitted.places.size(); ++i)
        ASSERT_NEAR(f.fitted.depth[i], -f.fitted.places[i].z(), 1e-12);
}

TEST(FitSolids, FillsAsManyPlacesAsTheWaterAsksForAndEvenly) {
    expect_fitted(2, {Vec3(-0.03, -3, -0.29), Vec3(0.03, 3, -0.1)});
    expect_fitted(3, {Vec3(-0.05, -0.3, -0.29), Vec3(0.055, 0.3, -0.12)});
}

/// Two boxes that go into each other: a face of the one that is inside the other bounds no water.
TEST(FitSolids, FillsNothingInsideASolidWhereAnotherOneEnds) {
    Filled f = filled_round(2, {Vec3(-0.1, -3, -0.3), Vec3(0.1, 3, -0.1)});
    f.setup.bodies.emplace_back(box_surface({Vec3(-0.03, -3, -0.35), Vec3(0.03, 3, -0.11)}));
    f.plain = f.fitted = fill_with_fluid(f.setup, {f.water});
    fit_to_solids(f.setup, std::span(&f.water, 1), std::span(&f.fitted, 1));
    const double space = 0.6 * 0.4 - 0.2 * 0.2 - 0.06 * 0.05;
    EXPECT_NEAR(double(f.fitted.places.size()) * f.fitted.volume / space, 1, 0.003);
    for (const BodySetup& body : f.setup.bodies) EXPECT_GT(nearest_to(body.surface, f.fitted), 0);
}

TEST(FitSolids, LeavesStreamsAlone) {
    Filled f = filled_round(2, {Vec3(-0.03, -3, -0.29), Vec3(0.03, 3, -0.1)});
    f.setup.stream = Stream{1, 0.5, 0.1};
    Fluid fluid = f.plain;
    fit_to_solids(f.setup, std::span(&f.water, 1), std::span(&fluid, 1));
    EXPECT_EQ(fluid.places, f.plain.places);
}

}  // namespace fit_solids_test
}  // namespace tw
