// What the study says of windows that hold too little, or are too large.
#include <gtest/gtest.h>

#include <random>

#include "base/errors.h"
#include "spray/report/write_spray.h"

namespace tw::spray {
namespace windows_test {

/// A stream of `count` droplets along x in 3 ms, within `width` of the middle of a sensor 0.1 m ahead.
SprayStudy stream_at_sensor(int count, double width) {
    SprayStudy study;
    std::mt19937_64 random(1);
    std::uniform_real_distribution<double> unit(0, 1);
    for (int i = 0; i < count; ++i) {
        const double t = 3e-3 * unit(random), y = width * (unit(random) - 0.5), z = width * (unit(random) - 0.5);
        study.source.droplets.push_back(
            {.place = {0, y, 10 + z}, .velocity = {10, 0, 0}, .diameter = 2e-3, .time = 1 + t});
    }
    study.air = std::make_shared<UniformAir>(AirState{});
    study.duration = 0.1;
    SensorStudy& s = study.sensor.emplace();
    s.sensor = {.centre = {0.1, 0, 10}, .normal = {-1, 0, 0}, .extent = 0.1};
    s.window.edge = 0.05, s.window.length = 0.02;
    return study;
}
const ReportTable& table(const std::vector<ReportTable>& all, const std::string& title) {
    for (const ReportTable& t : all)
        if (t.title == title) return t;
    throw std::logic_error("no table " + title);
}

TEST(Windows, OfFewerThanThirtyDropletsGiveAnIntervalAndNoValue) {
    for (const int count : {29, 30}) {
        const SprayStudy study = stream_at_sensor(count, 0.04);
        const auto tables = spray_tables(study, run_spray(study));
        const auto& cells = table(tables, "Largest load on the sensor").rows.at(0).cells;
        ASSERT_EQ(cells.at(3).number, count);
        EXPECT_EQ(cells.at(6).text == "too few", count < 30);
        EXPECT_EQ(cells.at(6).is_number, count >= 30);
        EXPECT_NE(cells.at(11).text.find(" to "), std::string::npos);  // the interval of the average
    }
}

TEST(Windows, WiderThanTheSprayAreSaidToBe) {
    for (const double width : {0.01, 0.09}) {
        const SprayStudy study = stream_at_sensor(200, width);
        const auto tables = spray_tables(study, run_spray(study));
        EXPECT_EQ(table(tables, "Largest load on the sensor").rows.at(0).remark ==
                      "This window is wider than the spray on the sensor.",
                  width < study.sensor->window.edge);
    }
}

TEST(Windows, WiderThanTheSensorAreRefused) {
    SprayStudy study = stream_at_sensor(40, 0.04);
    study.sensor->window.edge = 0.11;
    EXPECT_THROW(run_spray(study), InputError);
}

/// A thin stream that meets the sensor 30 mm beside its middle and 20 mm below it.
TEST(Windows, TheFullestAnywhereIsFoundWhereTheSprayIs) {
    SprayStudy study = stream_at_sensor(400, 0.008);
    study.sensor->window = {.edge = 0.01, .length = 3e-3};
    const Sensor& sensor = study.sensor->sensor;
    const Vec3 beside = 0.03 * sensor.across() - 0.02 * sensor.along();
    for (Droplet& d : study.source.droplets) d.place += beside;
    const SprayResult r = run_spray(study);
    ASSERT_TRUE(r.anywhere);
    EXPECT_NEAR(r.anywhere->window.across, 0.03, 1e-12);
    EXPECT_NEAR(r.anywhere->window.along, -0.02, 1e-12);
    EXPECT_EQ(r.peak->estimate.droplets, 0u);
    // the same as a sensor that stands there, but for where its windows begin in time
    study.sensor->sensor.centre += beside;
    const SprayResult there = run_spray(study);
    EXPECT_NEAR(r.anywhere->estimate.average, there.peak->estimate.average, 1e-9 * there.peak->estimate.average);
    EXPECT_GT(r.anywhere->estimate.droplets, 100u);
}

TEST(Report, ComparesWithRepeatsOfAMeasurement) {
    SprayStudy study = stream_at_sensor(400, 0.04);
    study.sensor->measured = {10580, 9812, 10212, 7473, 10512};
    const SprayResult r = run_spray(study);
    const auto tables = spray_tables(study, r);
    const ReportTable& t = table(tables, "Against the measurement");
    EXPECT_NEAR(t.rows.at(0).cells.at(1).number, 9.7178, 1e-9);
    EXPECT_NEAR(t.rows.at(1).cells.at(1).number, 1e-3 * r.peak->estimate.average, 1e-9);
    EXPECT_NEAR(t.rows.at(3).cells.at(4).number, 100 * (r.peak->estimate.peak / 9717.8 - 1), 1e-9);
    const std::string page = spray_html(study, r);
    for (const char* part : {"Force of one droplet", "measured", "A small face", "Load against time"})
        EXPECT_NE(page.find(part), std::string::npos) << part;
}

TEST(Report, SaysThatNothingReachesASensorThatWasMeasured) {
    SprayStudy study = stream_at_sensor(40, 0.04);
    study.sensor->measured = {10580, 9812};
    study.sensor->sensor.centre.y() = 50;
    const SprayResult r = run_spray(study);
    const auto tables = spray_tables(study, r);
    EXPECT_EQ(table(tables, "Against the measurement").rows.at(1).cells.at(1).number, 0);
    EXPECT_NE(spray_html(study, r).find("No droplet reaches the sensor: its load is zero."), std::string::npos);
}

/// Droplets that end are in the ledger as they end, and those at their end add up to those at their start.
TEST(Ledger, HoldsHowDropletsEnd) {
    SprayStudy study = stream_at_sensor(300, 0.2);  // wider than the sensor
    study.flight.water_level = 9.97;                // and partly below the water: those end where they begin
    study.duration = 0.05;
    const SprayResult r = run_spray(study);
    EXPECT_GT(r.landed.pieces, 0u);
    EXPECT_GT(r.back.pieces, 0u);
    EXPECT_GT(r.away.pieces, 0u);
    EXPECT_EQ(r.landed.pieces + r.back.pieces + r.away.pieces, 300u);
    EXPECT_NEAR(r.landed.volume + r.back.volume + r.away.volume, 300 * sphere_volume(2e-3), 1e-18);
    EXPECT_LT(r.landed.momentum.x(), 10 * 1000 * r.landed.volume);  // the air has slowed them
}

}  // namespace windows_test
}  // namespace tw::spray
