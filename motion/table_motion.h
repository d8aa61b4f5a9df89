#pragma once
#include <vector>

namespace tw {

/// Where a motion is at a time, along its direction or about its axis.
struct PlaceOfMotion {
    double path, rate, acceleration;  ///< [m, m/s, m/s2 or rad, rad/s, rad/s2]
};

/// The velocities with which a table of a motion begins and ends [m/s or rad/s].
struct EndsOfTable {
    double begin = 0, end = 0;  ///< [m/s or rad/s]
};

/// Whether a table begins and ends at rest or while it moves, by its rows: it moves at an end where
/// - there are three rows or more, and the three at that end go one way, and
/// - the parabola through them has there more than a twentieth of the table's largest velocity from row to row (what is
///   below is taken for rest measured with noise).
/// The velocity is then that of the cubic through the four rows at that end (of three rows, of the parabola).
EndsOfTable ends_of_table(const std::vector<double>& times, const std::vector<double>& values);

/// The largest velocity and acceleration (magnitudes) of all times.
struct LargestOfTable {
    double rate = 0, acceleration = 0;  ///< [m/s, m/s2 or rad/s, rad/s2]
    double from_row_to_row = 0;         ///< largest mean velocity between two rows [m/s or rad/s]
};
LargestOfTable largest_of_table(const std::vector<double>& times, const std::vector<double>& values);

/// Path, rate and acceleration of the cubic spline through the rows, whose first derivative at the ends is that of
/// ends_of_table() and whose second is continuous. Before the first row it rests there; behind the last it keeps the
/// velocity of the end.
PlaceOfMotion on_table(const std::vector<double>& times, const std::vector<double>& values, double time);

}  // namespace tw
