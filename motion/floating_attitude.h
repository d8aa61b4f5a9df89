#pragma once
#include <optional>

#include "meshes/surface.h"
#include "motion/rigid_body.h"

namespace tw {

/// How a body floats at rest, as a motion from where its surface stands.
struct FloatingAttitude {
    double rise = 0;  ///< of the centre of mass [m]
    double turn = 0;  ///< about y through the centre of mass, bow up [rad]
};

/// Archimedes: the closed surface of a body of this centre of mass [m], moved in heave and pitch as far as those are
/// free, displaces `volume` [m3], its mass over the water's density, below z = 0, with the centre of buoyancy below the
/// centre of mass. Nothing where it sinks, or does not float within 20 degrees of where it stands. Without free heave
/// there is nothing to balance: no motion.
std::optional<FloatingAttitude> floating_attitude(const Surface& surface, double volume, const Vec3& centre,
                                                  const DegreesOfFreedom& free);

}  // namespace tw
