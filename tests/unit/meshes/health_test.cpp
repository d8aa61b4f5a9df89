#include <gtest/gtest.h>

#include <cmath>
#include <limits>
#include <map>
#include <random>

#include "meshes/mass_properties.h"
#include "meshes/symmetric.h"
#include "tests/unit/meshes/broken.h"

namespace tw {
namespace health_test {
using Level = Finding::Level;

/// Exactly the named findings, in order, or what was found instead.
void expect_findings(const Surface& s, const std::string& expected, double particle_spacing = 0) {
    const auto findings = check_surface(s, particle_spacing);
    EXPECT_EQ(names(findings), expected);
    for (const Finding& f : findings) EXPECT_GT(f.message.size(), 20u) << f.name;
}

TEST(CheckSurface, FindsNothingOnASoundHull) {
    for (const char* shape : {"prismatic", "fridsma", "seaplane", "wigley", "torpedo"}) expect_findings(make_hull(shape, {}), "");
}

TEST(CheckSurface, NamesAnEmptySurfaceAndNumbersThatAreNone) {
    expect_findings({}, "empty");
    Surface s = make_hull("box", {});
    s.points[3].y() = std::numeric_limits<double>::quiet_NaN();
    expect_findings(s, "not_finite");
    s.points[3].y() = std::numeric_limits<double>::infinity();
    expect_findings(s, "not_finite");
}

TEST(CheckSurface, FindsAMissingTriangleAtItsPlace) {
    Surface s = make_hull("seaplane", {});
    const Vec3 hole = s.corner(1000, 0);
    s.triangles.erase(s.triangles.begin() + 1000);
    expect_findings(s, "open_edges");
    EXPECT_LT((check_surface(s)[0].place - hole).norm(), 1.0);
    EXPECT_NE(check_surface(s)[0].message.find("3 open edges around 1 hole"), std::string::npos);
    EXPECT_FALSE(usable(check_surface(s)));
}

TEST(CheckSurface, FindsAThirdWallAtAnEdge) {
    Surface s = make_hull("box", {});
    const auto t = s.triangles[0];
    s.points.emplace_back(0, 0, 5);
    s.triangles.push_back({t[0], t[1], static_cast<int>(s.points.size()) - 1});
    EXPECT_NE(finding(check_surface(s), "non_manifold_edges"), nullptr);
}

TEST(CheckSurface, FindsOneFlippedTriangleAndAWhollyInvertedHull) {
    Surface s = make_hull("wigley", {});
    std::swap(s.triangles[17][0], s.triangles[17][1]);
    expect_findings(s, "flipped_normals");
    expect_findings(turned_inside_out(make_hull("wigley", {})), "inverted");
}

TEST(CheckSurface, TellsACatamaranFromAHullInAHull) {
    const Surface box = make_hull("box", {});
    const Surface inner = shifted(scaled(box, 0.5), {0, 0, 0.25});
    expect_findings(together(box, shifted(box, {0, 3, 0})), "several_shells");
    EXPECT_TRUE(usable(check_surface(together(box, shifted(box, {0, 3, 0})))));
    expect_findings(together(box, inner), "nested_shells");
    expect_findings(together(box, turned_inside_out(inner)), "nested_shells");  // a hollow body: a double shell
    EXPECT_NE(check_surface(together(box, turned_inside_out(inner)))[0].message.find("hollow"), std::string::npos);
    EXPECT_FALSE(usable(check_surface(together(box, inner))));
    // Within the other's bounding box, but outside of it.
    expect_findings(together(make_hull("sphere", {}), shifted(scaled(box, 0.05), {0.45, 0.45, 0.02})),
                    "several_shells");
}

TEST(CheckSurface, FindsABoxAndASphereThatPassThroughEachOther) {
    const Surface box = make_hull("box", {});
    expect_findings(together(box, shifted(make_hull("sphere", {}), {0.6, 0, 0.3})), "several_shells self_intersection");
    expect_findings(together(box, shifted(make_hull("sphere", {}), {1.01, 0, 0})), "several_shells");
    // Edges that cross edges exactly, as boxes on one lattice do.
    expect_findings(together(box, shifted(box, {0.5, 0.5, 0.5})), "several_shells self_intersection");
    // Faces that lie upon each other, corners not shared.
    expect_findings(together(box, shifted(box, {1, 0.25, 0.25})), "several_shells self_intersection");
}

TEST(CheckSurface, FindsACornerPushedThroughTheOppositeSide) {
    Surface s = make_hull("sphere", {{"level", 3}});
    EXPECT_EQ(finding(check_surface(s), "self_intersection"), nullptr);
    s.points[5].z() = 1.2;  // the bottom, out through the top
    EXPECT_NE(finding(check_surface(s), "self_intersection"), nullptr);
}

TEST(CheckSurface, TakesNeighboursOnNoisyFlatFacesForWhatTheyAre) {
    // Rounding of single-precision files leaves flat faces neither flat nor bent.
    std::mt19937 random(1);
    for (const double noise : {0.0, 1e-16, 1e-13, 1e-10, 1e-7}) {
        Surface s = refined(posed(make_hull("prismatic", {}), {.trim = 0.1, .heel = 0.05}), 0.1);
        std::uniform_real_distribution<double> shake(-noise, noise);
        for (Vec3& p : s.points) p += Vec3(shake(random), shake(random), shake(random));
        expect_findings(s, "");
    }
}

TEST(CheckSurface, TakesFlatFacesOfVeryUnequalTrianglesForWhatTheyAre) {
    // A box whose faces are cut towards one corner again and again, turned so that nothing lies in a plane exactly.
    for (int turn = 1; turn < 40; ++turn) {
        Surface s = make_hull("box", {});
        for (int cut = 0; cut < 20; ++cut) {
            // Halve every edge at corner 0: triangles there shrink to 1e-6 of the others.
            std::map<int, int> middles;
            const auto middle = [&](int far) {
                const auto [entry, fresh] = middles.try_emplace(far, static_cast<int>(s.points.size()));
                if (fresh) s.points.push_back(0.5 * (s.points[0] + s.points[static_cast<std::size_t>(far)]));
                return entry->second;
            };
            const std::size_t count = s.triangles.size();
            for (std::size_t t = 0; t < count; ++t) {
                auto c = s.triangles[t];
                while (c[0] != 0 && (c[1] == 0 || c[2] == 0)) std::ranges::rotate(c, c.begin() + 1);
                if (c[0] != 0) continue;
                const int b = middle(c[1]), d = middle(c[2]);
                s.triangles[t] = {0, b, d};
                s.triangles.push_back({b, c[1], c[2]});
                s.triangles.push_back({b, c[2], d});
            }
        }
        s = posed(s, {.trim = 0.1 * turn, .heel = 0.07 * turn, .draft = 0.3});
        expect_findings(s, "");
    }
}

/// A box whose deck's edge is split on one side by a triangle whose corners lie on a line.
Surface box_with_an_empty_triangle() {
    Surface s = make_hull("box", {});
    const auto t = s.triangles[0];
    const int middle = static_cast<int>(s.points.size());
    s.points.push_back(0.5 * (s.points[static_cast<std::size_t>(t[0])] + s.points[static_cast<std::size_t>(t[1])]));
    s.triangles[0] = {t[0], middle, t[2]};
    s.triangles.push_back({middle, t[1], t[2]});
    s.triangles.push_back({t[0], t[1], middle});
    return s;
}

TEST(CheckSurface, FindsTrianglesWithoutArea) { expect_findings(box_with_an_empty_triangle(), "zero_area"); }

TEST(CheckSurface, SuspectsMillimetresAndDistance) {
    const Surface hull = make_hull("prismatic", {});  // 4 m
    expect_findings(scaled(hull, 1000), "suspicious_size");
    EXPECT_NE(check_surface(scaled(hull, 1000))[0].message.find("unit = \"mm\""), std::string::npos);
    expect_findings(scaled(hull, 1e-3), "suspicious_size");
    EXPECT_TRUE(usable(check_surface(scaled(hull, 1e-3))));
    expect_findings(shifted(hull, {30000, 0, 0}), "far_from_origin");
    expect_findings(shifted(hull, {200, 0, 0}), "");
}

TEST(CheckSurface, CallsAFinThinButNotTheEdgesOfAWedge) {
    const double dp = 0.02;
    for (const auto& [shape, spacing] : {std::pair("prismatic", 0.025), std::pair("seaplane", 0.05),
                                         std::pair("wedge", 0.02), std::pair("torpedo", 0.01), std::pair("box", 0.1)})
        expect_findings(make_hull(shape, {}), "", spacing);
    expect_findings(make_hull("plate", {{"thickness", 5 * dp}}), "thin_walls", dp);
    expect_findings(make_hull("plate", {{"thickness", 7 * dp}}), "", dp);
    // A small fin on a large hull: its area counts, not its share.
    const Surface fin = shifted(make_hull("box", {{"length", 0.3}, {"beam", 0.03}, {"height", 0.3}}), {0, 0, -0.4});
    const auto findings = check_surface(together(make_hull("prismatic", {}), fin), dp);
    EXPECT_EQ(names(findings), "several_shells thin_walls");
    EXPECT_LT(findings[1].place.z(), 0);
    EXPECT_NE(findings[1].message.find("0.03 m"), std::string::npos) << findings[1].message;
}

TEST(CheckSurface, FindsNothingOn130000SoundTriangles) {  // how long it takes: bench_query
    const Surface sphere = make_hull("sphere", {{"level", 7}});
    ASSERT_EQ(sphere.triangles.size(), 131072u);
    expect_findings(sphere, "");
}

TEST(RepairSurface, LeavesASoundHullAsItIs) {
    const Surface hull = make_hull("seaplane", {});
    const Repaired r = repair_surface(hull);
    EXPECT_TRUE(r.done.empty());
    EXPECT_EQ(surface_hash(r.surface), surface_hash(hull));
}

TEST(RepairSurface, TurnsFlippedAndInvertedTriangles) {
    const Surface hull = make_hull("seaplane", {});
    std::mt19937 random(7);
    for (const bool inside_out : {false, true}) {
        Surface s = inside_out ? turned_inside_out(hull) : hull;
        for (auto& t : s.triangles)
            if (random() % 5 == 0) std::swap(t[1], t[2]);
        const Repaired r = repair_surface(s);
        EXPECT_TRUE(check_surface(r.surface).empty());
        EXPECT_NEAR(mass_properties(r.surface).volume, mass_properties(hull).volume, 1e-9);
        EXPECT_EQ(r.done.size(), inside_out ? 2u : 1u);
    }
}

TEST(RepairSurface, RemovesTheWallInsideWhereTwoPartsTouch) {
    const Surface half = refined(make_hull("box", {{"length", 2}, {"beam", 1}, {"height", 0.5}}), 0.4);
    const Box at = half.bounds();
    const Surface both = together(half, shifted(half, {at.size().x(), 0, 0}));
    EXPECT_FALSE(usable(check_surface(welded(both, 1e-9))));
    const Repaired r = repair_surface(both);
    EXPECT_EQ(names(check_surface(r.surface)), "");
    EXPECT_NEAR(mass_properties(r.surface).volume, 2 * mass_properties(half).volume, 1e-9);
    EXPECT_NE(r.done.back().find("triangles of walls inside"), std::string::npos) << r.done.back();
}

// A face that is there twice, once turned, is no wall inside: without both there would be a hole.
TEST(RepairSurface, OfAWallThatIsThereTwiceLeavesOne) {
    const Surface box = refined(make_hull("box", {}), 0.2);
    Surface doubled = box;
    for (const std::size_t t : {0u, 1u, 2u, 9u})
        doubled.triangles.push_back({box.triangles[t][0], box.triangles[t][2], box.triangles[t][1]});
    const Surface all = together(box, turned_inside_out(box));
    for (const Surface& s : {doubled, all}) {
        const Repaired r = repair_surface(s);
        EXPECT_EQ(names(check_surface(r.surface)), "");
        EXPECT_NEAR(mass_properties(r.surface).volume, mass_properties(box).volume, 1e-9);
    }
}

TEST(RepairSurface, WeldsCornersThatSinglePrecisionTookApart) {
    const Surface hull = make_hull("wigley", {});
    Surface soup;
    std::mt19937 random(3);
    std::uniform_real_distribution<double> shake(-1e-7, 1e-7);
    for (int t = 0; t < static_cast<int>(hull.triangles.size()); ++t) {
        const int n = static_cast<int>(soup.points.size());
        for (int k = 0; k < 3; ++k)
            soup.points.push_back(hull.corner(t, k) + Vec3(shake(random), shake(random), shake(random)));
        soup.triangles.push_back({n, n + 1, n + 2});
    }
    EXPECT_NE(finding(check_surface(soup), "open_edges"), nullptr);
    const Repaired r = repair_surface(soup);
    EXPECT_TRUE(usable(check_surface(r.surface))) << names(check_surface(r.surface));
    EXPECT_EQ(r.surface.points.size(), hull.points.size());
    EXPECT_FALSE(r.done.empty());
}

TEST(RepairSurface, ClosesASmallFlatHoleOutward) {
    const Surface hull = refined(make_hull("prismatic", {}), 0.1);
    Surface s = hull;
    int corner = -1;  // in the middle of a side; all triangles round it go
    for (int p = 0; p < static_cast<int>(s.points.size()); ++p) {
        const Vec3& at = s.points[static_cast<std::size_t>(p)];
        if (at.y() == 0.5 && std::abs(at.x()) < 0.5 && at.z() > 0.4 && at.z() < 0.6) corner = p;
    }
    ASSERT_GE(corner, 0);
    const std::size_t removed =
        std::erase_if(s.triangles, [&](const auto& t) { return std::ranges::find(t, corner) != t.end(); });
    ASSERT_GE(removed, 3u);
    const Repaired r = repair_surface(s);
    EXPECT_TRUE(check_surface(r.surface).empty()) << names(check_surface(r.surface));
    EXPECT_NEAR(mass_properties(r.surface).volume, mass_properties(hull).volume, 1e-13);
    ASSERT_FALSE(r.done.empty());
    EXPECT_NE(r.done.back().find("hole"), std::string::npos);
}

TEST(RepairSurface, RefusesALargeHoleAndAHollowHull) {
    Surface no_deck = make_hull("prismatic", {});
    const Surface closed = no_deck;
    no_deck.triangles.clear();
    for (int t = 0; t < static_cast<int>(closed.triangles.size()); ++t)
        if (closed.area_vector2(t).normalized().z() < 0.9)
            no_deck.triangles.push_back(closed.triangles[static_cast<std::size_t>(t)]);
    ASSERT_LT(no_deck.triangles.size(), closed.triangles.size());
    EXPECT_NE(finding(check_surface(repair_surface(no_deck).surface), "open_edges"), nullptr);
    const Surface hollow =
        together(make_hull("box", {}), turned_inside_out(shifted(scaled(make_hull("box", {}), 0.9), {0, 0, 0.05})));
    EXPECT_EQ(names(check_surface(repair_surface(hollow).surface)), "nested_shells");
}

TEST(RepairSurface, IsSuggestedWhereItHelpsAndNowhereElse) {
    const auto mendable = [](const Surface& s, const char* name) {
        const auto findings = check_surface(s);
        const Finding* f = finding(findings, name);
        EXPECT_NE(f, nullptr) << name;
        const bool said = f && f->mendable;
        EXPECT_EQ(said, usable(check_surface(repair_surface(s).surface))) << name;
        EXPECT_EQ(said, f && f->message.find(';') == std::string::npos) << f->message;  // otherwise: what else to do
        return said;
    };
    Surface small_hole = refined(make_hull("prismatic", {}), 0.1), no_deck = make_hull("prismatic", {});
    small_hole.triangles.pop_back();
    std::erase_if(no_deck.triangles, [closed = no_deck, t = 0](const auto&) mutable {
        return closed.area_vector2(t++).normalized().z() >= 0.9;
    });
    Surface flipped = make_hull("wigley", {});
    std::swap(flipped.triangles[17][0], flipped.triangles[17][1]);
    EXPECT_TRUE(mendable(small_hole, "open_edges"));
    EXPECT_FALSE(mendable(no_deck, "open_edges"));
    EXPECT_NE(check_surface(no_deck)[0].message.find("only flat holes of up to 0.21 m can be filled"),
              std::string::npos)
        << check_surface(no_deck)[0].message;
    EXPECT_TRUE(mendable(flipped, "flipped_normals"));
    EXPECT_TRUE(mendable(turned_inside_out(make_hull("wigley", {})), "inverted"));
    EXPECT_FALSE(mendable(scaled(make_hull("wigley", {}), 1000), "suspicious_size"));
    EXPECT_FALSE(mendable(scaled(small_hole, 1000), "open_edges"));  // the unit would still be wrong
    const Surface box = make_hull("box", {});
    EXPECT_FALSE(mendable(together(box, shifted(box, {0.5, 0.5, 0.5})), "self_intersection"));
}

TEST(MadeSymmetric, IsTheStarboardHalfTwice) {
    // A keel that runs 4 mm beside the plane and a side that is 5 mm too far out, at y < 0 only.
    const Surface hull = refined(make_hull("prismatic", {}), 0.3);
    Surface off = hull;
    for (Vec3& p : off.points) {
        if (p.y() == 0) p.y() = 0.004;
        if (p.y() < -0.4) p.y() -= 0.005;
    }
    EXPECT_NEAR(asymmetry(hull).distance, 0, 1e-12);
    const double before = asymmetry(off).distance;
    EXPECT_GT(before, 0.003);
    const Surface alike = made_symmetric(off, before);
    EXPECT_TRUE(check_surface(alike).empty()) << names(check_surface(alike));
    EXPECT_EQ(asymmetry(alike).distance, 0);
    EXPECT_NEAR(mass_properties(alike).volume / mass_properties(hull).volume, 1, 1e-9);
    EXPECT_LT(mass_properties(alike).volume, mass_properties(off).volume - 0.01);
    // A plane through the middle of its triangles: cut, and joined again.
    const Surface sphere = make_hull("sphere", {{"level", 3}}),
                  turned = posed(shifted(sphere, {0, 0, -0.5}), {.heel = 0.3});
    const Surface cut = made_symmetric(turned, 1e-9);
    EXPECT_TRUE(check_surface(cut).empty()) << names(check_surface(cut));
    EXPECT_NEAR(mass_properties(cut).volume / mass_properties(sphere).volume, 1, 0.02);
}

TEST(RepairSurface, RemovesWhatHasNoArea) {
    Surface s = box_with_an_empty_triangle();
    const auto t = s.triangles[1];
    s.triangles.push_back({t[0], t[0], t[1]});
    s.triangles.push_back(s.triangles[3]);
    const Repaired r = repair_surface(s);
    EXPECT_TRUE(check_surface(r.surface).empty()) << names(check_surface(r.surface));
    EXPECT_NEAR(mass_properties(r.surface).volume, 1, 1e-14);
    EXPECT_EQ(r.done.size(), 2u);
}
}  // namespace health_test
}  // namespace tw
