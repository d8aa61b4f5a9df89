// Laws and measurements through whole runs of the SPH solver, shorter than the rows of docs/validation.md, which come
// from the same studies and the same judges (see validation_rows.cpp).
#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>

#include "judges.h"
#include "record/body_work.h"
#include "study_run.h"
#include "test_paths.h"

namespace tw::test {
namespace short_runs_test {

void expect_all_pass(const StudyRun& run, const std::vector<Row>& rows) {
    ASSERT_EQ(run.record.state, "finished") << run.record.reason;
    ASSERT_FALSE(rows.empty());
    for (const Row& row : rows)
        EXPECT_TRUE(row.passes()) << row.quantity << ": " << row.value << " " << row.unit << ", limit " << row.limit;
}

TEST(EmptyChannel, SurfaceStaysFlatAndNothingIsLost) {
    const StudyRun run = run_study("empty_channel", 1.5);  // three times through
    expect_all_pass(run, judge_channel(run.scene, run.record, 0.5 * run.scene.run.duration));
    const Column* in = run.record.series("samples", "particles_in");
    ASSERT_TRUE(in);
    EXPECT_GT(in->values.back(), run.record.elements) << "the water was exchanged at least once";
}

// The boundary elements are good to 1 %. The measured water starts later (a gate takes time to open, the floor rubs), and
// is then as fast.
TEST(DamBreak, FrontIsThatOfWaterWithoutFriction) {
    const StudyRun run = run_study("dam_break_2d", 0.24);  // until the front nears the wall
    const Box& column = run.scene.water_blocks.at(0);
    ASSERT_NEAR(column.size().z() / column.size().x(), 2, 1e-9) << "the tables: a column twice as high as wide";
    expect_all_pass(run, judge_dam_break_front(run.scene, run.record, TWINWAKE_TEST_DATA "/dambreak_front_bem.csv"));
    expect_all_pass(run,
                    judge_measured_front(run.scene, run.record, TWINWAKE_TEST_DATA "/dambreak_front_position.csv"));
}

// Until 0.22 m of its half width of 0.6 m are wet, which are 11 particles. What comes later needs smaller ones.
TEST(WedgeDrop, IsSlowedAsTheMomentumOfTheWaterSays) {
    const StudyRun run = run_study("wedge_drop", 0.02, 2);
    std::vector<Row> rows = judge_wedge_drop(run.scene, run.record, TWINWAKE_TEST_DATA "/wedge_drop_momentum.csv");
    ASSERT_GE(rows.size(), 3u);
    rows.resize(3);  // 5, 10 and 15 ms
    expect_all_pass(run, rows);
}

TEST(CylinderEntry, IsAsDeepAsABoundaryElementMethodSaysWhileItIsSlowed) {
    const StudyRun run = run_study("cylinder_2d_entry", 0.03);
    ASSERT_EQ(run.record.state, "finished") << run.record.reason;
    int judged = 0;
    for (const Row& row : judge_entry(run.scene, run.record, TWINWAKE_TEST_DATA "/cylinder_2d_entry.csv")) {
        // Three of the six points plotted as measured lie deeper than free flight would be.
        if (row.quantity.find("bem") == std::string::npos) continue;
        EXPECT_LT(std::abs(row.value), 10) << row.quantity;  // free flight: 30 % at 0.0265 s
        ++judged;
    }
    EXPECT_EQ(judged, 2);
    const Table& t = run.record.tables.at(body_table("cylinder"));
    EXPECT_LT(std::abs(t.find("x")->values.back()), 1e-3 * run.scene.resolution.near_hull);
    EXPECT_GT(t.find("vz")->values.back(), -2.5);

    // What the water has done on it is what its motion and its weight have lost, and the water has got no more.
    const RigidMass& mass = run.scene.bodies[0].motion.mass;
    const auto energy = [&](std::size_t row) {
        const double v = t.find("vz")->values[row];
        return mass.mass * (v * v / 2 + run.scene.water.gravity * t.find("z")->values[row]);
    };
    const double lost = energy(0) - energy(t.time.size() - 1);
    EXPECT_GT(lost, 10) << "J/m; or no water slows it";
    EXPECT_NEAR(-t.find(body_work)->values.back() / lost, 1, 0.01);
    const auto made = std::ranges::find(run.record.validity_checks, "energy made", &RecordedCheck::name);
    ASSERT_NE(made, run.record.validity_checks.end());
    EXPECT_TRUE(made->met());
    EXPECT_LT(made->value, 0.01) << "% of the potential energy";
}

}  // namespace short_runs_test
}  // namespace tw::test
