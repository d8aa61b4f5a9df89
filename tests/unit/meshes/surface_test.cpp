#include <gtest/gtest.h>

#include <cmath>

#include "base/errors.h"
#include "meshes/generate.h"
#include "meshes/health.h"
#include "meshes/mass_properties.h"
#include "meshes/surface.h"

namespace tw {
namespace surface_test {

TEST(Pose, PutsTheLowestPointAtTheDraftAndRaisesTheBow) {
    const Surface hull = make_hull("seaplane", {});
    const Surface in_water = posed(hull, {.trim = 0.0873, .heel = 0.02, .draft = 0.9, .position = {3, -1, 0}});
    EXPECT_NEAR(in_water.bounds().min.z(), -0.9, 1e-14);
    const auto bow =
        std::ranges::min_element(hull.points, {}, [](const Vec3& p) { return p.x(); }) - hull.points.begin();
    const auto stern =
        std::ranges::max_element(hull.points, {}, [](const Vec3& p) { return p.x(); }) - hull.points.begin();
    const auto rise = [&](const Surface& s) {
        return s.points[static_cast<std::size_t>(bow)].z() - s.points[static_cast<std::size_t>(stern)].z();
    };
    EXPECT_GT(rise(in_water), rise(hull) + 0.9 * 36.9 * std::sin(0.0873));
}

TEST(Pose, TrimTurnsTheKeelByThatAngleAndHeelLowersStarboard) {
    const Surface box = make_hull("box", {{"length", 10}});
    const Surface trimmed = posed(box, {.trim = 0.1, .draft = 0.5});
    for (std::size_t i = 0; i < box.points.size(); ++i)
        if (box.points[i].z() == 0) {  // the stern's edge is the lowest now
            EXPECT_NEAR(trimmed.points[i].z(), box.points[i].x() > 0 ? -0.5 : -0.5 + 10 * std::sin(0.1), 1e-13);
        }
    // x points aft and z up: starboard, to the right of one who looks forward, is +y.
    const Surface heeled = posed(box, {.heel = 0.1});
    for (std::size_t i = 0; i < box.points.size(); ++i)
        if (box.points[i].z() == 0 && box.points[i].y() != 0) {
            EXPECT_NEAR(heeled.points[i].z(), box.points[i].y() > 0 ? 0.0 : std::sin(0.1), 1e-14);
        }
}

TEST(Pose, LeavesShapeAndVolumeAlone) {
    const Surface hull = make_hull("wigley", {});
    const MassProperties before = mass_properties(hull),
                         after = mass_properties(posed(hull, {.trim = 0.3, .heel = -0.2, .draft = 2}));
    EXPECT_NEAR(after.volume, before.volume, 1e-15);
    EXPECT_NEAR(after.inertia.trace(), before.inertia.trace(), 1e-14);
}

TEST(Wigley, FullerEndsHoldTheVolumeOfTheirFormula) {
    constexpr double L = 3, B = 0.3, T = 0.1875, freeboard = 0.1;  // Journee's model III
    for (const double a : {0.0, 0.2}) {
        const Surface hull = make_hull("wigley", {{"length", L},
                                                  {"beam", B},
                                                  {"design_depth", T},
                                                  {"freeboard", freeboard},
                                                  {"fullness", a},
                                                  {"stations", 400}});
        const double below = (4.0 / 9 + 4.0 / 45 * a) * L * B * T, above = (2.0 / 3 + 2.0 / 15 * a) * L * B * freeboard;
        EXPECT_NEAR(mass_properties(hull).volume, below + above, 2e-3 * (below + above)) << a;
    }
}

TEST(Units, AreThoseOfTheDefinitions) {
    EXPECT_EQ(metres_per("m"), 1);
    EXPECT_EQ(metres_per("mm"), 1e-3);
    EXPECT_EQ(metres_per("cm"), 1e-2);
    EXPECT_EQ(metres_per("in"), 0.0254);
    EXPECT_DOUBLE_EQ(metres_per("ft"), 12 * 0.0254);
    EXPECT_THROW(metres_per("yd"), InputError);
}

TEST(Hash, ChangesWithTheShapeOnly) {
    const Surface box = make_hull("box", {});
    EXPECT_EQ(surface_hash(box), surface_hash(make_hull("box", {})));
    Surface renumbered = box;  // the same triangles from differently numbered points
    std::ranges::reverse(renumbered.points);
    for (auto& t : renumbered.triangles)
        for (int& corner : t) corner = static_cast<int>(box.points.size()) - 1 - corner;
    EXPECT_EQ(surface_hash(box), surface_hash(renumbered));
    Surface other = box;
    other.points[0].x() = std::nextafter(other.points[0].x(), 1e9);
    EXPECT_NE(surface_hash(box), surface_hash(other));
    Surface negative_zero = box;
    for (Vec3& p : negative_zero.points)
        if (p.y() == 0) p.y() = -0.0;
    EXPECT_EQ(surface_hash(box), surface_hash(negative_zero));
}

TEST(Refined, KeepsShapeAndClosednessAndShortensEveryEdge) {
    for (const char* shape : {"prismatic", "seaplane", "wigley"}) {
        const Surface hull = make_hull(shape, {});
        const double edge = hull.bounds().size().x() / 100;
        const Surface fine = refined(hull, edge);
        for (int t = 0; t < static_cast<int>(fine.triangles.size()); ++t)
            for (int k = 0; k < 3; ++k) ASSERT_LE((fine.corner(t, k) - fine.corner(t, (k + 1) % 3)).norm(), edge);
        EXPECT_NEAR(mass_properties(fine).volume / mass_properties(hull).volume, 1, 1e-13);
        EXPECT_NEAR(mass_properties(fine).area / mass_properties(hull).area, 1, 1e-13);
        EXPECT_TRUE(check_surface(fine).empty()) << shape << ": " << check_surface(fine).front().message;
    }
    EXPECT_THROW(refined(make_hull("box", {}), 1e-3, 1000), InputError);
}

TEST(Welded, MergesCornersWithinTheToleranceAcrossCellBorders) {
    // Two triangles that share an edge up to 1e-9, with corners on either side of every cell border.
    const double e = 1e-9;
    const Surface apart{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, -e, e}, {1, 1, 0}, {-e, 1, -e}}, {{0, 1, 2}, {3, 4, 5}}};
    EXPECT_EQ(welded(apart).points.size(), 6u);
    EXPECT_EQ(welded(apart, 1e-8).points.size(), 4u);
    EXPECT_EQ(welded(apart, 1e-8).triangles.size(), 2u);
    EXPECT_EQ(welded(apart, 5).triangles.size(), 0u);
}
}  // namespace surface_test
}  // namespace tw
