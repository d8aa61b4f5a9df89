// The jet that a hull throws by thin-jet theory, and what check says of it.
#include "scene/solids/thin_jet.h"

#include <cmath>
#include <numbers>

#include "scene/new_record.h"
#include "scene_text.h"

namespace tw::test {
namespace thin_jet_test {

constexpr double pi = std::numbers::pi;

double thickness(const std::string& text) {
    const std::optional<SprayJet> jet = thin_jet(scene_of(text));
    return jet ? jet->thickness : 0;
}
double tan_of(double degrees) { return std::tan(degrees * pi / 180); }

TEST(ThinJet, OfWedgesIsWagnersAtTheChine) {
    // The chine is wet from a draft of (2/pi) 0.5 m tan(20 deg) = 0.116 m on: c = 0.5 m there. In the hull's own section
    // the deadrise is 20 degrees; in the upright section that the stream meets it is so to 0.4 %.
    const double exact = 0.5 * std::pow(tan_of(20), 2) / (2 * pi);
    EXPECT_NEAR(thickness(planing), exact, 0.02 * exact);
    EXPECT_NEAR(thickness(with(planing, "half     = true\n", "")), exact, 0.02 * exact);
    // Dry chines: at the transom c = (pi/2) d / tan(beta), so delta = d tan(beta) / 4.
    const double dry = 0.1 * tan_of(20) / 4;
    EXPECT_NEAR(thickness(with(planing, "0.2 m", "0.1 m")), dry, 0.05 * dry);
}

// The hull's place across the stream, and a second hull beside it, change nothing of how it meets the water.
TEST(ThinJet, DoesNotDependOnWhereTheHullLiesAcrossTheStream) {
    const std::string alone = with(planing, "half     = true\n", "");
    const double at_middle = thickness(alone);
    for (const char* y : {"0.1", "-0.4", "0.5", "2"})
        EXPECT_NEAR(thickness(with(alone, "draft ", std::string("position = [0, ") + y + "]\ndraft ")), at_middle,
                    1e-6 * at_middle)
            << y;
    Surface two = scene_of(alone).hull->surface, other = two;
    const int first = static_cast<int>(two.points.size());
    for (Vec3& p : two.points) p.y() -= 1.5;
    for (Vec3& p : other.points) p.y() += 1.5;
    two.points.insert(two.points.end(), other.points.begin(), other.points.end());
    for (const auto& t : other.triangles) two.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    write_stl(scratch() / "two.stl", two);
    const std::string catamaran = with(
        planing,
        "shape    = \"prismatic\"\nlength   = \"4 m\"\nbeam     = \"1 m\"\ndeadrise = \"20 deg\"\ntrim     = \"5 deg\"",
        "file = \"two.stl\"");
    EXPECT_NEAR(thickness(catamaran), at_middle, 0.01 * at_middle);
}

TEST(ThinJet, OfAFlatBottomFollowsFromLengthAndTrim) {
    const double tau = 5 * pi / 180, length = 0.2 / std::sin(tau);
    const double exact = pi * length * tau * tau / (4 + 2 * pi * tau);
    EXPECT_NEAR(thickness(with(planing, "20 deg", "0 deg")), exact, 0.03 * exact);
    EXPECT_EQ(thickness(with(with(planing, "20 deg", "0 deg"), "5 deg", "0 deg")), 0) << "no jet is known";
}

TEST(ThinJet, CheckSaysBeforeTheRunWhetherItIsResolved) {
    const Scene scene = scene_of(planing);  // near_hull = 0.05 m
    const std::string coarse = to_text(scene, predict(scene));
    EXPECT_NE(coarse.find("not resolved: the jet is 0.21 of a particle or cell thick, and three across it are needed "
                          "(near_hull = 3.5 mm)"),
              std::string::npos)
        << coarse;
    const Scene fine = scene_of(planing + "[[refine]]\naround = \"spray_root\"\nspacing = \"0.0125 m\"\n");
    EXPECT_DOUBLE_EQ(thin_jet(fine)->size, 0.0125);
    EXPECT_FALSE(thin_jet(fine)->resolved());
    const RunRecord record = new_record(fine, "sph");
    EXPECT_DOUBLE_EQ(record.numbers.at("jet_spacing"), 0.0125);
    EXPECT_DOUBLE_EQ(record.numbers.at("jet_thickness"), thin_jet(scene)->thickness);
}

TEST(ThinJet, WhatWouldDoDoes) {
    for (const double thickness : {0.0104999, 0.0105, 0.3, 1.0, 2.9999})
        for (const double size : {1.0, 12.3}) {
            const std::string why = SprayJet{thickness, size}.why_not_resolved();
            const auto at = why.find("near_hull = ");
            ASSERT_NE(at, std::string::npos) << why;
            EXPECT_TRUE((SprayJet{thickness, 1e-3 * std::stod(why.substr(at + 12))}.resolved())) << why;
        }
    EXPECT_EQ((SprayJet{0.3, 0.1}.why_not_resolved()), "");
}

/// A section in a channel 1 m deep.
std::string in_channel(const std::string& hull) {
    return "[hull]\n" + hull + "\n[water]\ndepth = 1\n[motion]\nspeed = 10\n[resolution]\nnear_hull = 0.02\n" +
           "[domain]\ndimensions = 2\n";
}

// docs/decisions/024-hull-force-cured.md: 0.2645 and 0.0786 of the depth. Deep water's formula says 0.02 m for the first of them.
TEST(ThinJet, OfAFlatSectionIsTheChannels) {
    const std::string thick = "shape = \"plate\"\ntrim = \"30 deg\"\ndraft = 0.101338",
                      thin = "shape = \"plate\"\ntrim = \"10 deg\"\ndraft = 0.007811";
    EXPECT_NEAR(thickness(in_channel(thick)), 0.2645, 1e-4);
    EXPECT_NEAR(thickness(in_channel(thin)), 0.0786, 1e-4);
    const Scene scene = scene_of(with(in_channel(thin), "near_hull = 0.02", "near_hull = 0.05"));
    EXPECT_NE(to_text(scene, predict(scene))
                  .find("not resolved: the jet is 1.6 of a particle or cell thick, and three across it are needed "
                        "(near_hull = 26 mm)"),
              std::string::npos)
        << to_text(scene, predict(scene));
}

TEST(ThinJet, RoundSectionsAndTanksHaveNoneThatIsKnown) {
    EXPECT_EQ(thickness(in_channel("shape = \"sphere\"\ndraft = 0.1")), 0);
    EXPECT_EQ(thickness(in_channel("shape = \"plate\"\ntrim = \"0 deg\"\ndraft = 0.1")), 0);
}

}  // namespace thin_jet_test
}  // namespace tw::test
