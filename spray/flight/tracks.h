#pragma once
#include <span>
#include <vector>

#include "spray/flight/fly.h"

namespace tw::spray {

/// Where another program has a droplet, so long after it was let go.
struct TrackPoint {
    std::size_t droplet = 0;
    double age = 0;                ///< [s]
    Vec3 place = Vec3::Zero();     ///< [m]
    Vec3 velocity = Vec3::Zero();  ///< [m/s]
};

/// How far tracks of another program are from our own flight of the same droplets.
struct TrackDifference {
    double age = 0;            ///< the largest of its points [s]
    std::size_t points = 0;    ///< compared; those of droplets that have met the water or left the air are not
    double largest = 0;        ///< |x - x_ours| / way flown since the droplet was let go [-]
    double mean_square = 0;    ///< mean of its square [-]
    double largest_speed = 0;  ///< |v - v_ours| / largest of the droplet's speeds so far [-]
    std::size_t worst = 0;     ///< the droplet of `largest`
};

/// Compares frames of tracks, in the order of time, with flights of the same droplets, each on its own clock: in steady
/// air a path does not depend on when it begins. The way flown is the sum of the chords between frames.
/// Throws InputError: a point of a droplet that is not there, or an age that does not increase.
std::vector<TrackDifference> compare_tracks(std::span<const Droplet> droplets,
                                            std::span<const std::vector<TrackPoint>> frames, const Air& air,
                                            FlightOptions options);

/// The box that all flights stay in.
Box room_of_flights(std::span<const Droplet> droplets, const Air& air, FlightOptions options);

/// Shortest time in which drag changes the velocity of a droplet as a whole, |v - u| / |dv/dt|, at its start [s];
/// infinite where none moves against the air.
double shortest_relaxation(std::span<const Droplet> droplets, const Air& air, const FlightOptions& options);

}  // namespace tw::spray
