// Streams whose water is of another depth behind: hydraulics of channels, the plan of both ends, and what is refused.
#include "scene/water/tailwater.h"

#include <fmt/format.h>

#include <cmath>

#include "scene/box/forcing_zones.h"
#include "scene/hash.h"
#include "scene/refined_places.h"
#include "scene/water/channel_flow.h"
#include "scene/water/water_blocks.h"
#include "scene_text.h"

namespace tw::test {
namespace tailwater_test {

constexpr double g = 9.81;

/// In two dimensions, from -1 to 2 m, particles of 10 mm; its water is `depth` deep.
std::string channel(double depth, double speed, const std::string& domain, const std::string& more = "") {
    return fmt::format(
               "[motion]\nkind = \"stream\"\nspeed = {}\n[domain]\nx = [-1, 2]\ny = [0, 0.01]\nz = [{}, 0.3]\n"
               "dimensions = 2\n{}[water]\ndepth = {}\n[resolution]\nnear_hull = 0.01\n",
               speed, -depth, domain, depth) +
           more;
}
std::string box(const std::string& name, const std::string& min, const std::string& max) {
    return "[[obstacle]]\nname = \"" + name + "\"\nmin = [" + min + "]\nmax = [" + max + "]\n";
}
/// 0.1 m above the bed of water 0.4 m deep; the jet of a sharp edge is 0.061 m thick.
const std::string gate = box("gate", "0, -1, -0.3", "0.02, 1, 0.2");
std::string names(const Scene& scene) {
    std::string all;
    for (const Finding& f : channel_flow(scene)) all += f.name + " ";
    return all;
}

TEST(ChannelFlow, CriticalDepthHasTheLeastEnergy) {
    const double q = 0.14, h = critical_depth(q, g), least = specific_energy(h, q / h, g);
    EXPECT_NEAR(least, 1.5 * h, 1e-12);
    for (const double other : {0.98 * h, 1.02 * h}) EXPECT_GT(specific_energy(other, q / other, g), least);
}

// Momentum and water are the same on both sides of a jump: q^2 / (g h) + h^2 / 2.
TEST(ChannelFlow, AJumpKeepsMomentumAndWater) {
    const double h = 0.05, U = 1.75, q = U * h, behind = conjugate_depth(h, U, g);
    EXPECT_NEAR(q * q / (g * h) + h * h / 2, q * q / (g * behind) + behind * behind / 2, 1e-12);
    EXPECT_GT(behind, 2 * h);
    EXPECT_NEAR(conjugate_depth(behind, q / behind, g), h, 1e-12);
}

// Bernoulli from the water ahead to the jet.
TEST(ChannelFlow, OfAGateKeepsItsEnergy) {
    const double b = 0.1, E = 0.408, q = through_gate(b, E, g), jet = contraction_of_gate * b;
    EXPECT_NEAR(specific_energy(jet, q / jet, g), E, 1e-12);
}

TEST(Tailwater, LeavesAsMuchWaterAsEnters) {
    const Scene s = scene_of(channel(0.4, 0.4, "downstream = 0.061\n", gate));
    const Tailwater t = tailwater(s).value();
    EXPECT_NEAR(t.speed * 0.061, 0.4 * 0.4, 1e-12);
    EXPECT_NEAR(t.level, -0.339, 1e-12);
    EXPECT_NEAR(t.begins, 0.01, 1e-12) << "the middle of the gate";
    EXPECT_FALSE(t.is_slow);
    EXPECT_GE(s.sph.c0, 10 * t.speed);
    const std::vector<Box> water = blocks_of_water(s);
    ASSERT_EQ(water.size(), 2);
    EXPECT_EQ(water[0].max.x(), water[1].min.x());
    EXPECT_EQ(water[0].max.z(), 0);
    EXPECT_NEAR(water[1].max.z(), t.level, 0.005);
    EXPECT_NEAR(water_volume(s), water[0].volume() + water[1].volume(), 1e-12);
    EXPECT_FALSE(tailwater(scene_of(channel(0.4, 0.4, "", gate))));
}

TEST(Tailwater, HasAZoneAtEachEndThatIsSlowerThanItsWaves) {
    const ForcingZones sluice = forcing_zones(scene_of(channel(0.4, 0.4, "downstream = 0.061\n", gate)));
    ASSERT_EQ(sluice.zones.size(), 1);
    EXPECT_FALSE(sluice.zones[0].high);
    EXPECT_EQ(sluice.zones[0].share, 1);
    const Scene s = scene_of(channel(0.05, 1.751, "downstream = 0.1535\n"));  // a hydraulic jump
    const ForcingZones jump = forcing_zones(s);
    ASSERT_EQ(jump.zones.size(), 1);
    EXPECT_TRUE(jump.zones[0].high);
    EXPECT_NEAR(jump.zones[0].share, 0.05 / 0.1535, 1e-12);
    const double speed = 1.751 * jump.zones[0].share;
    EXPECT_NEAR(s.domain.box.max.x() - 2, 1.5 * standing_wave_length(speed, g, 0.1535).value(), 0.01);
    EXPECT_NEAR(jump.zones[0].gamma, g / speed, 1e-9);
    EXPECT_EQ(s.domain.box.min.x(), -1);
    EXPECT_NEAR(tailwater(s)->begins, 0.5, 1e-12);
    const std::string weir = box("weir", "-0.2, -1, -0.2", "0.2, 1, -0.05");
    const ForcingZones both = forcing_zones(scene_of(channel(0.2, 0.1, "downstream = 0.16\n", weir)));
    ASSERT_EQ(both.zones.size(), 2);
    EXPECT_NEAR(both.zones[0].share, 1, 1e-12);
    EXPECT_NEAR(both.zones[1].share, 0.2 / 0.16, 1e-12);
}

// It is not a part of the hash of a scene that does not say it.
TEST(Tailwater, IsHashedWhereItIsWritten) {
    const std::string weir = box("weir", "-0.2, -1, -0.2", "0.2, 1, -0.05");
    const Scene without = scene_of(channel(0.2, 0.1, "", weir)),
                with = scene_of(channel(0.2, 0.1, "downstream = 0.16\n", weir));
    EXPECT_EQ(canonical_text(without).find("downstream"), std::string::npos);
    EXPECT_NE(with.hash, without.hash);
}

TEST(Tailwater, IsRefusedWhereNothingHoldsIt) {
    const auto said = [](const std::string& text) { return complaint(text); };
    EXPECT_NE(said(channel(0.4, 0.4, "downstream = 0.8\n", gate)).find("expected a higher domain"), std::string::npos);
    EXPECT_NE(said(channel(0.4, 0.4, "downstream = 0.03\n", gate)).find("too shallow"), std::string::npos);
    EXPECT_NE(said(channel(0.4, 0.4, "downstream = 0.061\n")).find("no obstacle makes it fast"), std::string::npos);
    EXPECT_NE(said(channel(0.4, 0.4, "downstream = 0.3\n", "[effects]\ngravity = \"off\"\n")).find("without gravity"),
              std::string::npos);
    EXPECT_NE(
        said(channel(0.4, 0.4, "downstream = 0.3\n", "[effects]\nforcing_zones = \"off\"\n")).find("switched off"),
        std::string::npos);
    EXPECT_NE(said(with(planing, "[resolution]", "[domain]\ndownstream = 0.5\n[resolution]")).find("a hull stands in"),
              std::string::npos);
    EXPECT_NE(said("[tank]\nsize = [1, 1, 1]\n[domain]\ndownstream = 0.5\n[resolution]\nnear_hull = 0.1\n"
                   "[[water_block]]\nmin = [0, 0, 0]\nmax = [1, 1, 0.5]\n")
                  .find("there is no stream"),
              std::string::npos);
    const std::string at = said(channel(0.4, 0.4, "downstream = 0.8\n", gate));
    EXPECT_NE(at.find("scene.toml:9:14: [domain] downstream"), std::string::npos) << at;
}

// Over a bump that is too high, or under a gate that is too low, the water does not pass at the depth with which it
// comes.
TEST(ChannelFlow, IsWarnedOfWhereItCannotBeWhatTheSceneSays) {
    const auto bump = [](const char* top) { return box("bump", "-0.4, -1, -0.2", std::string("0.4, 1, ") + top); };
    // E = 0.225 m, 1.5 h_c = 0.189 m: up to 36 mm
    EXPECT_EQ(names(scene_of(channel(0.2, 0.7, "", bump("-0.17")))), "");
    EXPECT_EQ(names(scene_of(channel(0.2, 0.7, "", bump("-0.15")))), "choked ");
    const Scene choked = scene_of(channel(0.2, 0.7, "", bump("-0.1")));
    const std::string why = channel_flow(choked).front().message;
    // E = 0.289 m: 0.277 m of water
    EXPECT_NE(why.find("rise from 0.2 to 0.275"), std::string::npos) << why;
    EXPECT_NE(to_text(choked, predict(choked)).find("choked"), std::string::npos);
    EXPECT_EQ(names(scene_of(channel(0.4, 0.398, "downstream = 0.061\n", gate))), "");
    EXPECT_EQ(names(scene_of(channel(0.4, 0.5, "downstream = 0.061\n", gate))), "choked ");
    EXPECT_EQ(names(scene_of(channel(0.4, 0.3, "downstream = 0.061\n", gate))), "gate_too_wide ");
    EXPECT_EQ(names(scene_of(channel(0.4, 0.3, "", gate))), "") << "drowned";
    EXPECT_EQ(names(scene_of(channel(0.05, 1.751, "downstream = 0.1535\n"))), "");
    EXPECT_EQ(names(scene_of(channel(0.05, 1.751, "downstream = 0.17\n"))), "jump_moves ");
}

// The zones of a stream lie outside the box that was asked for, so their particles may be twice as large.
TEST(CoarseZones, AreThereWhereTheSceneSaysSo) {
    const std::string slow = with(with(planing, "8 m/s", "1.879 m/s"), "duration = \"1.5 s\"\n", "");
    const Scene s = scene_of(slow + "[sph]\nzones = \"coarse\"\n"), fine = scene_of(slow);
    EXPECT_EQ(sizes_of_particles(s), 2);
    EXPECT_EQ(largest_particles(s), 0.1);
    EXPECT_EQ(sizes_of_particles(fine), 1);
    EXPECT_LT(predict(s).particles, 0.6 * predict(fine).particles);
    EXPECT_NE(run_hash(s, "sph"), run_hash(fine, "sph"));
    EXPECT_EQ(run_hash(s, "fvm"), run_hash(fine, "fvm"));
    EXPECT_EQ(run_hash(fine, "sph"), run_hash(scene_of(slow + one_size), "sph"));
    const auto refused = [](const std::string& text) -> std::string {
        const Scene scene = scene_of(text);
        try {
            predict(scene);
        } catch (const InputError& e) { return e.what(); }
        return {};
    };
    EXPECT_NE(refused(slow + "[sph]\nzones = \"coarse\"\nlevels = 2\n").find("one size in the box"), std::string::npos);
    EXPECT_NE(refused(planing + "[sph]\nlevels = 1\nzones = \"coarse\"\n").find("no forcing zones outside"),
              std::string::npos);
    const std::string text = to_text(s, predict(s));
    EXPECT_NE(text.find("they make "), std::string::npos) << text;
}

}  // namespace tailwater_test
}  // namespace tw::test
