#pragma once
#include <optional>

#include "motion/moving_frame.h"
#include "scene/scene.h"
#include "sph_solver/domain/mirrors.h"
#include "sph_solver/domain/stream.h"

namespace tw {

class Comm;

/// What all levels of a run share. SI units.
struct Surroundings {
    int dimensions = 3;
    Vec3 gravity{0, 0, -Water{}.gravity};
    /// Particles move freely inside; mirror planes lie on its faces.
    Box domain;
    Mirrors mirrors;
    std::optional<Stream> stream;
    /// The axes are those of a tank that moves; none: they rest. What is fixed is fixed in it.
    std::optional<MovingFrame> frame;
    const Comm* ranks = nullptr;  ///< that share the particles; null: this process has all
    /// What water feels at time `t`, but for the stream's ramp.
    FrameForce force(double t) const { return frame ? frame->force(t, gravity) : FrameForce{.at_pivot = gravity}; }
};

}  // namespace tw
