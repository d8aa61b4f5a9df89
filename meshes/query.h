#pragma once
#include <memory>
#include <span>
#include <vector>

#include "meshes/surface.h"

namespace tw {

/// Nearest-point, inside and signed-distance queries on a closed surface with outward normals whose equal corners are
/// merged. Thread-safe after construction. All arithmetic is in double precision; a tree of boxes finds the triangle.
/// The sign of a distance comes from the pseudo-normal of the nearest face, edge or corner, so it is right at sharp
/// keels and chines; beyond `reach` and in `inside` it comes from the winding number along a vertical ray, without
/// double or missed hits at edges.
class SurfaceQuery {
public:
    explicit SurfaceQuery(const Surface& surface);
    ~SurfaceQuery();
    SurfaceQuery(SurfaceQuery&&) noexcept;

    struct Nearest {
        Vec3 point;           ///< nearest point on the surface [m]
        int triangle = -1;    ///< -1 when nothing lies within `reach`: then distance = +-reach, point = p, normal = 0
        double distance = 0;  ///< signed [m]: positive outside, negative inside
        Vec3 normal;          ///< exterior unit normal there, (p - point)/distance [-]; the angle-weighted
                              ///< pseudo-normal where the distance vanishes
        int feature = 0;      ///< of the triangle: 0 its face, 1 to 3 an edge, 4 to 6 a corner
        bool on_face() const { return feature == 0; }
    };
    /// `reach`: only surfaces nearer than this are looked for [m].
    Nearest nearest(const Vec3& p, double reach = 1e30) const;
    /// Exterior unit normals of the faces that meet at the nearest point: one on a face, two at an edge, all round a
    /// corner. Empty when nothing was in reach.
    std::vector<Vec3> faces_at(const Nearest& nearest) const;
    bool inside(const Vec3& p) const;
    /// Signed distances of many points, in parallel (OpenMP); beyond `reach` the value is +-reach with the right sign.
    void signed_distances(std::span<const Vec3> points, std::span<double> out, double reach = 1e30) const;
    /// True when the open segment a-b meets the surface.
    bool crosses(const Vec3& a, const Vec3& b) const;
    /// Wall thickness behind triangle t: distance along the inward normal to the opposite side [m]; infinite when the
    /// surface is open there. Near a sharp edge this is short by geometry: see thin_walls in check/.
    double thickness(int triangle) const;
    /// The same with the triangle that was hit (-1: none), from the triangle's centre or another of its points.
    struct Opposite {
        double distance;  ///< [m]
        int triangle;
    };
    Opposite opposite_side(int triangle) const;
    Opposite opposite_side(int triangle, const Vec3& origin) const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace tw
