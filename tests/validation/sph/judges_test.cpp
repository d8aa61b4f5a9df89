// What the judges of docs/results say of records that are known to be right or wrong.
#include "judges.h"

#include <gtest/gtest.h>

#include "csv.h"
#include "test_paths.h"

namespace tw::test {
namespace judges_test {

constexpr double period = 2.9993;

Scene swaying_tank() {
    Scene scene;
    scene.tank_motion.emplace().law.period = period;
    scene.water.depth = 0.03;
    scene.sampling.height = {{"left", -0.45, 0}};
    return scene;
}

/// The shallow-water equations as a record, `late` periods too late.
RunRecord shallow_water(double late, double higher = 0) {
    const Csv csv = read_csv(TWINWAKE_TEST_DATA "/sloshing_shallow_water.csv");
    RunRecord record;
    Table& height = record.tables["height"];
    height.columns = {{"left", "m", csv.numbers("elevation_50mm_m")}};
    for (double& z : height.columns[0].values) z += higher;
    for (const double t : csv.numbers("t_over_T")) height.time.push_back((t + late) * period);
    return record;
}

std::vector<Row> judged(const RunRecord& record) {
    return judge_sloshing(swaying_tank(), record, TWINWAKE_TEST_DATA "/sloshing_shallow_water.csv",
                          TWINWAKE_TEST_DATA "/sloshing_bouscasse_2013.csv");
}

TEST(SloshingJudge, FindsNothingWrongWithShallowWaterItself) {
    const std::vector<Row> rows = judged(shallow_water(0));
    ASSERT_EQ(rows.size(), 7u);
    for (int i = 0; i < 3; ++i) EXPECT_NEAR(rows[i].value, 0, 1e-9) << rows[i].quantity;
    EXPECT_NEAR(rows[3].value, -17, 1) << "45.7 mm; the highest measured crest, less 5 mm, is 55 mm";
    EXPECT_LT(std::abs(rows[5].value), 0.1) << "the measured times are periods of the same motion";
}

TEST(SloshingJudge, SeesWavesThatAreLateOrHighOrCutShort) {
    EXPECT_NEAR(judged(shallow_water(0.05))[2].value, 0.05, 1e-3);
    EXPECT_FALSE(judged(shallow_water(0.05))[2].passes());
    EXPECT_FALSE(judged(shallow_water(0, 0.003))[0].passes());
    RunRecord first_periods = shallow_water(-2);
    for (const Row& row : judged(first_periods)) EXPECT_FALSE(row.passes()) << row.quantity;
}

}  // namespace judges_test
}  // namespace tw::test
