#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "meshes/generate.h"
#include "meshes/query.h"

namespace tw {
namespace query_test {

std::vector<Vec3> random_points(const Box& box, double margin, int n, unsigned seed) {
    std::mt19937 random(seed);
    std::uniform_real_distribution<double> unit(0, 1);
    std::vector<Vec3> points;
    for (int i = 0; i < n; ++i) {
        const Vec3 u(unit(random), unit(random), unit(random));
        points.push_back(box.min - Vec3::Constant(margin) + u.cwiseProduct(box.size() + Vec3::Constant(2 * margin)));
    }
    return points;
}

double distance_to_box(const Box& box, const Vec3& p) {
    const Vec3 out = (box.min - p).cwiseMax(p - box.max);
    return out.maxCoeff() < 0 ? out.maxCoeff() : out.cwiseMax(0).norm();
}

/// Solid angle of the surface seen from p over 4 pi: 1 inside, 0 outside (van Oosterom & Strackee 1983). Shares nothing
/// with the code under test.
double winding_by_solid_angle(const Surface& s, const Vec3& p) {
    double sum = 0;
    for (int t = 0; t < static_cast<int>(s.triangles.size()); ++t) {
        const Vec3 a = s.corner(t, 0) - p, b = s.corner(t, 1) - p, c = s.corner(t, 2) - p;
        const double na = a.norm(), nb = b.norm(), nc = c.norm();
        sum += std::atan2(a.dot(b.cross(c)), na * nb * nc + a.dot(b) * nc + b.dot(c) * na + c.dot(a) * nb);
    }
    return sum / (2 * std::numbers::pi);
}

TEST(SurfaceQuery, OfABoxIsExactAtFacesEdgesAndCorners) {
    const Surface s = make_hull("box", {{"length", 2}, {"beam", 1}, {"height", 0.5}});
    const Box box = s.bounds();
    const SurfaceQuery query(s);
    for (const Vec3& p : random_points(box, 0.7, 20000, 1)) {
        const double exact = distance_to_box(box, p);
        ASSERT_NEAR(query.nearest(p).distance, exact, 1e-14) << p.transpose();
        ASSERT_EQ(query.inside(p), exact < 0) << p.transpose();
    }
    // Straight off corners and edges, where the sign comes from pseudo-normals.
    EXPECT_NEAR(query.nearest({1.3, 0.9, 0.9}).distance, std::hypot(0.3, 0.4, 0.4), 1e-15);
    EXPECT_NEAR(query.nearest({1.3, 0.1, 0.9}).distance, 0.5, 1e-15);
    EXPECT_NEAR(query.nearest({0.1, 0.1, 0.5}).distance, 0, 1e-15);
    EXPECT_LT((query.nearest({0.1, 0.13, 0.5}).normal - Vec3::UnitZ()).norm(), 1e-15);
    EXPECT_LT((query.nearest({0.1, 0.13, 0.4}).normal - Vec3::UnitZ()).norm(), 1e-13);  // outward from the inside too
    EXPECT_LT((query.nearest({1, 0.5, 0.5}).normal - Vec3::Ones().normalized()).norm(), 1e-12);
}

TEST(SurfaceQuery, NamesTheFacesThatMeetAtTheNearestPoint) {
    const Surface s = make_hull("box", {{"length", 2}, {"beam", 1}, {"height", 0.5}});
    const Box box = s.bounds();
    const SurfaceQuery query(s);
    const Vec3 top_rear = Vec3(box.max.x(), 0.2, box.max.z());
    const auto all_along = [](const std::vector<Vec3>& faces, const std::vector<Vec3>& directions) {
        for (const Vec3& d : directions) {
            bool found = false;
            for (const Vec3& f : faces) found = found || (f - d).norm() < 1e-12;
            if (!found) return false;
        }
        return !faces.empty();
    };
    EXPECT_EQ(query.faces_at(query.nearest(Vec3(0.1, 0.13, box.max.z() + 0.2))).size(), 1u);
    const auto edge = query.faces_at(query.nearest(top_rear + Vec3(0.1, 0, 0.1)));
    EXPECT_EQ(edge.size(), 2u);
    EXPECT_TRUE(all_along(edge, {Vec3::UnitX(), Vec3::UnitZ()}));
    EXPECT_TRUE(all_along(query.faces_at(query.nearest(box.max + Vec3::Constant(0.1))),
                          {Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()}));
    EXPECT_TRUE(query.faces_at(query.nearest(box.max + Vec3::Constant(9), 0.1)).empty());
}

TEST(SurfaceQuery, OfASphereIsTheRadialDistanceUpToTheFacets) {
    const double radius = 0.5, sag = 2.5e-4;  // of level 6
    const SurfaceQuery query(make_hull("sphere", {{"level", 6}}));
    for (const Vec3& p : random_points({Vec3(-1, -1, -0.5), Vec3(1, 1, 1.5)}, 0, 5000, 2)) {
        const double exact = (p - Vec3(0, 0, radius)).norm() - radius;
        ASSERT_NEAR(query.nearest(p).distance, exact, sag) << p.transpose();
    }
}

TEST(SurfaceQuery, HasTheRightSideAtASharpKeelStepAndChine) {
    for (const char* shape : {"seaplane", "prismatic", "wigley", "wedge"}) {
        const Surface hull = make_hull(shape, {});
        const SurfaceQuery query(hull);
        const double scale = hull.bounds().size().x();
        for (const Vec3& p : random_points(hull.bounds(), 0.05 * scale, 300, 3)) {
            const bool in = winding_by_solid_angle(hull, p) > 0.5;
            ASSERT_EQ(query.inside(p), in) << shape << " " << p.transpose();
            ASSERT_EQ(query.nearest(p).distance < 0, in) << shape << " " << p.transpose();
        }
        // Close to the surface's own corners and edges, in the plane of symmetry too.
        std::mt19937 random(4);
        std::normal_distribution<double> normal(0, 1e-4 * scale);
        for (std::size_t i = 0; i < hull.points.size(); i += 1 + hull.points.size() / 150) {
            const Vec3 p =
                hull.points[i] + Vec3(normal(random), hull.points[i].y() == 0 ? 0 : normal(random), normal(random));
            const bool in = winding_by_solid_angle(hull, p) > 0.5;
            ASSERT_EQ(query.inside(p), in) << shape << " " << p.transpose();
            ASSERT_EQ(query.nearest(p).distance < 0, in) << shape << " " << p.transpose();
        }
    }
}

TEST(SurfaceQuery, CountsNoRayTwiceStraightUnderCornersAndEdges) {
    // A lattice on which every vertical ray meets edges and corners of the box and of the octahedral sphere.
    const SurfaceQuery box(make_hull("box", {{"length", 2}, {"beam", 2}, {"height", 2}}));
    const SurfaceQuery sphere(make_hull("sphere", {{"diameter", 2}, {"level", 4}}));
    for (int i = -8; i <= 8; ++i)
        for (int j = -8; j <= 8; ++j)
            for (int k = -4; k <= 12; ++k) {
                const Vec3 p(0.25 * i, 0.25 * j, 0.25 * k);
                const double to_box = distance_to_box({{-1, -1, 0}, {1, 1, 2}}, p);
                if (to_box != 0) { ASSERT_EQ(box.inside(p), to_box < 0) << p.transpose(); }
                const double to_sphere = (p - Vec3(0, 0, 1)).norm() - 1;
                if (std::abs(to_sphere) > 0.02) { ASSERT_EQ(sphere.inside(p), to_sphere < 0) << p.transpose(); }
            }
}

TEST(SurfaceQuery, LooksNoFurtherThanItsReachButKnowsTheSide) {
    const SurfaceQuery query(make_hull("box", {}));
    EXPECT_EQ(query.nearest({0, 0, 1.2}, 0.1).triangle, -1);
    EXPECT_EQ(query.nearest({0, 0, 1.2}, 0.1).distance, 0.1);
    EXPECT_EQ(query.nearest({0, 0, 0.5}, 0.1).distance, -0.1);
    EXPECT_NEAR(query.nearest({0, 0, 1.2}, 0.3).distance, 0.2, 1e-15);

    const auto points = random_points({Vec3(-1, -1, -1), Vec3(1, 1, 2)}, 0, 20000, 5);
    std::vector<double> bulk(points.size());
    query.signed_distances(points, bulk, 0.15);
    for (std::size_t i = 0; i < points.size(); ++i)
        ASSERT_NEAR(bulk[i], std::clamp(distance_to_box({{-0.5, -0.5, 0}, {0.5, 0.5, 1}}, points[i]), -0.15, 0.15),
                    1e-14);
}

TEST(SurfaceQuery, KeepsItsDigitsFarFromTheOrigin) {
    Surface s = make_hull("box", {});
    const Vec3 away(30000, -40000, 0);
    for (Vec3& p : s.points) p += away;
    const SurfaceQuery query(s);
    for (const Vec3& p : random_points({Vec3(-1, -1, -1), Vec3(1, 1, 2)}, 0, 2000, 6))
        ASSERT_NEAR(query.nearest(p + away).distance, distance_to_box({{-0.5, -0.5, 0}, {0.5, 0.5, 1}}, p), 1e-10);
}

TEST(SurfaceQuery, SeesASegmentThroughTheHullAlsoThroughItsEdges) {
    const SurfaceQuery query(make_hull("box", {}));
    EXPECT_TRUE(query.crosses({-2, 0.1, 0.4}, {2, 0.1, 0.4}));
    EXPECT_TRUE(query.crosses({0, 0, 0.5}, {0, 0, 3}));  // from within, through the deck's centre line
    EXPECT_FALSE(query.crosses({-0.4, 0.1, 0.4}, {0.4, 0, 0.5}));
    EXPECT_FALSE(query.crosses({-2, 0.1, 0.4}, {-1, 0.1, 0.4}));
    EXPECT_FALSE(query.crosses({-2, 0.1, 1.1}, {2, 0.1, 1.1}));
    EXPECT_TRUE(query.crosses({-1, 0, 0.5}, {0, 1, 0.5}));  // through the upright edge at (-0.5, 0.5)
}

TEST(SurfaceQuery, MeasuresTheThicknessOfAPlate) {
    const Surface plate = make_hull("plate", {{"thickness", 0.02}});
    const SurfaceQuery query(plate);
    for (int t = 0; t < static_cast<int>(plate.triangles.size()); ++t)
        if (std::abs(plate.area_vector2(t).normalized().z()) > 0.9) { EXPECT_NEAR(query.thickness(t), 0.02, 1e-14); }
}
}  // namespace query_test
}  // namespace tw
