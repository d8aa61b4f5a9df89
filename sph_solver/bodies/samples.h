#pragma once
#include <cmath>
#include <vector>

#include "base/vec3.h"
#include "meshes/surface.h"

namespace tw {

class Body;

/// Points at which the solver is asked for pressure, Shepard sum and (when wanted) the pressure that pairs carry.
struct PointSamples {
    std::vector<Vec3> places;  ///< [m]
    bool want_flux = false;
    std::vector<float> p;  ///< [Pa], Shepard mean of the water near, hydrostatically corrected without `want_flux`
    std::vector<float> support;  ///< sum_j V_j W_j: 1 inside water, 1/2 on a flat wetted wall [-], as long as `places`
    /// Momentum flux that the pair forces carry [Pa], xx, xy, xz, yy, yz and zz of each point; nothing out of water.
    std::vector<float> flux;
};

/// A surface cut into patches no larger than `size`, each with a centre and an area vector, for integrals over it.
struct SurfaceSamples {
    PointSamples points;
    std::vector<Vec3> area;  ///< outward area vector of each patch [m2]
    /// The patches as a surface, one triangle each, in the same order; not of samples that were moved.
    const Surface& patches() const { return patches_; }
    /// The same where the body has taken them.
    Surface patches_with(const Body& body) const;

    SurfaceSamples() = default;
    /// `region`: patches whose centre is outside are left out.
    SurfaceSamples(const Surface& surface, double size, const Box& region);
    /// Two dimensions: of a prism along y (meshes/section.h) its sides alone, in strips across the whole span no wider
    /// than `size`, with their centres at y = 0 and the area that they have in a metre of span [m2]. Each strip is two
    /// patches.
    static SurfaceSamples of_section(const Surface& prism, double size,
                                     const Box& region = {Vec3::Constant(-HUGE_VAL), Vec3::Constant(HUGE_VAL)});
    /// The samples where a body has taken them from where they stood at its start.
    SurfaceSamples moved_with(const Body& body) const;

    /// A quarter of the full support, half of what a flat wetted wall sees: water enough within reach for a pressure.
    static constexpr float has_pressure = 0.25f;
    bool presses(std::size_t patch) const { return points.support[patch] >= has_pressure; }
    /// Force of the pressure on the patches that have one, and its moment.
    Vec3 pressure_force(const Vec3& moment_reference, Vec3& moment) const;

    /// Shepard sum of a place on the waterline, from which on it is wet. There the water fills the wedge between the
    /// hull and a level free surface, of angle pi - theta, where theta is the angle between that surface and the hull's
    /// dry side:
    ///
    ///   S = (1 - theta / pi) / 2,   0.06 <= S <= 0.47
    ///
    /// A quarter where a side meets the surface squarely, nearly a half under a flat bottom. The upper bound keeps
    /// clear of the noise of a wetted wall's own half (on the planing prism 0.498 to 0.525); it makes a bottom at 5
    /// degrees to the water 0.4 h too long, at 3 degrees 0.7 h, from 11 on nothing (decision 058). The lower bound does
    /// the same on a deck.
    static double waterline_support(double theta);
    /// theta: the angle of the patch itself, cos theta = -n_z.
    bool wet(std::size_t patch) const { return points.support[patch] >= on_patch_[patch]; }
    double wetted_area() const;
    /// Longest wetted line of a hull of this beam [m], see record/wetted_line.h. theta: the angle of a cut along x
    /// through the patch, tan theta = |n_x| / -n_z. On a keel the water comes from both sides, whatever the deadrise.
    double wetted_length(double beam) const;

private:
    /// A sample with the outward area vector of its part of the surface [m], [m2].
    void add(const Vec3& place, const Vec3& part);

    std::vector<float> on_patch_, along_x_;  ///< waterline_support of each patch, and of a cut along x through it
    Surface patches_;
};

}  // namespace tw
