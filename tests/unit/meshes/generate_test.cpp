#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/errors.h"
#include "base/numbers.h"
#include "meshes/generate.h"
#include "meshes/health.h"
#include "meshes/mass_properties.h"

namespace tw {
namespace generate_test {

std::string text(const std::vector<Finding>& findings) {
    std::string all;
    for (const Finding& f : findings) all += f.name + ": " + f.message + "\n";
    return all;
}

/// Every triangle has its mirror image among the triangles.
bool symmetric(const Surface& s) {
    const auto key = [](const Vec3& a, const Vec3& b, const Vec3& c, double sign) {
        std::array<std::array<double, 3>, 3> k;
        std::size_t i = 0;
        for (const Vec3& p : {a, b, c}) k[i++] = {p.x(), sign * p.y() + 0.0, p.z()};
        std::ranges::sort(k);
        return k;
    };
    std::vector<std::array<std::array<double, 3>, 3>> here, mirrored;
    for (int t = 0; t < static_cast<int>(s.triangles.size()); ++t) {
        here.push_back(key(s.corner(t, 0), s.corner(t, 1), s.corner(t, 2), 1));
        mirrored.push_back(key(s.corner(t, 0), s.corner(t, 1), s.corner(t, 2), -1));
    }
    std::ranges::sort(here);
    std::ranges::sort(mirrored);
    return here == mirrored;
}

TEST(HullShapes, AreSoundClosedOutwardAndOnTheirKeel) {
    ASSERT_EQ(hull_shapes().size(), 10u);
    for (const HullShape& shape : hull_shapes()) {
        const Surface hull = make_hull(shape.name, {});
        EXPECT_TRUE(check_surface(hull).empty()) << shape.name << "\n" << text(check_surface(hull));
        EXPECT_GT(mass_properties(hull).volume, 0) << shape.name;
        EXPECT_NEAR(hull.bounds().min.z(), 0, 1e-15) << shape.name;
        EXPECT_NEAR(hull.bounds().min.x() + hull.bounds().max.x(), 0, 1e-12) << shape.name;
        EXPECT_TRUE(symmetric(hull)) << shape.name;
    }
}

TEST(HullShapes, AreSoundAtBothEndsOfEveryParameter) {
    for (const HullShape& shape : hull_shapes())
        for (const HullParameter& p : shape.parameters) {
            EXPECT_LE(p.min, p.fallback) << shape.name << " " << p.name;
            EXPECT_GE(p.max, p.fallback) << shape.name << " " << p.name;
            if (p.kind == "m") continue;  // one length alone at its end makes needles
            for (const double value : {p.min, std::min(p.max, p.name == "level"      ? 6
                                                              : p.name == "stations" ? 300
                                                                                     : p.max)}) {
                const Surface hull = make_hull(shape.name, {{p.name, value}});
                EXPECT_TRUE(usable(check_surface(hull))) << shape.name << " " << p.name << " = " << value << "\n"
                                                         << text(check_surface(hull));
            }
        }
}

TEST(HullShapes, RefuseWhatTheyDoNotKnowByName) {
    const auto message = [](const std::string& shape, const std::map<std::string, double>& values) -> std::string {
        try {
            make_hull(shape, values);
        } catch (const InputError& e) { return e.what(); }
        return "";
    };
    EXPECT_NE(message("prizmatic", {}).find("prismatic"), std::string::npos);
    EXPECT_NE(message("box", {{"widht", 1}}).find("beam"), std::string::npos);
    EXPECT_NE(message("box", {{"beam", -1}}).find("beam = -1"), std::string::npos);
    EXPECT_NE(message("box", {{"beam", std::nan("")}}), "");
    EXPECT_NE(message("prismatic", {{"beam", 4}, {"height", 0.5}}).find("chines"), std::string::npos);
    EXPECT_NE(message("torpedo", {{"tail_length", 3}}).find("tail_length"), std::string::npos);
}

TEST(Prismatic, HasItsDeadriseAndASharpTransom) {
    const Surface hull = make_hull("prismatic", {{"deadrise", 20 * degree}});
    double flattest = 0;
    for (int t = 0; t < static_cast<int>(hull.triangles.size()); ++t) {
        const Vec3 n = hull.area_vector2(t).normalized();
        if (n.z() < -1e-9) { EXPECT_NEAR(n.z(), -std::cos(20 * degree), 1e-12); }
        flattest = std::max(flattest, n.x());
    }
    EXPECT_EQ(flattest, 1);  // the transom is upright
    const Surface raked = make_hull("prismatic", {{"rake", 45 * degree}});
    // The rake of 45 degrees takes away the first moment of the section about the deck.
    const double t = std::tan(20 * degree), chine = 0.5 * t, height = 0.75;
    const double moment =
        2 * ((chine * chine * height / 2 - std::pow(chine, 3) / 3) / t + 0.5 * std::pow(height - chine, 2) / 2);
    EXPECT_NEAR(mass_properties(hull).volume - mass_properties(raked).volume, moment, 1e-13);
}

TEST(Seaplane, HasTheMainDimensionsOfTheStudyAndAStep) {
    const Surface hull = make_hull("seaplane", {});
    EXPECT_NEAR(hull.bounds().size().x(), 36.9, 1e-12);
    EXPECT_GT(hull.triangles.size(), 2000u);
    EXPECT_LT(hull.triangles.size(), 20000u);
    double step_area = 0;
    for (int t = 0; t < static_cast<int>(hull.triangles.size()); ++t)
        if (hull.area_vector2(t).normalized().x() > 1 - 1e-9 && std::abs(hull.corner(t, 0).x()) < 1e-9)
            step_area += hull.area_vector2(t).norm() / 2;
    EXPECT_NEAR(step_area, 3.4 * 0.27, 1e-3);  // beam times height of the step
    // Trimmed by 5 degrees the hull stands on its step, and the afterbody keel clears it.
    const Surface trimmed = posed(hull, {.trim = 5 * degree, .draft = 0.9});
    const auto lowest =
        std::ranges::min_element(trimmed.points, {}, [](const Vec3& p) { return p.z(); }) - trimmed.points.begin();
    EXPECT_NEAR(hull.points[static_cast<std::size_t>(lowest)].x(), 0, 1e-9);
    EXPECT_EQ(hull.points[static_cast<std::size_t>(lowest)].y(), 0);
}

TEST(Torpedo, DisplacesThePublishedWeight) {
    const MassProperties m = mass_properties(make_hull("torpedo", {}));
    EXPECT_NEAR(1000 * 9.81 * m.volume, 1848, 5);
}

TEST(Cylinder, LiesAcrossTheStream) {
    const Surface s = make_hull("cylinder", {{"diameter", 2}, {"span", 3}, {"segments", 512}});
    EXPECT_NEAR(mass_properties(s).volume, 3 * std::numbers::pi, 1e-3);
    EXPECT_NEAR(s.bounds().size().y(), 3, 1e-15);
}

TEST(Wedge, HasItsVInThePlaneOfTwoDimensionalScenes) {
    const Surface s = make_hull("wedge", {{"width", 1}, {"span", 2}, {"deadrise", 30 * degree}});
    EXPECT_NEAR(mass_properties(s).volume, 2 * 0.25 * std::tan(30 * degree), 1e-14);
    for (const Vec3& p : s.points)
        if (p.z() == 0) { EXPECT_EQ(p.x(), 0); }
}
}  // namespace generate_test
}  // namespace tw
