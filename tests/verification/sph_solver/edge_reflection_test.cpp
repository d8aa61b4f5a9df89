// What edges between sizes of particles throw back of a wave of sound: a packet of it, as edge_sound.h says.
#include <gtest/gtest.h>

#include "tests/verification/sph_solver/edge_sound.h"

namespace tw {
namespace edge_reflection_test {

TEST(EdgeReflection, OfAWaveThatMeetsItAslant) {
    print_head();
    const double rows = 40;  // 30 degrees
    const Packet none = cross(0, 20, rows, true), in = cross(1, 20, rows, true), out = cross(1, 20, rows, false);
    print(0, 20, rows, none, none);
    print(1, 20, rows, in, out);
    EXPECT_LT(in.back, none.back + 0.01);
    EXPECT_LT(out.back, none.back + 0.01);
    EXPECT_GT(in.through, none.through);  // the finer particles damp it less
    EXPECT_GT(out.through, none.through - 0.05);
}

}  // namespace edge_reflection_test
}  // namespace tw
