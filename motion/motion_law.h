#pragma once
#include <vector>

#include "base/vec3.h"
#include "motion/table_motion.h"

namespace tw {

/// A prescribed motion: along a direction or about an axis through the centre of mass, as a path s(t) [m or rad].
///
///   constant   s = rate t
///   ramp       the rate rises from 0 to `rate` over `ramp`: s' = rate sin^2(pi t / (2 ramp)), then constant
///   sinusoid   s = amplitude (sin(2 pi t / period + phase) - sin(phase)); with ramp amplitude f sin(...), f = s'/rate
///   table      a cubic spline through (times, values). It rests before the first row; behind the last it rests where
///              the rows come to rest there, else it keeps their last velocity (table_motion.h)
///
/// A motion that begins with a velocity starts impulsively.
struct MotionLaw {
    enum class Kind { constant, ramp, sinusoid, table } kind = Kind::constant;
    bool turns = false;                           ///< about `axis`, not along it
    Vec3 axis = Vec3::UnitZ();                    ///< unit vector, earth axes [-]
    double rate = 0;                              ///< [m/s or rad/s]
    double ramp = 0;                              ///< [s]
    double amplitude = 0, period = 1, phase = 0;  ///< [m or rad], [s], [rad]
    std::vector<double> times = {}, values = {};  ///< [s], [m or rad]

    using At = PlaceOfMotion;
    At at(double t) const;
    /// The largest |s'| of all times: exact but for a table, where it is that of 64 places in each interval.
    double fastest() const;
    /// Throws InputError: a table needs two rows or more with times that rise, and to begin after t = 0 from rest.
    void check_table() const;
};

/// The largest |s''| of all times of any law; not that of an impulsive start, which is infinite [m/s2 or rad/s2].
double largest_acceleration(const MotionLaw& law);

}  // namespace tw
