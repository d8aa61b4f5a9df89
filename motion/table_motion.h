#pragma once
#include <vector>

#include "motion/motion_law.h"

namespace tw {

/// The velocities with which a table of a motion begins and ends [m/s or rad/s].
struct EndsOfTable {
    double begin = 0, end = 0;
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
    double from_row_to_row = 0;         ///< largest mean velocity between two rows
};
LargestOfTable largest_of_table(const std::vector<double>& times, const std::vector<double>& values);

/// The largest |s''| of all times of any law; not that of an impulsive start, which is infinite [m/s2 or rad/s2].
double largest_acceleration(const MotionLaw& law);

/// Path, rate and acceleration of the cubic spline through the rows, whose first derivative at the ends is that of
/// ends_of_table() and whose second is continuous. Before the first row it rests there; behind the last it keeps the
/// velocity of the end.
MotionLaw::At on_table(const std::vector<double>& times, const std::vector<double>& values, double time);

}  // namespace tw
