#pragma once
#include <memory>
#include <span>

#include "meshes/surface.h"

namespace tw {

/// Nearest-point, inside and signed-distance queries on a closed surface. Thread-safe after construction.
class SurfaceQuery {
public:
    explicit SurfaceQuery(const Surface& surface);
    ~SurfaceQuery();
    SurfaceQuery(SurfaceQuery&&) noexcept;

    struct Nearest {
        Vec3 point;              ///< nearest point on the surface [m]
        int triangle = -1;       ///< -1 when nothing lies within `reach`
        double distance = 0;     ///< signed [m]: positive outside, negative inside
        Vec3 normal;             ///< exterior unit normal there, (p - point)/distance; the angle-weighted
                                 ///< pseudo-normal where the distance vanishes
    };
    /// `reach`: only surfaces nearer than this are looked for [m].
    Nearest nearest(const Vec3& p, double reach = 1e30) const;
    bool inside(const Vec3& p) const;
    /// Signed distances of many points, in parallel (OpenMP); beyond `reach` the value is +-reach with the right sign.
    void signed_distances(std::span<const Vec3> points, std::span<double> out, double reach = 1e30) const;
    /// True when the open segment a-b meets the surface.
    bool crosses(const Vec3& a, const Vec3& b) const;
    /// Wall thickness behind triangle t: distance along the inward normal to the opposite side [m].
    double thickness(int triangle) const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace tw
