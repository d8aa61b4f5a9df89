// What gauges tell of a regular wave: height, crest and trough over whole periods, and the part that comes back.
#include "compare/metrics/regular_wave.h"
#include "compare/metrics/forces.h"
#include "compare/metrics/hull_motion.h"
#include "compare/metrics/wave_analysis.h"
#include "compare/metrics/wave_peaks.h"
#include "record/hull_motion.h"
#include "record/wave_twin.h"

#include <fmt/format.h>
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <numbers>

namespace tw::test {
namespace regular_wave_test {

using std::numbers::pi;
using Complex = std::complex<double>;

TEST(SplitWaves, FindsWhatWasPutTogether) {
    const double k = 2 * pi;
    const Complex incident = std::polar(0.02, 0.4), reflected = std::polar(0.0007, -1.1);
    for (const std::vector<double>& x : {std::vector<double>{0.1, 0.33}, std::vector<double>{0, 0.2, 0.6}}) {
        std::vector<Complex> amplitudes;
        for (const double at : x)
            amplitudes.push_back(incident * std::polar(1.0, k * at) + reflected * std::polar(1.0, -k * at));
        const WaveParts parts = split_waves(x, amplitudes, k);
        ASSERT_TRUE(parts.apart);
        EXPECT_NEAR(std::abs(parts.incident - incident), 0, 1e-12);
        EXPECT_NEAR(std::abs(parts.reflected - reflected), 0, 1e-12);
        EXPECT_NEAR(parts.misfit, 0, 1e-9);
    }
}

TEST(SplitWaves, CannotTellThemApartHalfAWaveLengthFromEachOther) {
    const std::vector<double> x{0, 0.5, 1};
    const std::vector<Complex> amplitudes(3, 0.01);
    EXPECT_FALSE(split_waves(x, amplitudes, 2 * pi).apart);
}

TEST(SplitDecayingWaves, FindLossAndLengthBesideTheReflection) {
    const double k = 2 * pi;
    const Complex incident = std::polar(0.02, 0.4), reflected = std::polar(0.0004, -1.1), kappa(1.013 * k, 0.06);
    for (const std::vector<double>& x :
         {std::vector<double>{-0.3, -0.1, 0.3}, std::vector<double>{0, 0.2, 0.33, 0.6}}) {
        double middle = 0;
        for (const double at : x) middle += at / static_cast<double>(x.size());
        std::vector<Complex> amplitudes;
        for (const double at : x)
            amplitudes.push_back(incident * std::exp(Complex(0, 1) * kappa * (at - middle)) +
                                 reflected * std::exp(-Complex(0, 1) * kappa * (at - middle)));
        const DecayingParts parts = split_decaying_waves(x, amplitudes, k);
        ASSERT_TRUE(parts.apart);
        EXPECT_NEAR(std::abs(parts.incident - incident), 0, 1e-10);
        EXPECT_NEAR(std::abs(parts.reflected - reflected), 0, 1e-10);
        EXPECT_NEAR(std::abs(parts.kappa - kappa), 0, 1e-8);
        // a wave of constant height and the theory's length does not fit, and its reflection is wrong
        EXPECT_GT(split_waves(x, amplitudes, k).misfit, 0.005);
    }
    EXPECT_FALSE(split_decaying_waves(std::vector<double>{0, 0.2}, std::vector<Complex>{0.02, 0.01}, k).apart);
}

/// Waves of 1 m and 0.8 s with a second harmonic, and 3 % of the first coming back, at three gauges.
RunRecord tank(double height, double reflection) {
    RunRecord r;
    r.attributes = {{"method", "sph"}, {"state", "finished"}};
    r.state = "finished";
    r.numbers = {{"wave_period", 0.8},    {"wave_length", 1}, {"wave_direction", -1}, {"wave_crest", 0.022},
                 {"wave_trough", -0.018}, {"mean_from", 2},   {"duration", 9}};
    const std::pair<const char*, double> gauges[] = {{"a", -0.3}, {"b", -0.1}, {"c", 0.3}};
    Table& table = r.table("height");
    for (double t = 0; t < 9; t += 0.03) {
        const std::size_t row = table.append(t);
        for (const auto& [name, x] : gauges) {
            const double in = -2 * pi * x - 2 * pi / 0.8 * t, back = 2 * pi * x - 2 * pi / 0.8 * t;
            table.set(row, name, "m",
                      height / 2 * std::cos(in) + 0.05 * height * std::cos(2 * in) +
                          reflection * height / 2 * std::cos(back + 1));
            r.numbers[std::string("height_x_") + name] = x;
        }
    }
    return r;
}

TEST(RegularWaveMeasure, GivesHeightsAndReflectionOfARecord) {
    Comparison c;
    c.sources = {tank(0.04, 0), tank(0.04, 0.03)};
    c.names = {"sph", "fvm"};
    add_regular_wave(c);
    const Quantity* height = c.find("wave_height:b");
    ASSERT_TRUE(height);
    EXPECT_NEAR(height->values[0].value, 0.04, 1e-5);
    EXPECT_LT(height->values[0].half_width, 1e-5);
    // 22 mm and -18 mm: a second harmonic of an eighth of the height lifts crest and trough
    EXPECT_NEAR(c.find("wave_crest:b")->values[0].value, 0.022, 1e-5);
    EXPECT_NEAR(c.find("wave_trough:b")->values[0].value, -0.018, 1e-5);
    const Quantity* reflection = c.find("wave_reflection");
    ASSERT_TRUE(reflection);
    EXPECT_NEAR(reflection->values[0].value, 0, 1e-6);
    EXPECT_NEAR(c.find("wave_loss")->values[0].value, 0, 1e-6);
    EXPECT_NEAR(reflection->values[1].value, 3, 0.01);
    EXPECT_EQ(c.references.size(), 9);
}

/// A wave of 1 m and 0.8 s that runs towards -x and meets a breakwater from x = 0.2 to 0 m: 70 % of it come back, 25 % pass,
/// and a tenth of these comes back from the tank's end.
RunRecord past_breakwater() {
    RunRecord r;
    r.attributes = {{"method", "sph"}, {"state", "finished"}};
    r.state = "finished";
    r.numbers = {{"wave_period", 0.8}, {"wave_length", 1},         {"wave_direction", -1},      {"mean_from", 2},
                 {"duration", 9},      {"obstacle_x_min_wall", 0}, {"obstacle_x_max_wall", 0.2}};
    Table& table = r.table("height");
    for (double t = 0; t < 9; t += 0.03) {
        const std::size_t row = table.append(t);
        for (const auto& [name, x] :
             {std::pair{"a", 0.95}, {"b", 0.75}, {"c", 0.4}, {"on_top", 0.1}, {"d", -0.3}, {"e", -0.53}}) {
            const double in = -2 * pi * x - 2 * pi / 0.8 * t, back = 2 * pi * x - 2 * pi / 0.8 * t, passed = x < 0.1;
            table.set(row, name, "m",
                      x == 0.1
                          ? 0.05
                          : (passed ? 0.25 : 1) * 0.02 * (std::cos(in) + (passed ? 0.1 : 0.7) * std::cos(back + 1)));
            r.numbers[std::string("height_x_") + name] = x;
        }
    }
    return r;
}

TEST(RegularWaveMeasure, TellsWhatABreakwaterReflectsFromWhatItLetsPass) {
    Comparison c;
    c.sources = {past_breakwater(), past_breakwater()};
    c.sources[1].tables["height"].columns.pop_back();  // one gauge behind: with what comes back there
    c.names = {"sph", "fvm"};
    add_regular_wave(c);
    const Quantity *reflection = c.find("wave_reflection"), *transmission = c.find("wave_transmission");
    ASSERT_TRUE(reflection && transmission);
    EXPECT_NEAR(reflection->values[0].value, 70, 0.01);
    EXPECT_NEAR(transmission->values[0].value, 25, 0.01);
    EXPECT_LT(transmission->values[0].half_width, 0.01);
    const double with_back = 25 * std::abs(1.0 + 0.1 * std::polar(1.0, 4 * pi * -0.3 + 1));
    EXPECT_NEAR(transmission->values[1].value, with_back, 0.02);
    EXPECT_TRUE(transmission->judged_in_grid_study);
}

TEST(RegularWaveMeasure, TellsWhatAFloatingBodySendsBackFromTheGaugesBeforeIt) {
    Comparison c;
    c.sources = {past_breakwater()};
    auto& numbers = c.sources[0].numbers;
    for (const char* end : {"min", "max"}) {
        auto number = numbers.extract(fmt::format("obstacle_x_{}_wall", end));
        number.key() = fmt::format("body_x_{}_float", end);
        numbers.insert(std::move(number));
    }
    c.names = {"sph"};
    add_regular_wave(c);
    EXPECT_NEAR(c.find("wave_reflection")->values[0].value, 70, 0.01);
    EXPECT_NEAR(c.find("wave_transmission")->values[0].value, 25, 0.01);
}

TEST(RegularWaveMeasure, GivesNoTransmissionWithoutGaugesOnBothSides) {
    Comparison c;
    c.sources = {past_breakwater()};
    c.sources[0].numbers["obstacle_x_min_wall"] = -2;  // a slope up to the tank's end, under the last gauges
    c.names = {"sph"};
    add_regular_wave(c);
    EXPECT_FALSE(c.find("wave_transmission"));
    ASSERT_TRUE(c.find("wave_reflection"));
    c.sources = {past_breakwater()};
    for (const char* gauge : {"a", "b"}) c.sources[0].numbers.erase(std::string("height_x_") + gauge);
    c.quantities.clear();
    add_regular_wave(c);
    EXPECT_FALSE(c.find("wave_transmission")->values[0].known) << "one gauge does not tell what runs towards the wall";
}

TEST(RegularWaveMeasure, GivesNoReflectionInAStream) {
    Comparison c;
    c.sources = {tank(0.04, 0)};
    c.sources[0].numbers["speed"] = 0.6;
    c.names = {"sph"};
    add_regular_wave(c);
    EXPECT_TRUE(c.find("wave_height:b"));
    EXPECT_TRUE(c.find("wave_loss"));
    EXPECT_FALSE(c.find("wave_reflection"));
}

TEST(RegularWaveMeasure, GivesHowFarABodyHeavesAndPitches) {
    Comparison c;
    for (const double heave : {0.025, 0.024}) {
        RunRecord r = tank(0.04, 0);
        r.numbers["wave_height"] = 0.04;
        Table& table = r.table("body_box");
        for (double t = 0; t < 9; t += 0.03) {
            const double angle = 2 * pi / 0.8 * t, turn = 0.05 * std::cos(angle + 0.7);
            const std::size_t row = table.append(t);
            table.set(row, "z", "m", -0.003 + heave * std::cos(angle + 0.3));
            table.set(row, "q0", "-", std::cos(turn / 2));
            table.set(row, "qy", "-", std::sin(turn / 2));
        }
        c.sources.push_back(r);
    }
    c.names = {"sph", "fvm"};
    add_regular_wave(c);
    const Quantity *heave = c.find("heave_response:box"), *pitch = c.find("pitch_response:box");
    ASSERT_TRUE(heave && pitch);
    EXPECT_NEAR(heave->values[0].value, 1.25, 1e-4);
    EXPECT_NEAR(heave->values[1].value, 1.2, 1e-4);
    EXPECT_NEAR(pitch->values[0].value, 0.05 / (pi * 0.04), 1e-4);
    for (RunRecord& r : c.sources)
        for (Column& column : r.tables["body_box"].columns)
            if (column.name == "z") std::ranges::fill(column.values, -0.003);
    c.quantities.clear();
    add_regular_wave(c);
    EXPECT_FALSE(c.find("heave_response:box")) << "a body that is held in heave has no response";
    EXPECT_TRUE(c.find("pitch_response:box"));
}

/// A box in waves that are made too low, lose height as time goes on, and are followed 1.25 times; levels without it are
/// those of `twin_share` of the wave.
RunRecord box_in_waves(double twin_share) {
    RunRecord r = tank(0.04, 0);
    r.numbers["wave_height"] = 0.04;
    Table &motion = r.table("body_box"), &level = r.table(std::string(empty_twin_table));
    for (double t = 0; t < 9; t += 0.03) {
        const double wave = 0.018 * (1 - 0.02 * t), angle = 2 * pi / 0.8 * t;
        std::size_t row = motion.append(t);
        motion.set(row, "z", "m", 1.25 * wave * std::cos(angle + 0.3));
        motion.set(row, "q0", "-", 1);
        motion.set(row, "qy", "-", 0.5 * 2 * pi * 0.7 * wave * std::cos(angle));  // turns 0.7 times the slope k a
        if (twin_share > 0)
            level.set(level.append(t), gauge_of_empty_twin("box"), "m", twin_share * wave * std::cos(angle + 0.3 + pi));
    }
    if (twin_share == 0) r.tables.erase(std::string(empty_twin_table));
    return r;
}

TEST(RegularWaveMeasure, GivesAResponseOverTheWaveOfTheRunWithoutTheBody) {
    Comparison c;
    c.sources = {box_in_waves(1), box_in_waves(0.9)};
    c.names = {"sph", "fvm"};
    add_regular_wave(c);
    const Quantity *over_wave = c.find("heave_over_wave:box"), *asked = c.find("heave_response:box"),
                   *wave = c.find("wave_without:box"), *pitch = c.find("pitch_over_wave:box");
    ASSERT_TRUE(over_wave && asked && wave && pitch);
    EXPECT_NEAR(over_wave->values[0].value, 1.25, 1e-4);
    EXPECT_LT(over_wave->values[0].half_width, 1e-4) << "what both lose as time goes on is not scatter";
    EXPECT_GT(asked->values[0].half_width, 0.01);
    EXPECT_NEAR(over_wave->values[1].value, 1.25 / 0.9, 1e-4) << "a lower wave, followed farther";
    EXPECT_NEAR(pitch->values[0].value, 0.7, 3e-3);
    EXPECT_NEAR(asked->values[0].value, asked->values[1].value, 1e-12);
    EXPECT_NEAR(wave->values[0].value, 0.036 * (1 - 0.02 * 5.77), 5e-5);  // eight periods to 8.97 s
    EXPECT_EQ(asked->definition.find("no run without"), std::string::npos);
}

TEST(RegularWaveMeasure, NamesAMissingRunWithoutTheBodyAndMixesNothing) {
    Comparison c;
    c.sources = {box_in_waves(1), box_in_waves(0)};
    c.sources[1].attributes[std::string(no_wave_twin)] = "it is not finished";
    c.names = {"sph", "fvm"};
    add_regular_wave(c);
    const Quantity *over_wave = c.find("heave_over_wave:box"), *asked = c.find("heave_response:box");
    ASSERT_TRUE(over_wave && asked);
    EXPECT_TRUE(over_wave->values[0].known);
    EXPECT_FALSE(over_wave->values[1].known);
    EXPECT_NE(asked->definition.find("no run without the body counts (interFoam: it is not finished)"),
              std::string::npos)
        << asked->definition;
    c.sources = {box_in_waves(0)};
    c.names = {"sph"};
    c.quantities.clear();
    add_regular_wave(c);
    EXPECT_FALSE(c.find("heave_over_wave:box") || c.find("wave_without:box"));
    EXPECT_NE(c.find("heave_response:box")->definition.find("(SPH: it was not run)"), std::string::npos);
}

/// A hull 1 m long, its centre of mass at x = 0.4 m, that heaves 1.1 times the wave and pitches 0.8 times its slope, by
/// 40 and 100 degrees before the crest that passes its centre.
RunRecord hull_in_waves() {
    RunRecord r = tank(0.04, 0);
    r.numbers["wave_height"] = 0.04;
    r.numbers["wave_direction"] = 1;
    r.numbers["speed"] = 2;
    Surface hull;
    hull.points = {{-0.1, 0, 0}, {0.9, 0, 0}, {0.4, 0.1, 0.1}};
    hull.triangles = {{0, 1, 2}};
    r.bodies.push_back({hull_motion_table, hull, Vec3(0.4, 0, 0.02)});
    Table& motion = r.table(hull_motion_table);
    const double omega = 2 * pi / 0.8, heave = 0.022, pitch = 0.8 * pi * 0.04 * 180 / pi;
    for (double t = 0; t < 9; t += 0.005) {
        const double crest = omega * t - 2 * pi * 0.4, h = crest + 40 * pi / 180, p = crest + 100 * pi / 180;
        const std::size_t row = motion.append(t);
        motion.set(row, "z", "m", 0.02 + heave * std::cos(h));
        motion.set(row, "vz", "m/s", -heave * omega * std::sin(h));
        motion.set(row, "trim", "deg", 4 + pitch * std::cos(p));
        motion.set(row, "trim_rate", "deg/s", -pitch * omega * std::sin(p));
    }
    return r;
}

TEST(RegularWaveMeasure, GivesResponsePhaseAndAccelerationOfAFreeHull) {
    Comparison c;
    c.sources = {hull_in_waves()};
    c.names = {"sph"};
    add_regular_wave(c);
    add_wave_peaks(c);
    const auto value = [&](const char* name) {
        const Quantity* q = c.find(name);
        return q && q->values[0].known ? q->values[0].value : NAN;
    };
    EXPECT_NEAR(value("heave_response:hull"), 1.1, 1e-3);
    EXPECT_NEAR(value("pitch_response:hull"), 0.8, 1e-3);
    EXPECT_NEAR(value("heave_phase:hull"), 40, 0.1);
    EXPECT_NEAR(value("pitch_phase:hull"), 100, 0.1);
    // over a fortieth of the period a harmonic's is lower by (pi/40)^2/6
    const double omega = 2 * pi / 0.8, less = 1 - std::pow(pi / 40, 2) / 6;
    EXPECT_NEAR(value("acceleration_centre:hull"), 0.022 * omega * omega * less, 2e-3);
    // the bow, 0.5 m ahead: both motions together
    const double bow = std::abs(std::polar(0.022, 40 * pi / 180) + 0.5 * std::polar(0.8 * pi * 0.04, 100 * pi / 180));
    EXPECT_NEAR(value("acceleration_bow:hull"), bow * omega * omega * less, 0.01);
    EXPECT_FALSE(porpoising(c.sources[0])) << "the wave drives it";
    c.sources[0].numbers.erase("wave_period");
    EXPECT_TRUE(porpoising(c.sources[0])) << "and without a wave nothing does";
}

TEST(RegularWaveMeasure, GivesWhatTheWaveAddsToACalmRun) {
    Comparison c;
    c.sources = {hull_in_waves(), hull_in_waves()};
    c.names = {"sph", "fvm"};
    RunRecord& r = c.sources[0];
    Table &forces = r.table("forces"), &calm = r.table(std::string(calm_forces_table)),
          &motion = r.table(std::string(calm_motion_table));
    for (double t = 0; t < 9; t += 0.005) {
        const double angle = 2 * pi / 0.8 * t, settled = t > 1 ? 0 : 5;
        forces.set(forces.append(t), "fx", "N", 14 + 30 * std::cos(angle) + 3 * std::cos(2 * angle));
        calm.set(calm.append(t), "fx", "N", 11 + settled + 0.1 * std::sin(40 * t));
        const std::size_t row = motion.append(t);
        motion.set(row, "z", "m", 0.015);
        motion.set(row, "trim", "deg", 3.8);
    }
    const MeanValue in_waves = mean_of(r, "forces", "fx", {});
    ASSERT_TRUE(in_waves.known) << "what a wave drives does not settle: " << in_waves.why_not;
    EXPECT_NEAR(in_waves.value, 14, 1e-6);
    add_added_by_waves(c, {});
    const Quantity *drag = c.find("added_resistance"), *trim = c.find("added_trim"), *rise = c.find("added_rise");
    ASSERT_TRUE(drag && trim && rise);
    EXPECT_NEAR(drag->values[0].value, 3, 0.02);
    EXPECT_NEAR(trim->values[0].value, 0.2, 1e-4);
    EXPECT_NEAR(rise->values[0].value, 0.005, 1e-5);
    EXPECT_FALSE(drag->values[1].known);
    EXPECT_NE(drag->values[1].why_not.find("not run without the wave"), std::string::npos);
    c.sources = {hull_in_waves()};
    c.names = {"sph"};
    c.quantities.clear();
    add_added_by_waves(c, {});
    EXPECT_TRUE(c.quantities.empty()) << "no twin, nothing added";
}

TEST(RegularWaveMeasure, GivesForceAndDriftOfWhatStandsFixed) {
    Comparison c;
    c.sources = {tank(0.04, 0)};
    c.names = {"sph"};
    Table& table = c.sources[0].table("forces");
    for (double t = 0; t < 9; t += 0.003) {
        const double angle = 2 * pi / 0.8 * t;
        const std::size_t row = table.append(t);
        table.set(row, "fx", "N/m", 1.5 + 12 * std::cos(angle - 0.5) + 2 * std::cos(2 * angle));
        table.set(row, "fz", "N/m", 300 + 9 * std::cos(angle + 3.1));
    }
    add_regular_wave(c);
    EXPECT_NEAR(c.find("wave_force_x")->values[0].value, 12, 1e-6);
    EXPECT_NEAR(c.find("wave_force_z")->values[0].value, 9, 1e-6);
    EXPECT_NEAR(c.find("wave_drift_x")->values[0].value, 1.5, 1e-6);
    // a crest of the theory is at x = 0 at t = 0: the force along x comes after it
    EXPECT_NEAR(std::abs(c.find("wave_force_phase_x")->values[0].value), 0.5 * 180 / pi, 1e-6);
    EXPECT_NEAR(c.find("wave_force_phase_x")->values[0].value, -0.5 * 180 / pi, 1e-6);
    EXPECT_FALSE(c.find("wave_drift_z")) << "it would hold the buoyancy";
}

/// Waves of 1 m and 0.8 s in a stream that run towards 60 degrees from +x to +y, at gauges beside each other too.
RunRecord oblique_waves() {
    RunRecord r = tank(0.04, 0);
    const double along = 0.5, across = std::sqrt(0.75);
    r.numbers["wave_direction"] = along, r.numbers["wave_across"] = across, r.numbers["speed"] = 0.4;
    Table& height = r.table("height");
    height = Table();
    height.name = "height";
    const std::tuple<const char*, double, double> gauges[] = {{"a", -0.3, 0.2}, {"b", -0.1, -0.1}, {"c", 0.1, 0.25}};
    for (const auto& [name, x, y] : gauges)
        r.numbers[std::string("height_x_") + name] = x, r.numbers[std::string("height_y_") + name] = y;
    Table& forces = r.table("forces");
    for (double t = 0; t < 9; t += 0.01) {
        const double angle = 2 * pi / 0.8 * t;
        std::size_t row = height.append(t);
        for (const auto& [name, x, y] : gauges) {
            const double way = along * x + across * y;  // it loses 5 % in a wave length
            height.set(row, name, "m", 0.02 * std::pow(0.95, way) * std::cos(2 * pi * way - angle));
        }
        row = forces.append(t);
        forces.set(row, "fx", "N", 12 * std::cos(angle - 0.5));
        forces.set(row, "fy", "N", -1 + 7 * std::cos(angle + 0.3));
        forces.set(row, "fz", "N", 300 + 9 * std::cos(angle));
    }
    return r;
}

TEST(RegularWaveMeasure, GivesForcesAcrossAndPlacesOnTheWayOfObliqueWaves) {
    Comparison c;
    c.sources = {oblique_waves()};
    c.names = {"sph"};
    add_regular_wave(c);
    add_wave_peaks(c);
    const auto value = [&](const char* name) {
        const Quantity* q = c.find(name);
        return q && q->values[0].known ? q->values[0].value : NAN;
    };
    EXPECT_NEAR(value("wave_force_y"), 7, 1e-6);
    EXPECT_NEAR(value("wave_force_phase_y"), 0.3 * 180 / pi, 1e-6);
    EXPECT_NEAR(value("wave_drift_y"), -1, 1e-6);
    EXPECT_NEAR(value("wave_loss"), 5, 0.1);  // by x alone the three fit no wave
    EXPECT_NEAR(value("peak_mean:force_y"), 6, 0.1);
    c.sources[0].numbers["wave_across"] = -std::sqrt(0.75);  // towards -y
    c.quantities.clear();
    add_wave_peaks(c);
    EXPECT_NEAR(value("peak_mean:force_y"), 8, 0.1);
    c.sources[0].numbers.erase("wave_across");
    c.quantities.clear();
    add_regular_wave(c);
    EXPECT_FALSE(c.find("wave_force_y")) << "head waves have none";
}

TEST(RegularWaveMeasure, GivesTheForceOnAnObstacleOverTheWaveOfTheRunWithoutIt) {
    Comparison c;
    c.sources = {tank(0.04, 0), tank(0.04, 0)};
    c.names = {"sph", "fvm"};
    for (const std::size_t k : {0, 1}) {
        RunRecord& r = c.sources[k];
        r.numbers["wave_height"] = 0.04;
        Table& forces = r.table("forces");
        for (double t = 0; t < 9; t += 0.003) {
            // 300 N a metre of the wave, 0.5 rad behind its crest, while the wave loses height
            const double angle = 2 * pi / 0.8 * t, wave = (k == 0 ? 0.018 : 0.015) * (1 - 0.02 * t);
            std::size_t row = forces.append(t);
            forces.set(row, "fx", "N", 1.5 + 300 * wave * std::cos(angle - 0.5));
            forces.set(row, "fz", "N", 20 * wave * std::cos(angle + 1));
            if (k == 1) continue;
            Table& level = r.table(std::string(empty_twin_table));
            row = level.append(t);
            level.set(row, gauge_of_empty_twin("pile"), "m", wave * std::cos(angle));
            level.set(row, "before", "m", wave * std::cos(angle + 2));
        }
    }
    add_regular_wave(c);
    const Quantity *over = c.find("wave_force_over_wave_x"), *lead = c.find("wave_force_lead_x"),
                   *wave = c.find("wave_without:pile");
    ASSERT_TRUE(over && lead && wave);
    EXPECT_NEAR(over->values[0].value, 300, 0.5);
    EXPECT_LT(over->values[0].half_width, 0.5) << "what both lose as time goes on is not scatter";
    EXPECT_NEAR(lead->values[0].value, -0.5 * 180 / pi, 0.1);
    EXPECT_NEAR(wave->values[0].value, 0.036 * (1 - 0.02 * 5.77), 5e-5);
    EXPECT_EQ(over->unit, "N/m");
    EXPECT_FALSE(over->values[1].known) << "it has no run without the obstacle";
    EXPECT_NE(over->definition.find("no run without the obstacle counts (interFoam: it was not run)"),
              std::string::npos)
        << over->definition;
    EXPECT_NEAR(c.find("wave_force_over_wave_z")->values[0].value, 20, 0.1);

    // of two obstacles the force is a sum, and it is over no one wave
    Table& level = c.sources[0].table(std::string(empty_twin_table));
    for (std::size_t row = 0; row < level.time.size(); ++row) level.set(row, gauge_of_empty_twin("pier"), "m", 0);
    c.quantities.clear();
    add_regular_wave(c);
    EXPECT_FALSE(c.find("wave_force_over_wave_x"));
    EXPECT_TRUE(c.find("wave_force_x"));
}

TEST(RegularWaveMeasure, IsAbsentWithoutAWave) {
    Comparison c;
    c.sources = {tank(0.04, 0)};
    c.sources[0].numbers.erase("wave_period");
    c.names = {"sph"};
    add_regular_wave(c);
    EXPECT_TRUE(c.quantities.empty());
}

TEST(RegularWaveMeasure, SaysWhyThereIsNoValue) {
    Comparison c;
    c.sources = {tank(0.04, 0)};
    c.names = {"sph"};
    for (const char* gauge : {"a", "b", "c"}) c.sources[0].numbers.erase(std::string("height_x_") + gauge);
    c.sources[0].numbers["mean_from"] = 8;  // one period is left
    add_regular_wave(c);
    EXPECT_FALSE(c.find("wave_height:a")->values[0].known);
    EXPECT_NE(c.find("wave_height:a")->values[0].why_not.find("periods"), std::string::npos);
    EXPECT_NE(c.find("wave_reflection")->values[0].why_not.find("two gauges"), std::string::npos);
}

}  // namespace regular_wave_test
}  // namespace tw::test
