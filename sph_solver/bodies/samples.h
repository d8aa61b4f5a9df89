#pragma once
#include <vector>

#include "base/vec3.h"
#include "meshes/surface.h"

namespace tw {

/// Points at which the solver is asked for pressure, kernel support and (when wanted) the pressure that pairs carry.
struct PointSamples {
    std::vector<Vec3> places;
    bool want_flux = false;
    std::vector<float> p;        ///< [Pa], hydrostatically corrected Shepard mean of the water near
    std::vector<float> support;  ///< sum_j V_j W_j: 1 inside water, 1/2 on a flat wetted wall
    std::vector<float> flux;     ///< 3 per point: the pressure that the pair forces carry along x, y, z [Pa]
};

/// A surface cut into patches no larger than `size`, each with a centre and an area vector, for integrals over it.
struct SurfaceSamples {
    PointSamples points;
    std::vector<Vec3> area;  ///< outward area vector of each patch [m2]
    /// The patches as a surface, one triangle each, in the same order.
    const Surface& patches() const { return patches_; }

    SurfaceSamples() = default;
    /// `region`: patches whose centre is outside are left out.
    SurfaceSamples(const Surface& surface, double size, const Box& region);
    /// Two dimensions: of a prism along y (meshes/section.h) its sides alone, in strips across the whole span no wider
    /// than `size`, with their centres at y = 0. Each strip is two patches.
    static SurfaceSamples of_section(const Surface& prism, double size);

    /// A quarter of the full support, half of what a flat wetted wall sees: the unbiased place of a waterline.
    static constexpr float wet = 0.25f;
    /// Force of the pressure on the wet patches, and its moment.
    Vec3 pressure_force(const Vec3& moment_reference, Vec3& moment) const;
    double wetted_area() const;
    /// Extent in x of the wet patches within `half_width` of the centre plane y = 0 [m]: the wetted keel.
    double wetted_length(double half_width) const;

private:
    Surface patches_;
};

}  // namespace tw
