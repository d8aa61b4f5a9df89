#pragma once
#include <algorithm>
#include <cmath>
#include <span>
#include <vector>

#include "spray/droplet.h"

namespace tw::spray {

/// Least speed with which anything thrown from `from` comes to `to` without air [m/s]:
///
///   v^2 = g (h + R)      h = height of `to` above `from`, R = |to - from|
///
/// thrown half way between the direction to the place and upright. Drag only makes it more.
inline double least_speed(const Vec3& from, const Vec3& to, const Vec3& gravity) {
    const Vec3 way = to - from;
    return std::sqrt(std::max(0.0, gravity.norm() * way.norm() - gravity.dot(way)));
}

/// Which droplets are fast enough for a place, whatever their direction.
struct Reach {
    double least = 0;        ///< the smallest of the droplets' least speeds [m/s]
    double fastest = 0;      ///< speed of the fastest droplet [m/s]
    double mean = 0;         ///< speed, by volume [m/s]
    std::size_t enough = 0;  ///< droplets that are as fast as they have to be
    double volume = 0;       ///< of those [m3]
};
inline Reach reach(std::span<const Droplet> droplets, const Vec3& to, const Vec3& gravity) {
    Reach r{.least = droplets.empty() ? 0 : 1e300};
    double all = 0;
    for (const Droplet& d : droplets) {
        const double speed = d.velocity.norm(), needed = least_speed(d.place, to, gravity),
                     volume = sphere_volume(d.diameter);
        r.least = std::min(r.least, needed), r.fastest = std::max(r.fastest, speed);
        r.mean += volume * speed, all += volume;
        if (speed >= needed) ++r.enough, r.volume += volume;
    }
    if (all > 0) r.mean /= all;
    return r;
}

}  // namespace tw::spray
