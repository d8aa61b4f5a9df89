#include <gtest/gtest.h>

#include "base/errors.h"
#include "spray/air/air.h"

namespace tw::spray {
namespace air_test {

TEST(AirTables, AreLinearBetweenTheirHeightsAndNothingBeyond) {
    const AirTable table(
        {{0, {{0, 0, 0}, 1.2, 1.8e-5}}, {1, {{10, 0, 0}, 1.2, 1.8e-5}}, {3, {{10, 4, 0}, 1.0, 1.8e-5}}});
    AirState air;
    ASSERT_TRUE(table.at({5, 5, 0.25}, air));
    EXPECT_DOUBLE_EQ(air.velocity.x(), 2.5);
    ASSERT_TRUE(table.at({5, 5, 2}, air));
    EXPECT_DOUBLE_EQ(air.velocity.y(), 2);
    EXPECT_DOUBLE_EQ(air.density, 1.1);
    ASSERT_TRUE(table.at({0, 0, 3}, air));
    EXPECT_DOUBLE_EQ(air.velocity.y(), 4);
    EXPECT_FALSE(table.at({0, 0, -0.001}, air));
    EXPECT_FALSE(table.at({0, 0, 3.001}, air));
}

TEST(AirTables, RefuseHeightsThatDoNotIncreaseAndAirThatCannotBe) {
    EXPECT_THROW(AirTable(std::vector<AirTable::Row>(1)), InputError);
    EXPECT_THROW(AirTable({{1, {}}, {1, {}}}), InputError);
    EXPECT_THROW(AirTable({{0, {}}, {1, {Vec3::Zero(), 0, 1.8e-5}}}), InputError);
    EXPECT_THROW(AirTable({{0, {}}, {1, {Vec3::Zero(), 1.2, -1}}}), InputError);
}

}  // namespace air_test
}  // namespace tw::spray
