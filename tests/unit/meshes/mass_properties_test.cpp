#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

#include "base/errors.h"
#include "base/numbers.h"
#include "meshes/generate.h"
#include "meshes/mass_properties.h"

namespace tw {
namespace mass_properties_test {

TEST(MassProperties, OfABoxAreExact) {
    const double a = 2, b = 0.5, c = 0.25;
    const MassProperties m = mass_properties(make_hull("box", {{"length", a}, {"beam", b}, {"height", c}}));
    EXPECT_NEAR(m.volume, a * b * c, 1e-15);
    EXPECT_NEAR(m.area, 2 * (a * b + b * c + c * a), 1e-14);
    EXPECT_LT((m.centroid - Vec3(0, 0, c / 2)).norm(), 1e-15);
    const Eigen::Matrix3d inertia =
        m.volume / 12 * Vec3(b * b + c * c, a * a + c * c, a * a + b * b).asDiagonal().toDenseMatrix();
    EXPECT_LT((m.inertia - inertia).norm(), 1e-15);
}

TEST(MassProperties, OfATurnedBoxHaveProductsOfInertia) {
    const Surface box = make_hull("box", {{"length", 2}, {"beam", 0.5}, {"height", 0.25}});
    const double angle = 0.3;
    const MassProperties level = mass_properties(box), turned = mass_properties(posed(box, {.trim = angle}));
    Eigen::Matrix3d turn;
    turn << std::cos(angle), 0, std::sin(angle), 0, 1, 0, -std::sin(angle), 0, std::cos(angle);
    EXPECT_LT((turned.inertia - turn * level.inertia * turn.transpose()).norm(), 1e-14);
    EXPECT_GT(std::abs(turned.inertia(0, 2)), 1e-2);
}

TEST(MassProperties, OfAPolyhedralSphereApproachTheFormulaWithSecondOrder) {
    const double radius = 0.5, volume = 4 * pi / 3 * std::pow(radius, 3);
    const auto error = [&](double level) {
        return 1 - mass_properties(make_hull("sphere", {{"diameter", 2 * radius}, {"level", level}})).volume / volume;
    };
    EXPECT_GT(error(5), 0);  // inscribed
    EXPECT_NEAR(std::log2(error(4) / error(5)), 2, 0.02);
    EXPECT_LT(error(6), 5e-4);
    const MassProperties m = mass_properties(make_hull("sphere", {{"diameter", 2 * radius}, {"level", 6}}));
    EXPECT_NEAR(m.inertia(0, 0) / (0.4 * volume * radius * radius), 1, 1e-3);
    EXPECT_LT((m.centroid - Vec3(0, 0, radius)).norm(), 1e-14);
}

TEST(MassProperties, OfAPrismAreSectionAreaTimesLength) {
    const double length = 3, beam = 1.2, deadrise = 0.35, height = 0.8;
    const MassProperties m = mass_properties(
        make_hull("prismatic", {{"length", length}, {"beam", beam}, {"deadrise", deadrise}, {"height", height}}));
    const double section = beam * height - beam * beam / 4 * std::tan(deadrise);
    EXPECT_NEAR(m.volume, length * section, 1e-14);
}

TEST(MassProperties, OfFridsmasHullAreThoseOfItsPrismAndOfTheEllipsesOfItsBow) {
    // Volume of the bow with x = b sin(theta): the integral of section areas b e (H - b/16 (1 - e)) - b^2/4 e^2 tan(beta),
    // e = cos(theta), over b cos(theta) dtheta.
    const double length = 2, beam = 0.4, deadrise = 0.3, height = 0.3, slope = std::tan(deadrise),
                 pi = std::numbers::pi;
    const Surface hull =
        make_hull("fridsma", {{"length", length}, {"beam", beam}, {"deadrise", deadrise}, {"height", height}});
    const double prism = (length - beam) * (beam * height - beam * beam / 4 * slope);
    const double bow = beam * beam * ((height - beam / 16) * pi / 4 + beam / 24 - beam * slope / 6);
    EXPECT_NEAR(mass_properties(hull).volume / (prism + bow), 1, 2e-4);
    EXPECT_LT((hull.bounds().size() - Vec3(length, beam, height)).norm(), 1e-12);
    EXPECT_THROW(make_hull("fridsma", {{"length", 0.2}, {"beam", 0.2}}), InputError);
}

TEST(MassProperties, OfTheWigleyHullBelowItsWaterlineApproachFourNinthsOfItsBox) {
    const double length = 2, beam = 0.3, depth = 0.2;
    const auto error = [&](double stations) {
        const Surface hull =
            make_hull("wigley", {{"length", length}, {"beam", beam}, {"design_depth", depth}, {"stations", stations}});
        return 1 - hydrostatics(posed(hull, {.draft = depth})).volume / (4.0 / 9 * length * beam * depth);
    };
    EXPECT_LT(std::abs(error(400)), 2e-3);
    EXPECT_LT(std::abs(error(400)), std::abs(error(20)));
}

TEST(MassProperties, TellAnInvertedHullByItsNegativeVolume) {
    Surface box = make_hull("box", {});
    for (auto& t : box.triangles) std::swap(t[1], t[2]);
    EXPECT_NEAR(mass_properties(box).volume, -1, 1e-15);
}

TEST(MassProperties, KeepTheirDigitsFarFromTheOrigin) {
    Surface box = make_hull("box", {});
    for (Vec3& p : box.points) p += Vec3(30000, -20000, 0);
    EXPECT_NEAR(mass_properties(box).volume, 1, 1e-9);  // of sums of terms of 1e13
}

TEST(Hydrostatics, OfABoxAfloatAreExact) {
    const Surface box = posed(make_hull("box", {{"length", 4}, {"beam", 2}, {"height", 1}}), {.draft = 0.3});
    const Hydrostatics h = hydrostatics(box);
    EXPECT_NEAR(h.volume, 4 * 2 * 0.3, 1e-14);
    EXPECT_LT((h.centroid - Vec3(0, 0, -0.15)).norm(), 1e-15);
    EXPECT_LT((h.wet_bounds.min - Vec3(-2, -1, -0.3)).norm(), 1e-15);
    EXPECT_LT((h.wet_bounds.max - Vec3(2, 1, 0)).norm(), 1e-15);
}

TEST(Hydrostatics, OfATrimmedPrismAreThoseOfItsWetTetrahedron) {
    // Bow up: the wet part of a V-bottom whose chines are dry is the tetrahedron keel-at-transom, keel-at-waterline and
    // the two points where the transom's V meets the water.
    const double deadrise = 0.5, trim = 0.1, draft = 0.15;
    const Surface hull = posed(make_hull("prismatic", {{"length", 4}, {"beam", 1}, {"deadrise", deadrise}}),
                               {.trim = trim, .draft = draft});
    const double wet_keel = draft / std::sin(trim);    // along the keel
    const double up_transom = draft / std::cos(trim);  // along the transom
    const double half_breadth = up_transom / std::tan(deadrise);
    const Hydrostatics h = hydrostatics(hull);
    EXPECT_NEAR(h.volume, wet_keel * up_transom * half_breadth / 3, 1e-14);
    EXPECT_NEAR(h.wet_bounds.size().y(), 2 * half_breadth, 1e-13);
    EXPECT_NEAR(h.centroid.z(), -draft / 4, 1e-14);  // three of the four corners lie on the waterline
}

TEST(Hydrostatics, OfAHullWhollyUnderOrAboveWater) {
    const Surface box = make_hull("box", {});
    EXPECT_NEAR(hydrostatics(posed(box, {.draft = 7})).volume, 1, 1e-14);
    EXPECT_NEAR(hydrostatics(posed(box, {.draft = 7})).centroid.z(), -6.5, 1e-14);
    EXPECT_EQ(hydrostatics(posed(box, {.draft = 0})).volume, 0);
    EXPECT_EQ(hydrostatics(posed(box, {.draft = -2})).volume, 0);
}
}  // namespace mass_properties_test
}  // namespace tw
