// What the study says of windows that hold too little, or are too large.
#include <gtest/gtest.h>

#include <random>

#include "base/errors.h"
#include "spray/report/write_spray.h"

namespace tw::spray {
namespace {

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

}  // namespace
}  // namespace tw::spray
