#include <gtest/gtest.h>

#include <numbers>

#include "base/errors.h"
#include "base/numbers.h"
#include "meshes/generate.h"
#include "meshes/health.h"
#include "meshes/mass_properties.h"
#include "meshes/section.h"

namespace tw {
namespace section_test {

TEST(Section, OfATrimmedPlateIsThePlateItself) {
    const Surface plate = posed(make_hull("plate", {{"length", 4}, {"beam", 2}, {"thickness", 0.3}}),
                                {.trim = 30 * degree, .draft = 0.1, .position = {-1, 0, 0}});
    const Surface prism = section_prism(plate);
    EXPECT_TRUE(usable(check_surface(prism)));
    EXPECT_EQ(prism.points.size(), 8u) << "corners of coplanar triangles are none of the section";
    EXPECT_NEAR(mass_properties(prism).volume, 4 * 0.3, 1e-12) << "one metre, normals outward";
    EXPECT_NEAR(prism.bounds().max.y(), 0.5, 1e-15);
    for (const int axis : {0, 2}) {
        EXPECT_NEAR(prism.bounds().min[axis], plate.bounds().min[axis], 1e-12);
        EXPECT_NEAR(prism.bounds().max[axis], plate.bounds().max[axis], 1e-12);
    }
}

TEST(Section, OfARoundBodyIsItsCircleAndAKeelInThePlaneCutsLikeAnyOther) {
    const Surface ball = make_hull("sphere", {{"diameter", 2}, {"level", 6}});  // corners in the plane
    EXPECT_NEAR(mass_properties(section_prism(ball)).volume, std::numbers::pi, 2e-3);
    // V-bottom: keel and deck lie in the plane, which cuts a rectangle of length by height.
    const Surface hull = make_hull("prismatic", {{"length", 4}, {"height", 0.75}});
    EXPECT_NEAR(mass_properties(section_prism(hull)).volume, 4 * 0.75, 1e-9);
}

TEST(Section, SpanStretchesAcrossThePlaneOnly) {
    const Surface prism = section_prism(make_hull("wigley", {}));
    const Surface wide = with_span(prism, 7);
    EXPECT_NEAR(mass_properties(wide).volume, 7 * mass_properties(prism).volume, 1e-9);
    EXPECT_GT(endless_span(prism), 10 * prism.bounds().size().x());
}

TEST(Section, WhatHasNoneIsRefusedAndSaysWhere) {
    const auto words = [](const Surface& s) {
        try {
            section_prism(s);
        } catch (const InputError& e) { return std::string(e.what()); }
        return std::string();
    };
    EXPECT_NE(words(box_surface({Vec3(0, 1, 0), Vec3(1, 2, 1)})).find("y from 1 to 2 m"), std::string::npos);
    Surface open = box_surface({Vec3(0, -1, 0), Vec3(1, 1, 1)});
    open.triangles.erase(open.triangles.begin());
    EXPECT_NE(words(open).find("not closed"), std::string::npos);
    Surface hollow = box_surface({Vec3(0, -1, 0), Vec3(1, 1, 1)});
    const Surface hole = box_surface({Vec3(0.4, -0.5, 0.4), Vec3(0.6, 0.5, 0.6)});
    for (const auto& t : hole.triangles) hollow.triangles.push_back({t[0] + 8, t[2] + 8, t[1] + 8});
    hollow.points.insert(hollow.points.end(), hole.points.begin(), hole.points.end());
    EXPECT_NE(words(hollow).find("hollow"), std::string::npos);
}

}  // namespace section_test
}  // namespace tw
