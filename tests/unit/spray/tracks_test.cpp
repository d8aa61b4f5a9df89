#include <gtest/gtest.h>

#include "base/errors.h"
#include "spray/flight/tracks.h"

namespace tw::spray {
namespace tracks_test {

const UniformAir still_air{AirState{}};

FlightOptions without_water(double duration) {
    FlightOptions o;
    o.end_time = duration;
    o.falls_back = false;
    return o;
}

/// Tracks made of our own flights, begun at another time, and shifted by a share of the way that is known.
TEST(Tracks, DifferBySharesOfTheWay) {
    const std::vector<Droplet> droplets{{.velocity = {10, 0, 0}, .diameter = 1e-3, .time = 3},
                                        {.velocity = {0, 20, 5}, .diameter = 2e-3, .time = 0.5}};
    std::vector<std::vector<TrackPoint>> frames(1);
    double way = 0;
    for (std::size_t i = 0; i < 2; ++i) {
        Droplet now = droplets[i];
        now.time = 0;
        const Landing l = fly({&now, 1}, still_air, {}, without_water(0.2)).front();
        frames[0].push_back({i, 0.2, l.place, l.velocity});
        if (i == 0) way = l.place.norm();
    }
    EXPECT_LT(compare_tracks(droplets, frames, still_air, without_water(1))[0].largest, 1e-12);
    frames[0][0].place.z() += 0.01 * way;
    const TrackDifference d = compare_tracks(droplets, frames, still_air, without_water(1))[0];
    EXPECT_NEAR(d.largest, 0.01, 1e-9);
    EXPECT_EQ(d.worst, 0u);
    EXPECT_NEAR(d.mean_square, 0.5e-4, 1e-9);
    EXPECT_EQ(d.points, 2u);
}

TEST(Tracks, OfADropletThatHasFallenBackAreNotCompared) {
    const std::vector<Droplet> droplets{{.place = {0, 0, 0.1}, .velocity = {1, 0, 0}, .diameter = 1e-3}};
    const std::vector<TrackPoint> early{TrackPoint{.age = 0.05}}, late{TrackPoint{.age = 1}};
    const std::vector<std::vector<TrackPoint>> frames{early, late};
    const auto d = compare_tracks(droplets, frames, still_air, FlightOptions{});
    EXPECT_EQ(d[0].points, 1u);
    EXPECT_EQ(d[1].points, 0u);
    EXPECT_EQ(d[1].largest, 0);
}

TEST(Tracks, ThatCannotBeAreRefused) {
    const std::vector<Droplet> one{{.diameter = 1e-3}};
    const std::vector<TrackPoint> of_another{TrackPoint{.droplet = 1, .age = 0.1}},
        of_it{TrackPoint{.droplet = 0, .age = 0.1}};
    const std::vector<std::vector<TrackPoint>> unknown{of_another}, backwards{of_it, of_it};
    EXPECT_THROW(compare_tracks(one, unknown, still_air, without_water(1)), InputError);
    EXPECT_THROW(compare_tracks(one, backwards, still_air, without_water(1)), InputError);
}

TEST(Tracks, StayInTheRoomOfTheFlights) {
    const std::vector<Droplet> up{{.velocity = {0, 0, 5}, .diameter = 5e-3}};
    const Box room = room_of_flights(up, still_air, without_water(1));
    EXPECT_GT(room.max.z(), 1.15);  // 5^2 / (2 g) = 1.27 m without drag
    EXPECT_LT(room.max.z(), 1.27);
    EXPECT_LE(room.min.z(), 0);
}

/// Stokes: rho d^2 / (18 mu).
TEST(Tracks, MistRelaxesAsStokesSays) {
    const std::vector<Droplet> mist{{.velocity = {1e-3, 0, 0}, .diameter = 1e-5}};
    EXPECT_NEAR(shortest_relaxation(mist, still_air, {}), 1e-10 * 1000 / (18 * 1.81e-5), 2e-6);
}

/// Putnam's drag is continuous at Re = 1000, and up to 3.6 % below Schiller and Naumann's.
TEST(Drag, OfPutnamIsThatOfOpenFoam) {
    EXPECT_NEAR(drag_coefficient(999.999, DragLaw::putnam), 0.424, 1e-6);
    EXPECT_EQ(drag_coefficient(5000, DragLaw::putnam), 0.424);
    EXPECT_NEAR(drag_coefficient(10, DragLaw::putnam) / drag_coefficient(10), 1.0254, 1e-3);
}

}  // namespace tracks_test
}  // namespace tw::spray
