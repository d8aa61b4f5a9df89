// Whether a run keeps its water: what the record's energies, masses and frames say of it.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string>

#include "base/numbers.h"
#include "compare/checks/checks.h"
#include "meshes/generate/shapes.h"
#include "record/raster.h"
#include "record/solid_at_rest.h"

namespace tw {
namespace water_checks_test {

constexpr double g = 9.81, rho = 1000;

/// A tank 2 x 1 x 1 m from z = -0.5 m on, with the given heights of the centre of mass [m] of its 1000 kg of water, which
/// fill it to z = 0 at rest (centre -0.25 m).
RunRecord tank(const std::vector<double>& centres, double kinetic = 0) {
    RunRecord r;
    r.attributes["motion"] = "none";
    r.numbers = {{"density", rho},      {"gravity", g},         {"dimensions", 3},     {"domain_x_min", -1.0},
                 {"domain_x_max", 1.0}, {"domain_y_min", -0.5}, {"domain_y_max", 0.5}, {"domain_z_min", -0.5},
                 {"domain_z_max", 0.5}, {"duration", 1.0}};
    Table& t = r.table("samples");
    for (std::size_t k = 0; k < centres.size(); ++k) {
        t.time.push_back(0.1 * static_cast<double>(k));
        t.column("mass", "kg").values.push_back(1000);
        t.column("potential_energy", "J").values.push_back(1000 * g * centres[k]);
        t.column("kinetic_energy", "J").values.push_back(k == 0 ? 0 : kinetic);
    }
    return r;
}

/// A block on the floor that takes half of the tank's breadth, up to z = -0.3 m, and reaches through the floor.
void put_block(RunRecord& r) {
    r.raster = RasterSpec{{-1, -0.5, -0.5}, 0.1, {20, 10, 10}};
    Surface step = block(2, 0.5, 0.4);
    const Box at = step.bounds();
    for (Vec3& p : step.points) p += Vec3(-1, -0.5, -0.7) - at.min;
    r.bodies.push_back({obstacle_table("step"), step, Vec3::Zero()});
}

TEST(WaterKept, StillWaterStandsAtTheLevelOfItsVolume) {
    const auto sunk = sunk_below_rest(tank({-0.25, -0.25}));
    ASSERT_TRUE(sunk);
    EXPECT_NEAR(sunk->value, 0, 1e-12);
}

TEST(WaterKept, WhatIsMissingOfTheVolumeIsToldWithItsTime) {
    // 12 % of the volume gone: depth 0.44 m, centre -0.28 m
    const auto sunk = sunk_below_rest(tank({-0.25, -0.28, -0.26}));
    ASSERT_TRUE(sunk);
    EXPECT_NEAR(sunk->value, 0.12, 1e-12);
    EXPECT_NEAR(sunk->time, 0.1, 1e-12);
}

TEST(WaterKept, WaterThatIsThrownUpIsNotMissing) {
    const auto sunk = sunk_below_rest(tank({-0.25, -0.2, 0.1}));
    ASSERT_TRUE(sunk);
    EXPECT_NEAR(sunk->value, 0, 1e-12);
}

TEST(WaterKept, SolidsTakeTheirRoomWithinTheTank) {
    // 2 x 0.5 x 0.2 m of block leave 0.8 m3 up to z = 0: 1 m3 stands 0.1 m higher, its centre at
    // (1 x 0.2 x -0.4 + 2 x 0.4 x -0.1) / 1 = -0.16 m
    RunRecord r = tank({-0.16});
    put_block(r);
    const auto sunk = sunk_below_rest(r);
    ASSERT_TRUE(sunk);
    EXPECT_NEAR(sunk->value, 0, 1e-9);
    RunRecord blind = tank({-0.16});
    EXPECT_LT(sunk_below_rest(blind)->value, -0.3) << "the block is what raises it";
}

TEST(WaterKept, NothingIsSaidOfStreamsAndTanksThatMove) {
    RunRecord stream = tank({-0.28}), moving = tank({-0.28});
    stream.attributes["motion"] = "stream";
    moving.attributes["tank_moves"] = "yes";
    EXPECT_FALSE(sunk_below_rest(stream));
    EXPECT_FALSE(sunk_below_rest(moving));
}

std::optional<ValidityCheck> gate(const RunRecord& r, const std::string& name) {
    for (const ValidityCheck& gate : checks_of(r, "SPH"))
        if (gate.name == name) return gate;
    return {};
}

TEST(WaterKept, MissingVolumeFailsACheck) {
    EXPECT_TRUE(gate(tank({-0.25, -0.2515}), "water below the level of its volume")->pass);
    EXPECT_FALSE(gate(tank({-0.25, -0.254}), "water below the level of its volume")->pass);
}

TEST(WaterKept, WaterThatShouldRestAndMovesFailsACheck) {
    const double energy = 1000 * g * 0.25;
    EXPECT_TRUE(gate(tank({-0.25, -0.25}, 5e-4 * energy), "motion of water at rest")->pass);
    EXPECT_FALSE(gate(tank({-0.25, -0.25}, 5e-3 * energy), "motion of water at rest")->pass);
    EXPECT_FALSE(gate(tank({-0.1, -0.25}, energy), "motion of water at rest")) << "a column that is let go may move";
    RunRecord body = tank({-0.25, -0.25}, energy);
    body.table("body_ball").append(0);
    EXPECT_FALSE(gate(body, "motion of water at rest")) << "a body moves it";
    RunRecord wave = tank({-0.25, -0.25}, 5e-3 * energy);
    wave.numbers["wave_period"] = 0.8;
    EXPECT_FALSE(gate(wave, "motion of water at rest")) << "a wave does";
}

/// A stream over 4 x 1 m, 0.5 m deep, with so much water in the box at each frame, and the given level at its inlet.
RunRecord stream(const std::vector<double>& mass, double level) {
    RunRecord r = tank({});
    r.attributes["motion"] = "stream";
    r.numbers["speed"] = 1, r.numbers["mean_from"] = 0.15, r.numbers["depth"] = 0.5;
    r.raster = RasterSpec{{-1, -0.5, -0.5}, 0.05, {40, 20, 20}};
    Raster raster(r.raster);
    for (double x = -0.975; x < 1; x += 0.05)
        for (double y = -0.475; y < 0.5; y += 0.05)
            for (double z = -0.475; z < (x < -0.8 ? level : 0) - 1e-9; z += 0.05)
                raster.pour({x, y, z}, 0.05, 0.05 * 0.05 * 0.05);
    Table& t = r.table("samples");
    for (std::size_t k = 0; k < mass.size(); ++k) {
        t.time.push_back(0.1 * static_cast<double>(k + 1));
        t.column("mass", "kg").values.push_back(mass[k]);
        r.frames.push_back(raster.frame(t.time.back()));
    }
    return r;
}

TEST(WaterKept, ABoxThatFillsFailsACheck) {
    EXPECT_TRUE(gate(stream({1200, 1000, 1005, 1002}, 0), "change of the water in the box")->pass)
        << "what happens before the means begin is the start";
    const auto filled = gate(stream({1000, 1000, 1200, 1414}, 0), "change of the water in the box");
    ASSERT_TRUE(filled);
    EXPECT_FALSE(filled->pass);
    EXPECT_NEAR(filled->value, 41.4, 1e-9);
}

/// A stream with waves of 0.8 s up to a time, whose box holds 1000 kg: 5 % more and less with each wave, and a share
/// `lost` of it gone at the end, at a steady rate.
RunRecord stream_with_waves(const char* period, double lost, double until = 8) {
    std::vector<double> mass;
    for (double t = 0.1; t < until + 0.05; t += 0.1)
        mass.push_back(1000 * (1 + 0.05 * std::sin(2 * pi * t / 0.8) - lost * t / until));
    RunRecord r = stream(mass, 0);
    r.numbers[period] = 0.8;
    r.frames.clear();  // which the check does not look at
    return r;
}

TEST(WaterKept, WaterThatSwingsWithTheWavesIsNotLost) {
    const char* const name = "change of the water in the box";
    for (const char* const period : {"wave_period", "sea_peak_period"}) {
        EXPECT_TRUE(gate(stream_with_waves(period, 0), name)->pass) << period;
        EXPECT_NEAR(gate(stream_with_waves(period, 0), name)->value, 0, 0.05) << period;
    }
    // of eight seconds nine whole periods: from the middle of the first to that of the last, of a sea from that of the first
    // four to that of the last four
    const auto lost = gate(stream_with_waves("wave_period", 0.02), name);
    EXPECT_FALSE(lost->pass);
    EXPECT_NEAR(lost->value, 2 * 6.4 / 8, 0.05);
    EXPECT_FALSE(gate(stream_with_waves("sea_peak_period", 0.03), name)->pass);
    EXPECT_NEAR(gate(stream_with_waves("sea_peak_period", 0.03), name)->value, 3 * 4.0 / 8, 0.05);
}

TEST(WaterKept, OfFewerThanTwoWavesTheChangeIsNotJudged) {
    const auto few = gate(stream_with_waves("wave_period", 0.3, 1.6), "change of the water in the box");
    ASSERT_TRUE(few);
    EXPECT_TRUE(few->warns && !few->pass && std::isnan(few->value));
    EXPECT_NE(few->remark.find("fewer than two whole wave periods of 0.8 s"), std::string::npos) << few->remark;
    EXPECT_FALSE(gate(stream_with_waves("wave_period", 0.3, 1.8), "change of the water in the box")->warns);
}

/// Of particles, with what has gone through its openings, row by row; means from the second row on.
RunRecord stream_of_particles(const std::vector<double>& count, const std::vector<double>& in,
                              const std::vector<double>& out) {
    RunRecord r = stream(std::vector<double>(count.size(), 1000), 0);
    Table& t = r.table("samples");
    t.column("particles", "-").values = count;
    t.column("particles_in", "-").values = in;
    t.column("particles_out", "-").values = out;
    return r;
}

TEST(WaterKept, ParticlesThatVanishFailTheirCheck) {
    const char* const unseen = "unexplained change of the number of particles";
    EXPECT_TRUE(gate(stream_of_particles({900, 905, 903, 903}, {0, 100, 200, 300}, {0, 95, 197, 297}), unseen)->pass);
    const auto gone = gate(stream_of_particles({900, 905, 902, 903}, {0, 100, 200, 300}, {0, 95, 197, 297}), unseen);
    ASSERT_TRUE(gone);
    EXPECT_FALSE(gone->pass);
    EXPECT_EQ(gone->value, 1);
    EXPECT_FALSE(gate(stream({1000, 1000}, 0), unseen)) << "a run of cells has none";
}

TEST(WaterKept, AStreamThatTakesInMoreThanItLetsOutFailsACheck) {
    const auto filling = [](double kept) {
        return gate(stream_of_particles({900, 900 + kept, 900 + 2 * kept, 900 + 3 * kept}, {0, 100, 200, 300},
                                        {0, 100 - kept, 200 - 2 * kept, 300 - 3 * kept}),
                    "inflow less outflow");
    };
    EXPECT_TRUE(filling(0.9)->pass);
    EXPECT_FALSE(filling(2)->pass);
    EXPECT_NEAR(filling(2)->value, 2, 1e-9);
}

/// Two particles a hundredth of a second come in, as many leave with waves of 0.8 s but for a share `kept`; 900 are there.
RunRecord particles_with_waves(double kept, double until) {
    std::vector<double> count, in, out;
    for (double t = 0.1; t < until + 0.05; t += 0.1) {
        in.push_back(200 * t), out.push_back(200 * t * (1 - kept) - 40 * std::sin(2 * pi * t / 0.8));
        count.push_back(900 + (in.back() - in[0]) - (out.back() - out[0]));
    }
    RunRecord r = stream_of_particles(count, in, out);
    r.numbers["wave_period"] = 0.8;
    return r;
}

TEST(WaterKept, WhatSwingsThroughTheOpeningsWithTheWavesDoesNotDrift) {
    const char* const name = "inflow less outflow";
    for (const double until : {1.0, 1.3, 7.9, 8.2}) {
        const auto swings = gate(particles_with_waves(0, until), name);
        ASSERT_TRUE(swings) << until;
        EXPECT_TRUE(swings->pass) << until << " s: " << swings->value;
        EXPECT_FALSE(gate(particles_with_waves(0.02, until), name)->pass) << until;
    }
    EXPECT_FALSE(gate(particles_with_waves(0, 0.8), name))
        << "of less than a period since the means begin nothing is known";
}

TEST(WaterKept, TheLevelIsThatBehindTheZoneAtTheInlet) {
    RunRecord r = stream({1000, 1000}, 0.05);
    r.numbers["domain_x_min"] -= 1;
    EXPECT_FALSE(gate(r, "level at the inlet")) << "the raster begins farther down the stream";
    r.numbers["undamped_x_min"] = r.numbers["domain_x_min"] + 1;
    EXPECT_FALSE(gate(r, "level at the inlet")->pass);
}

TEST(WaterKept, ALevelThatHasLeftTheScenesFailsACheck) {
    EXPECT_TRUE(gate(stream({1000, 1000}, 0), "level at the inlet")->pass);
    const auto raised = gate(stream({1000, 1000}, 0.05), "level at the inlet");
    ASSERT_TRUE(raised);
    EXPECT_FALSE(raised->pass);
    EXPECT_NEAR(raised->value, 10, 0.1);  // 0.05 of 0.5 m
}

}  // namespace water_checks_test
}  // namespace tw
