#include "meshes/shedding_edges.h"
#include "base/numbers.h"

#include <gtest/gtest.h>

#include <cmath>

#include "meshes/generate.h"

namespace tw {
namespace shedding_edges_test {

const Box everywhere{Vec3(-10, -10, -10), Vec3(10, 10, 10)};

TEST(SheddingEdges, OfATrimmedBoxAreTransomAndBilgesAndNotTheBow) {
    const Surface box =
        posed(make_hull("box", {{"length", 4}, {"beam", 2}, {"height", 1}}), {.trim = 5 * degree, .draft = 0.2});
    const auto edges = shedding_edges(box, everywhere);
    EXPECT_NEAR(length_of(edges), 4 + 4 + 2, 1e-12);
    for (const SheddingEdge& e : edges) {
        const Vec3 middle = 0.5 * (e.from + e.to);
        EXPECT_NEAR(e.inward.norm(), 1, 1e-12);
        EXPECT_GT(e.inward.z(), 0.5) << "upwards, away from the bottom";
        EXPECT_LT(e.inward.y() * middle.y(), 1e-12) << "from the bilge to the middle";
        EXPECT_GT(middle.x(), -1) << "the bow's lower edge lies at -2 m; water arrives there";
    }
}

TEST(SheddingEdges, OfAPrismaticHullAreTransomAndChinesAndNotTheKeel) {
    const double deadrise = 20 * degree;
    const Surface hull = posed(make_hull("prismatic", {{"length", 4}, {"beam", 1}, {"deadrise", deadrise}}),
                               {.trim = 5 * degree, .draft = 0.2});
    const double slant = 0.5 / std::cos(deadrise);
    EXPECT_NEAR(length_of(shedding_edges(hull, everywhere)), 2 * 4 + 2 * slant, 1e-9);
    // One side of the hull below z = 0.1 m: half the transom, and the chine to where it rises through that height.
    Box half = everywhere;
    half.min.y() = 0;
    half.max.z() = 0.1;
    const double chine_depth = 0.2 - 0.5 * std::tan(deadrise) * std::cos(5 * degree);
    EXPECT_NEAR(length_of(shedding_edges(hull, half)), slant + (0.1 + chine_depth) / std::sin(5 * degree), 1e-9);
}

TEST(SheddingEdges, SmoothHullsHaveNone) {
    EXPECT_TRUE(shedding_edges(make_hull("sphere", {{"diameter", 2}, {"level", 4}}), everywhere).empty());
    EXPECT_FALSE(shedding_edges(make_hull("box", {}), everywhere).empty()) << "or this test sees nothing";
}

TEST(SheddingEdges, InnerEdgesAreNone) {
    // Seen from outside, a box turned inside out is all inner edges.
    Surface box = make_hull("box", {});
    for (auto& t : box.triangles) std::swap(t[1], t[2]);
    EXPECT_TRUE(shedding_edges(box, everywhere).empty());
}

TEST(SheddingEdges, TheirRibbonBeginsAtTheEdgeAndLiesInTheSolid) {
    const Surface box = posed(make_hull("box", {{"length", 4}, {"beam", 2}, {"height", 1}}), {.draft = 0.2});
    const auto edges = shedding_edges(box, everywhere);
    const Surface strip = ribbon(edges, 0.01);
    ASSERT_GE(edges.size(), 3u) << "transom and two bilges";
    EXPECT_EQ(strip.triangles.size(), 2 * edges.size());
    const Box inside = box.bounds();
    for (const Vec3& p : strip.points) EXPECT_TRUE(inside.contains(p));
    EXPECT_NEAR(strip.bounds().min.z(), -0.2, 1e-12);
    EXPECT_NEAR(strip.bounds().max.z(), -0.2 + 0.01 / std::sqrt(2), 1e-12);
}

}  // namespace shedding_edges_test
}  // namespace tw
