// A head or following wave in a stream: what it is seen from the hull, where it is made and absorbed, and what is refused.
#include <cmath>
#include <numbers>

#include "scene/box/forcing_zones.h"
#include "scene/box/inlet_wave.h"
#include "scene/box/tank_wave.h"
#include "scene/mesh/mesh_cells.h"
#include "scene/new_record.h"
#include "scene/summary/wave_text.h"
#include "scene_text.h"
#include "waves/dispersion.h"

namespace tw::test {
namespace stream_wave_test {

using std::numbers::pi;

std::string stream(const std::string& wave = "height = 0.06\nlength = 1\n", const std::string& more = "",
                   double speed = 0.6) {
    return "[motion]\nkind = \"stream\"\nspeed = " + std::to_string(speed) +
           "\n[domain]\nx = [-1, 1]\ny = [0, 0.01]\nz = [-0.4, 0.15]\ndimensions = 2\n[water]\ndepth = 0.4\n[wave]\n" +
           wave + "[resolution]\nnear_hull = 0.01\n" + more;
}

TEST(StreamWave, IsThatOfStillWaterCarriedByTheStream) {
    const Scene s = scene_of(stream("height = 0.06\nlength = 1\ntheory = \"linear\"\n"));
    ASSERT_TRUE(s.wave);
    const double k = 2 * pi, omega = wave_frequency(k, s.water.gravity, 0.4);
    EXPECT_NEAR(s.wave->encounter_frequency(), omega + 0.6 * k, 1e-9);
    EXPECT_NEAR(wave_scales(s).period, 2 * pi / (omega + 0.6 * k), 1e-9);
    EXPECT_NEAR(wave_scales(s).slowest, 0.6 + group_speed_ratio(k * 0.4) * omega / k, 1e-9);
    EXPECT_NEAR(s.wave->sum.current, 0.6, 1e-12);  // in open water nothing takes back what the wave carries along
    const Scene of_period = scene_of(stream("height = 0.06\nperiod = 0.8\n"));  // as one who drifts sees it
    EXPECT_NEAR(of_period.wave->period_in_water(), 0.8, 1e-9);
    EXPECT_LT(of_period.wave->encounter_period(), 0.6);
}

/// A box 0.4 m long in a stream of 0.6 m/s with a head wave; without `below` the floor is where the hull's length has it.
std::string box_in_head_wave(const std::string& domain) {
    return "[hull]\nshape = \"box\"\nlength = 0.41\nbeam = 1\nheight = 0.16\ndraft = 0.06\n[motion]\nkind = "
           "\"stream\"\nspeed = 0.6\n[domain]\n" +
           domain + "[wave]\nheight = 0.06\nlength = 1\n[resolution]\nnear_hull = 0.0125\n";
}

TEST(StreamWave, RunsInWaterAsDeepAsItIsComputedFor) {
    const Scene s = scene_of(box_in_head_wave("dimensions = 2\n"));
    ASSERT_TRUE(s.wave);
    EXPECT_NEAR(s.wave->depth, -s.domain.box.min.z(), 1e-12);
    EXPECT_GT(std::abs(std::remainder(s.wave->depth, s.resolution.spacing)), 1e-3) << "else nothing is rounded";
}

// Runs of a grid study are of one scene: what follows from the box may not follow from how it was rounded.
TEST(StreamWave, IsMeasuredFromTheSameTimeOnAtEverySize) {
    for (const char* speed : {"0.6", "3"}) {  // made in a zone; enters with the stream
        std::string text = box_in_head_wave("ahead = 0.83\nbehind = 0.77\nbelow = 0.4\ndimensions = 2\n");
        text.replace(text.find("speed = 0.6"), 11, std::string("speed = ") + speed);
        SceneOverrides coarser;
        coarser.scale_resolution = 1.19;
        const Scene s = scene_of(text), c = scene_of(text, coarser);
        EXPECT_NE(s.domain.box.size().x(), c.domain.box.size().x()) << "else nothing is rounded";
        EXPECT_NEAR(s.sampling.mean_from, c.sampling.mean_from, 1e-9) << speed;
        EXPECT_NEAR(s.run.duration, c.run.duration, 1e-9) << speed;
    }
}

TEST(StreamWave, HasItsOwnStepsBesideASectionWithSmallerCells) {
    const Scene s = scene_of(box_in_head_wave("dimensions = 2\nbelow = 0.4\n"));
    EXPECT_NEAR(finest_cell(s), s.resolution.near_hull / 4, 1e-12);
    EXPECT_NEAR(s.fvm.max_courant, 0.6, 1e-9);
    const Scene whole = scene_of(box_in_head_wave("below = 0.4\n"));
    EXPECT_NEAR(whole.fvm.max_courant, 0.15, 1e-9) << "three dimensions";
}

TEST(StreamWave, IsMadeAheadAndAbsorbedBehindOutsideTheBox) {
    const Scene s = scene_of(stream());
    const Box &all = s.domain.box, &open = s.domain.undamped;
    EXPECT_NEAR(open.min.x(), -1, 1e-12);
    EXPECT_NEAR(all.min.x(), -2.5, 1e-9);
    EXPECT_NEAR(all.max.x(), 2, 1e-9);  // the stream's own wave, of 0.23 m, asks for less
    const ForcingZones plan = forcing_zones(s);
    ASSERT_EQ(plan.zones.size(), 2);
    const double gamma = 1.5 * s.wave->encounter_frequency() / std::sqrt(std::tanh(s.wave->k() * 0.4));
    EXPECT_TRUE(plan.zones[0].makes_wave);
    EXPECT_NEAR(plan.zones[0].gamma, 1.5 * gamma, 1e-9);
    EXPECT_FALSE(plan.zones[1].makes_wave);
    EXPECT_NEAR(plan.zones[1].gamma, gamma, 1e-9);
    EXPECT_EQ(plan.speed, 0.6);
    EXPECT_FALSE(begins_with_wave(s));
    ASSERT_EQ(grown_zones(s).size(), 1);  // where the wave is made cells keep their size
    EXPECT_TRUE(grown_zones(s)[0].high);
}

TEST(StreamWave, IsAbsorbedAsGentlyAsTheStreamsOwnWavesNeed) {
    // 1.2 m/s: a wave of about 1 m stands, for which the zone behind is 1.5 m wide; the wave of 0.7 m needs half of that
    const Scene s = scene_of(stream("height = 0.06\nlength = 0.7\n", "", 1.2));
    const ForcingZones plan = forcing_zones(s);
    ASSERT_EQ(plan.zones.size(), 2);
    const double width = plan.zones[1].end - plan.zones[1].begin,
                 gamma = 1.5 * s.wave->encounter_frequency() / std::sqrt(std::tanh(s.wave->k() * 0.4));
    EXPECT_GT(width, 0.7);
    EXPECT_NEAR(plan.zones[1].gamma, gamma * 0.7 / width, 1e-9);
}

TEST(StreamWave, ThatFollowsIsMadeWhereItsEnergyComesFrom) {
    const std::string follows = "height = 0.06\nlength = 1\ntheory = \"linear\"\ndirection = \"180 deg\"\n";
    const double k = 2 * pi;
    for (const double U : {0.3, 1.6}) {  // the wave runs at 1.24 m/s, its energy at 0.64 m/s
        const Scene s = scene_of(stream(follows, "", U));
        const double omega = wave_frequency(k, s.water.gravity, 0.4), group = group_speed_ratio(k * 0.4) * omega / k;
        const WaveScales wave = wave_scales(s);
        EXPECT_NEAR(s.wave->encounter_frequency(), omega - U * k, 1e-9);
        EXPECT_NEAR(wave.period, 2 * pi / std::abs(omega - U * k), 1e-9);
        EXPECT_NEAR(wave.slowest, std::abs(U - group), 1e-9);
        EXPECT_EQ(wave.comes_from_low_x, U > group);
        const ForcingZones plan = forcing_zones(s);
        ASSERT_EQ(plan.zones.size(), 2);
        EXPECT_EQ(plan.zones[0].makes_wave, U > group);
        EXPECT_EQ(plan.zones[1].makes_wave, U < group);
        for (const ForcingZone& zone : plan.zones) {
            // with the g/U of the slow stream's own waves, of 6 cm, the zone ahead would be a wall to this one
            const double gamma = 1.5 * omega * wave.slowest / group / std::sqrt(std::tanh(k * 0.4));
            if (U < group) { EXPECT_NEAR(zone.gamma, (zone.makes_wave ? 1.5 : 1) * gamma, 1e-9); }
            EXPECT_GT(zone.gamma, 0);
            EXPECT_GE(std::abs(zone.end - zone.begin), (zone.makes_wave ? 1.5 : 1) + (U > group ? 0.5 : 0) - 1e-9);
        }
        // as it is met: the hull overtakes the second one
        EXPECT_EQ(new_record(s, "sph").numbers.at("wave_direction"), U > omega / k ? 1 : -1);
        EXPECT_GE(s.sampling.mean_from, s.motion.ramp + 3 * wave.period + 3.5 / wave.slowest - 1e-9);
    }
}

TEST(StreamWave, ThatFollowsIsSaidToHaveLessOfItsHeightNearTheSpeedOfItsEnergy) {
    const std::string follows = "height = 0.06\nlength = 1\ndirection = \"180 deg\"\n";  // its energy: 0.65 m/s
    const auto says = [&](double U) {
        return wave_text(scene_of(stream(follows, "", U))).find("within 15 %") != std::string::npos;
    };
    EXPECT_TRUE(says(0.42));
    EXPECT_FALSE(says(0.3));
}

TEST(StreamWave, IsMeasuredOnceItHasPassed) {
    const Scene s = scene_of(stream());
    const WaveScales wave = wave_scales(s);
    EXPECT_GE(s.sampling.mean_from, s.motion.ramp + 3 * wave.period + 3.5 / wave.slowest - 1e-9);
    EXPECT_NEAR(s.run.duration - s.sampling.mean_from, 7 * wave.period, 1e-9);
    EXPECT_LE(s.sampling.interval, wave.period / 25 + 1e-12);
    EXPECT_EQ(s.fvm.max_courant, 0.15);
}

TEST(StreamWave, EntersWithAStreamThatIsFasterThanItWhereNothingRunsUpstream) {
    const std::string wave = "height = 0.06\nlength = 1\n", off = "[effects]\nforcing_zones = \"off\"\n";
    const auto zones_of = [](const Scene& s) { return forcing_zones(s).zones.size(); };
    for (const Scene& s :
         {scene_of(stream(wave, "", 2.5)),      // above the critical speed no wave stands
          scene_of(stream(wave, off, 1.6))}) {  // below it the scene may say so; the wave's is 1.26 m/s
        const auto enters = inlet_wave(s);
        ASSERT_TRUE(enters);
        EXPECT_EQ(enters->begin, s.motion.ramp);
        EXPECT_NEAR(enters->ramp, s.wave->encounter_period(), 1e-12);
        EXPECT_EQ(zones_of(s), 0);
        EXPECT_EQ(s.domain.box.min.x(), s.domain.as_asked.min.x());
        EXPECT_GE(s.sampling.mean_from, enters->begin + 3 * enters->ramp);
        EXPECT_GT(s.sph.alpha, 0.005);  // it has no long way to keep its height on
        // steps of a 250th of the period, the same for all scales
        EXPECT_NEAR(s.fvm.max_courant, s.motion.speed * enters->ramp / 250 / 0.01, 1e-9);
    }
    SceneOverrides coarser;
    coarser.scale_resolution = 2;
    EXPECT_NEAR(scene_of(stream(wave, "", 2.5), coarser).fvm.max_courant,
                scene_of(stream(wave, "", 2.5)).fvm.max_courant, 1e-9);
    EXPECT_EQ(scene_of(stream("height = 0.06\nlength = 2.5\n", "", 3.5)).fvm.max_courant, 0.5);
    for (const Scene& s : {scene_of(stream(wave, "", 1.6)), scene_of(stream(wave, "", 0.6)),
                           scene_of(stream(wave, "[effects]\nforcing_zones = \"on\"\n", 1.6))}) {
        EXPECT_FALSE(inlet_wave(s));
        EXPECT_EQ(zones_of(s), 2);
    }
    EXPECT_NE(complaint(stream(wave, off, 1.2)).find("of at least their own speed"), std::string::npos);
    EXPECT_NE(complaint(stream(wave, off, 1.2)).find("1.2"), std::string::npos);
    EXPECT_TRUE(inlet_wave(scene_of(stream("height = 0.006\nlength = 1\n", "", 2.5))));  // 0.6 sizes high
    EXPECT_NE(complaint(stream("height = 0.004\nlength = 1\n", "", 2.5)).find("at least 0.5 "), std::string::npos);
}

TEST(StreamWave, RefusesWhatItCannotMake) {
    const auto refused = [](const std::string& text, const std::string& part) {
        const std::string said = complaint(text);
        EXPECT_NE(said.find(part), std::string::npos) << said;
        EXPECT_NE(said.find("scene.toml:"), std::string::npos) << said;
    };
    const std::string follows =
        "height = 0.06\nlength = 1\ndirection = \"180 deg\"\n";  // 1.26 m/s, its energy 0.65 m/s
    for (const double speed : {0.5, 0.6, 0.9, 1.2, 1.3, 1.4})
        refused(stream(follows, "", speed), "expected a stream of at most 0.4");
    refused(stream(follows, "", 2), "1.5 times the wave's speed");
    refused(stream(follows, "", 0.1), "under its crests");
    refused(stream("height = 0.06\nlength = 1\ndirection = \"30 deg\"\n"), "two dimensions have no oblique waves");
    refused(stream("height = 0.06\nlength = 1\n", "", 1.95), "expected a stream of at most");
    refused(stream("height = 0.06\nlength = 1\n", "", 0.1), "would leave through the inlet");
    refused(stream("height = 0.12\nlength = 1\n", "") + "[effects]\nforcing_zones = \"off\"\n", "made and absorbed");
    refused(stream("height = 0.02\nlength = 1\n"), "near_hull at most");
    refused(with(stream(), "depth = 0.4", "depth = 0.4\n[sph]\nlevels = 2"), "levels");
}

}  // namespace stream_wave_test
}  // namespace tw::test
