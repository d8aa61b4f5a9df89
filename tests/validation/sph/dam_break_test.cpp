// The front of a collapsing water column against two experiments. The digitised measurements agree with each other to about
// 5 % (see tests/data/README.md), so no band is narrower than that.
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "study_run.h"

namespace tw::test {
namespace {

struct FrontPoint {
    double time = 0;   ///< t sqrt(2 g / a) [-]
    double place = 0;  ///< x / a [-]
};

/// Columns: series, digitised_by, t_s, x_m, T_sqrt_2g_over_a, x_over_a, t_sqrt_g_over_a.
std::vector<FrontPoint> measured(const std::string& series, const std::string& digitised_by) {
    std::ifstream file(TWINWAKE_TEST_DATA "/dambreak_front_position.csv");
    std::vector<FrontPoint> points;
    for (std::string line; std::getline(file, line);) {
        std::istringstream cells(line);
        std::vector<std::string> row;
        for (std::string cell; std::getline(cells, cell, ',');) row.push_back(cell);
        if (row[0] == series && row[1] == digitised_by) points.push_back({std::stod(row[4]), std::stod(row[5])});
    }
    return points;
}

/// The run's front at a time, linear between frames.
double front_at(const std::vector<FrontPoint>& run, double time) {
    const auto after = std::lower_bound(run.begin(), run.end(), time, [](const FrontPoint& p, double t) { return p.time < t; });
    if (after == run.begin() || after == run.end()) return std::nan("");
    const auto before = after - 1;
    return before->place + (after->place - before->place) * (time - before->time) / (after->time - before->time);
}

TEST(DamBreak, FrontFollowsTheMeasurements) {
    const StudyRun run = run_study("dam_break");
    ASSERT_EQ(run.record.state, "finished") << run.record.reason;
    ASSERT_EQ(run.scene.water_blocks.size(), 1u);
    const Box& column = run.scene.water_blocks[0];
    const double a = column.size().x();
    ASSERT_NEAR(column.size().z() / a, 2, 1e-9) << "both experiments: a column twice as high as wide";

    std::vector<FrontPoint> front;
    for (const RasterFrame& frame : run.record.frames)
        front.push_back({frame.time * std::sqrt(2 * run.scene.water.gravity / a),
                         (front_on_floor(run.record.raster, frame) - column.min.x()) / a});

    const double wall = run.scene.domain.box.size().x() / a;
    for (const auto& [series, digitised_by] : {std::pair{"koshizuka_oka_1996", "DualSPHysics"}, {"koshizuka_oka_1996", "EtherSPH"},
                                               {"martin_moyce_1952_a2.25in_n2eq2", "pysph"}}) {
        double sum = 0;
        int count = 0;
        for (const FrontPoint& point : measured(series, digitised_by)) {
            if (point.time < 1 || point.time > front.back().time || point.place > 0.9 * wall) continue;
            // Before T = 1 the gate or membrane of the experiments has not quite let go.
            const double difference = front_at(front, point.time) / point.place - 1;
            EXPECT_LT(std::abs(difference), 0.10) << series << " at T = " << point.time << ": " << front_at(front, point.time) << " a, measured "
                                                  << point.place << " a";
            sum += difference;
            ++count;
        }
        ASSERT_GE(count, 3) << series;
        EXPECT_LT(std::abs(sum / count), 0.05) << series << ", mean over " << count << " points";
        RecordProperty(std::string(series) + "_" + digitised_by + "_mean_percent", std::to_string(100 * sum / count));
    }
}

}  // namespace
}  // namespace tw::test
