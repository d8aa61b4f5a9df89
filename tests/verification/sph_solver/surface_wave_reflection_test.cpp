// What an edge between two sizes of particles, or a forcing zone, throws back of a gravity wave, as edge_waves.h says.
#include <gtest/gtest.h>

#include "tests/verification/sph_solver/edge_waves.h"

namespace tw {
namespace surface_wave_reflection_test {

// The goal is 2 %. Found: 2.4 (2.1 before the rule for voids, when particles without an edge had 1.9); fields that are
// interpolated without their gradients reflect 5.1.
TEST(SurfaceWaveReflection, OfAWaveOfFortySpacings) {
    print_head();
    const Packet of{.length = 40, .steepness = 0.2};
    const Reflection r = both_ways_up(Sizes::into_fine, of);
    print_line("into fine", of, r.of_packet.forth, r);
    EXPECT_LT(image(r.of_packet.back, r.of_packet.forth), 0.035);
    EXPECT_GT(rms(r.of_packet.forth), 0.2);  // and the packet has come through
}

/// A packet of waves of 30 spacings runs into a zone: what comes back over what the wall alone throws back, so that
/// what the particles take from every wave on its way falls out.
// Linear theory in two dimensions, deep water: 0.6 % for a zone of one wave length and 1.5 omega, 15 % for 5.3 omega
// over 0.55 wave lengths (docs/decisions/082-zones-and-ends.md). Found: 3.6 %; waves in particles without any edge
// throw 1.9 % of themselves back, see above.
TEST(SurfaceWaveReflection, OfAForcingZoneOfOneWaveLength) {
    const auto back = [](const Beach& beach, double sign) {
        return cross(Sizes::all_coarse, {.length = 30, .steepness = 0.2, .beach = beach}, sign).back;
    };
    const Beach zone{.width = 1, .gamma = 1.5}, short_and_strong{.width = 0.55, .gamma = 5.3};
    const double wall = rms(back({}, 1)), left = rms(half(back(zone, 1), -1, back(zone, -1))),
                 of_short = rms(back(short_and_strong, 1));
    std::printf(
        "thrown back, over what a wall does (%.3f of the packet): a zone of one wave length %.1f %%, a short and "
        "strong one %.1f %%\n",
        wall, 100 * left / wall, 100 * of_short / wall);
    EXPECT_LT(left, 0.05 * wall);
    EXPECT_GT(of_short, 0.1 * wall);
    EXPECT_GT(wall, 0.15);  // or nothing has come back from it that could be told from noise
}

}  // namespace surface_wave_reflection_test
}  // namespace tw
