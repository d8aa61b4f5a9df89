// Where a body stands between the rows of its table.
#include "record/body_pose.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tw {
namespace body_pose_test {

/// A brick that flies along (1, 2, -3) m/s and turns about y at 2 rad/s; rows every `step`, the first one step late.
RunRecord flying_brick(double step) {
    RunRecord r;
    r.bodies.push_back({"body_brick", {{{1, 0, 0}, {3, 0, 0}, {1, 1, 0}}, {{0, 1, 2}}}, {2, 0, 0}});
    Table& t = r.table("body_brick");
    for (double time = step; time < 1 + step / 2; time += step) {
        t.time.push_back(time);
        const auto put = [&](const char* name, double value) { t.column(name, "").values.push_back(value); };
        put("x", 2 + time), put("y", 2 * time), put("z", -3 * time);
        put("q0", std::cos(time)), put("qx", 0), put("qy", std::sin(time)), put("qz", 0);
    }
    return r;
}

TEST(BodyPose, IsTheRigidMotionAlsoBetweenRowsAndBeforeTheFirst) {
    const RunRecord r = flying_brick(0.1);
    for (const double time : {0.0, 0.04, 0.1, 0.537, 1.0}) {
        const auto pose = body_pose(r, r.bodies[0], time);
        ASSERT_TRUE(pose);
        // what was a metre ahead of the centre turns from x towards -z
        const Vec3 exact(2 + time + std::cos(2 * time), 2 * time, -3 * time - std::sin(2 * time));
        EXPECT_LT(((*pose)(Vec3(3, 0, 0)) - exact).norm(), 1e-12) << time;
        EXPECT_LT((pose->back(exact) - Vec3(3, 0, 0)).norm(), 1e-12) << time;
        EXPECT_LT(((*pose)(r.bodies[0].surface).points[1] - exact).norm(), 1e-12) << time;
    }
}

TEST(BodyPose, StaysAfterTheLastRow) {
    const RunRecord r = flying_brick(0.1);
    EXPECT_EQ((*body_pose(r, r.bodies[0], 5))(Vec3(2, 0, 0)), (*body_pose(r, r.bodies[0], 1.01))(Vec3(2, 0, 0)));
}

TEST(BodyPose, IsNotKnownWithoutATableOrAnAttitude) {
    RunRecord r = flying_brick(0.1);
    std::erase_if(r.tables["body_brick"].columns, [](const Column& c) { return c.name == "qy"; });
    EXPECT_FALSE(body_pose(r, r.bodies[0], 0.5));
    r = flying_brick(0.1);
    r.tables["body_brick"].column("z", "").values[4] = std::nan("");
    EXPECT_FALSE(body_pose(r, r.bodies[0], 0.5));
    EXPECT_TRUE(body_pose(r, r.bodies[0], 0.75));
    r.tables.clear();
    EXPECT_FALSE(body_pose(r, r.bodies[0], 0));
}

}  // namespace body_pose_test
}  // namespace tw
