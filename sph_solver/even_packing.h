#pragma once
#include <functional>
#include <span>
#include <vector>

#include "meshes/query.h"

namespace tw {

/// Of what particles are to fill: the share of it in a small cube about a place [-], 0 to 1.
using FilledShare = std::function<double(const Vec3& middle, double edge)>;

/// Of what boxes that do not overlap hold outside solids. Both must outlive it.
FilledShare water_in(std::span<const Box> boxes, std::span<const SurfaceQuery> solids, int dimensions);

struct EvenPacking {
    int dimensions = 3;
    double dp = 0;      ///< [m]
    double volume = 0;  ///< of a particle [m3; in two dimensions m2]
    double h = 0;       ///< smoothing length [m]
};

/// How far the kernel sum over particles is from the same integral over what they are to fill, in the mean over the
/// particles asked for and at most [-].
struct Unevenness {
    double mean = 0, most = 0;
};

/// Moves those particles that `moves` names until their packing is even: until nothing pushes them from
///
///   C_i = sum_j V grad W_ij - int grad W(x_i - x) dx   over what is filled,   x_i -= h^2/2 C_i   a time
///
/// which is shifting (Lind et al. 2012, doi:10.1016/j.jcp.2011.10.027) for the measure that particles are to have in
/// place of none: at a wall, a solid or the free surface nothing is missing, because neither the sum nor the integral
/// has anything beyond it. Other particles stay where they are. Wendland C2 of support 2h. Returns how many times all
/// moved.
int even_out(std::vector<Vec3>& places, std::span<const char> moves, const EvenPacking& packing,
             const FilledShare& filled);

Unevenness unevenness(std::span<const Vec3> places, std::span<const char> of, const EvenPacking& packing,
                      const FilledShare& filled);

}  // namespace tw
