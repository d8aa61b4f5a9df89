// Prints the tables behind docs/results/levels.md and wedge_drop.md: more sizes, lengths and kernels of what the tests
// beside this file check once.
//
//   particle_tables swings | sound | waves | wedges        minutes each; wedges a quarter of an hour
#include <cmath>
#include <cstdio>
#include <map>
#include <string>

#include "tests/verification/sph_solver/edge_sound.h"
#include "tests/verification/sph_solver/edge_waves.h"
#include "tests/verification/sph_solver/wedge_entry.h"
#include "tests/verification/sph_solver/zone_swing.h"

namespace tw {
namespace {

/// A hundred swings of water across both edges of a zone.
void swings() {
    std::printf(
        "vortices/U   mass of the zone [%%]: last swing's mean, largest mean, at an instant at most   mean "
        "velocity off by [U]   births\n");
    for (const double vortices : {0.1, 0.3}) {
        const levels_test::Swing r = levels_test::swing(100, vortices);
        std::printf("%8.1f   %+.2f  %.2f  %.2f   %.3f   %ld\n", vortices, 100 * r.mean_drift, 100 * r.largest_mean,
                    100 * r.largest_drift, r.shortfall, long(r.splits));
    }
}

/// Packets of sound by length, angle and number of edges.
void sound() {
    using namespace edge_reflection_test;
    print_head();
    const auto lines = [](double length, double sine, int most) {
        const double rows = sine > 0 ? std::round(length / sine) : 0;
        for (int edges = 0; edges <= most; ++edges)
            print(edges, length, rows, cross(edges, length, rows, true), cross(edges, length, rows, false));
    };
    for (const double sine : {0.0, 0.5, std::sqrt(0.75)}) lines(10, sine, 2);
    for (const double sine : {0.0, 0.5, std::sqrt(0.75)}) lines(20, sine, 1);
    lines(40, 0, 1);
}

/// Packets of gravity waves by length, steepness and kernel.
void waves() {
    using namespace surface_wave_reflection_test;
    print_head();
    const auto line = [](const Packet& of, bool in) {
        const Reflection one = both_ways_up(in ? Sizes::all_coarse : Sizes::all_fine, of),
                         two = both_ways_up(in ? Sizes::into_fine : Sizes::out_of_fine, of);
        print_line(in ? "coarse" : "fine", of, one.of_packet.forth, one);
        print_line(in ? "into fine" : "out of fine", of, one.of_packet.forth, two);
    };
    for (const double length : {20, 40})
        for (const double steepness : {0.1, 0.2})
            for (const bool in : {true, false}) line({.length = length, .steepness = steepness}, in);
    for (const double steepness : {0.1, 0.2}) line({.length = 40, .steepness = steepness, .h_over_dp = 2}, true);
    line({.length = 80, .steepness = 0.1}, true);
}

/// Wedges at constant speed by spacing, sound speed and kernel.
void wedges() {
    using namespace wedge_entry_test;
    print_head();
    for (const double fineness : {13.0, 18.0, 26.0, 37.0, 52.0})
        for (const double deadrise : {10.0, 20.0, 30.0, 45.0, 60.0})
            print({.deadrise_deg = deadrise, .fineness = fineness});
    for (const double speed : {7.35, 15.0, 30.0})
        for (const double h_over_dp : {1.5, 2.0}) print({.sound = speed, .h_over_dp = h_over_dp});
}

}  // namespace
}  // namespace tw

int main(int count, char** words) {
    const std::map<std::string, void (*)()> tables{
        {"swings", tw::swings}, {"sound", tw::sound}, {"waves", tw::waves}, {"wedges", tw::wedges}};
    const auto table = count == 2 ? tables.find(words[1]) : tables.end();
    if (table == tables.end()) {
        std::fprintf(stderr, "particle_tables swings | sound | waves | wedges\n");
        return 2;
    }
    table->second();
}
