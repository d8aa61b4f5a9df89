#include "motion/floating_attitude.h"

#include <gtest/gtest.h>

#include <cmath>

#include "meshes/generate.h"

namespace tw {
namespace floating_attitude_test {

constexpr double length = 2, beam = 0.5, height = 0.4, draft = 0.1;

/// A box whose keel lies at z = keel.
Surface box(double keel) {
    return box_surface({Vec3(-length / 2, -beam / 2, keel), Vec3(length / 2, beam / 2, keel + height)});
}

DegreesOfFreedom heave_and_pitch() {
    DegreesOfFreedom free;
    free.along = {false, false, true};
    free.about = {false, true, false};
    return free;
}

TEST(FloatingAttitude, OfABoxIsArchimedesDraft) {
    const auto at = floating_attitude(box(0.05), length * beam * draft, {0, 0, 0.1}, heave_and_pitch());
    ASSERT_TRUE(at);
    EXPECT_NEAR(at->rise, -0.15, 1e-8);
    EXPECT_NEAR(at->turn, 0, 1e-7);
}

/// With the centre of mass `aft` of amidships and z_g above the keel a wall-sided box of draft T trims by the stern
/// until its centre of buoyancy stands below it, with t = tan(trim), in the box's own axes:
///
///   L^2/(12 T) t = aft + (z_g - z_b) t,   z_b = T/2 + L^2/(24 T) t^2
TEST(FloatingAttitude, TrimsByTheSternUntilBuoyancyStandsBelowTheMass) {
    const double aft = 0.1, z_g = 0.15;
    const auto at = floating_attitude(box(-draft), length * beam * draft, {aft, 0, z_g - draft}, heave_and_pitch());
    ASSERT_TRUE(at);
    EXPECT_GT(at->turn, 0.01) << "bow up";
    const double t = std::tan(at->turn), z_b = draft / 2 + length * length / (24 * draft) * t * t;
    EXPECT_NEAR(length * length / (12 * draft) * t, aft + (z_g - z_b) * t, 1e-6);
}

TEST(FloatingAttitude, KeepsATrimThatIsHeldAndRefusesWhatSinks) {
    DegreesOfFreedom heave = heave_and_pitch();
    heave.about[1] = false;
    const auto held = floating_attitude(box(0), length * beam * draft, {0.3, 0, 0.1}, heave);
    ASSERT_TRUE(held);
    EXPECT_EQ(held->turn, 0);
    EXPECT_NEAR(held->rise, -draft, 1e-8);
    EXPECT_FALSE(floating_attitude(box(0), 1.01 * length * beam * height, {0, 0, 0.1}, heave_and_pitch()));
    EXPECT_FALSE(floating_attitude(box(0), length * beam * draft, {1.5, 0, 0.1}, heave_and_pitch()))
        << "its mass lies ahead of or behind all of it";
}

}  // namespace floating_attitude_test
}  // namespace tw
