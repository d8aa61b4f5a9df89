#pragma once
#include <memory>
#include <optional>

#include "meshes/surface.h"

namespace tw {

/// Where a path first meets a surface, open or closed: a panel, a disc, a fuselage. Both sides of a triangle are hit.
/// Thread-safe after construction; double precision; a tree of boxes finds the triangle.
class FirstHit {
public:
    /// Throws InputError for a surface without triangles.
    explicit FirstHit(const Surface& surface);
    ~FirstHit();
    FirstHit(FirstHit&&) noexcept;

    struct Hit {
        double share;  ///< of the way from `a` to `b`, 0 to 1 [-]
        int triangle;
        Vec3 point;   ///< [m]
        Vec3 normal;  ///< unit, of the triangle's counter-clockwise side [-]
    };
    /// The first triangle that the segment from `a` to `b` meets [m]. A segment within a triangle's plane meets none.
    std::optional<Hit> on(const Vec3& a, const Vec3& b) const;
    const Box& bounds() const;

private:
    struct Impl;
    std::unique_ptr<Impl> impl_;
};

}  // namespace tw
