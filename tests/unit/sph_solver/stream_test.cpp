// The stream at its start.
#include "sph_solver/domain/stream.h"

#include <gtest/gtest.h>

namespace tw::test {
namespace stream_test {

TEST(StreamAtItsStart, HasComeAsFarAsAtFullSpeedSinceHalfOfTheRamp) {
    const Stream stream{.speed = 0.7, .ramp = 0.4};
    double way = 0;
    const double dt = 1e-4;
    for (int step = 0; step <= 6000; ++step) {
        const double t = step * dt, full = stream.speed * (t - stream.ramp / 2);
        EXPECT_NEAR(stream.ahead_of_full_speed(t), way - full, 1e-6) << t;
        way += dt * (stream.velocity(t) + stream.velocity(t + dt)) / 2;
    }
    EXPECT_EQ(stream.ahead_of_full_speed(0.4), 0);
    EXPECT_EQ((Stream{.speed = 0.7}).ahead_of_full_speed(0), 0);
}

}  // namespace stream_test
}  // namespace tw::test
