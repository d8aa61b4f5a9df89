// What is said of walls that pull at the water.
#include <gtest/gtest.h>

#include <array>
#include <cmath>

#include "compare/compare.h"

namespace tw {
namespace walls_test {

/// A ball on which the water presses with 1000 N and which holds the water with `pull` newtons, every second row unknown.
RunRecord held(const std::string& walls, double pull) {
    RunRecord r;
    r.attributes = {{"method", "fvm"}, {"motion", "none"}, {"scene_hash", "s"}, {"hull_hash", ""}, {"walls", walls}};
    r.numbers = {{"duration", 0.4}, {"gravity", 9.81}, {"density", 1000}};
    r.state = "finished";
    Table &body = r.table("body_ball"), &samples = r.table("samples");
    for (int i = 0; i <= 4; ++i) {
        body.time.push_back(0.1 * i), samples.time.push_back(0.1 * i);
        body.column("z", "m").values.push_back(1), body.column("q0", "-").values.push_back(1);
        body.column("fx", "N").values.push_back(600), body.column("fz", "N").values.push_back(800);
        const double known = i % 2 ? std::nan("") : 1;
        samples.column("suction_force_ball", "N").values.push_back(known * pull);
        samples.column("suction_area_ball", "m2").values.push_back(known * 0.02);
        samples.column("leaving_angle_ball", "deg").values.push_back(std::array{0, 60, 70, 180, 180}[std::size_t(i)]);
    }
    return r;
}

bool warned(const Comparison& c) {
    return std::ranges::any_of(c.banners, [](const std::string& b) { return b.find("suction") != b.npos; });
}

TEST(Suction, IsTheMeanOfWhatIsKnownAndStandsBeside) {
    const Comparison c = compare_records({held("allow separation at ambient pressure where air can reach them", 80)});
    const Quantity* q = c.find("suction:ball");
    ASSERT_NE(q, nullptr);
    EXPECT_DOUBLE_EQ(q->values.front().value, 80);
    EXPECT_EQ(q->unit, "N");
    EXPECT_FALSE(q->judged);
    EXPECT_NE(q->remark.find("0.02 m²"), std::string::npos) << q->remark;
}

TEST(Suction, WarnsWhereWallsHoldWaterAndItDecidesTheForce) {
    EXPECT_TRUE(warned(compare_records({held("hold water under tension: the effect ventilation is off", 80)})));
    EXPECT_FALSE(warned(compare_records({held("hold water under tension: the effect ventilation is off", 30)})));
    EXPECT_FALSE(warned(compare_records({held("allow separation at ambient pressure where air can reach them", 80)})));
}

TEST(LeavingAngle, IsTheMeanWhileTheBodyIsPartlyWet) {
    const Comparison c = compare_records({held("", 0)});
    const Quantity* q = c.find("leaving_angle:ball");
    ASSERT_NE(q, nullptr);
    EXPECT_DOUBLE_EQ(q->values.front().value, 65);
    EXPECT_FALSE(q->judged);
}

TEST(Suction, OfARecordWithoutItIsNotShown) {
    RunRecord r = held("", 80);
    r.tables.erase("samples");
    EXPECT_EQ(compare_records({r}).find("suction:ball"), nullptr);
}

}  // namespace walls_test
}  // namespace tw
