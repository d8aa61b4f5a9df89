#pragma once
#include <vector>

#include "meshes/query.h"
#include "meshes/surface.h"
#include "sph_solver/bodies/motion.h"

namespace tw {

/// A closed solid in the water.
struct BodySetup {
    Surface surface;
    /// Velocity of the surface along itself, as of a belt [m/s]. Felt by water that the walls hold (effect viscosity,
    /// no slip).
    Vec3 sliding = Vec3::Zero();

    BodySetup() = default;
    BodySetup(Surface s, const Vec3& along = Vec3::Zero()) : surface(std::move(s)), sliding(along) {}
};

/// A solid's surface and motion. What a level of particles sees of it are dummies (walls.h); what it feels of a level
/// is a Load.
class Body {
public:
    explicit Body(BodySetup setup) : setup_(std::move(setup)), query_(setup_.surface) {}

    const Surface& surface() const { return setup_.surface; }
    const SurfaceQuery& query() const { return query_; }
    const Vec3& sliding() const { return setup_.sliding; }
    /// Every body is fixed today.
    const BodyMotion& motion() const { return motion_; }

private:
    BodySetup setup_;
    SurfaceQuery query_;
    BodyMotion motion_;
};

}  // namespace tw
