#pragma once
#include <optional>
#include <vector>

#include "motion/moving_frame.h"
#include "scene/scene.h"
#include "sph_solver/domain/mirrors.h"
#include "sph_solver/domain/stream.h"
#include "sph_solver/equations/rest_pressure.h"

namespace tw {

class Comm;

/// What all levels of a run share. SI units.
struct Surroundings {
    int dimensions = 3;
    Vec3 gravity{0, 0, -Water{}.gravity};  ///< [m/s2]
    /// Particles move freely inside; mirror planes lie on its faces.
    Box domain;
    Mirrors mirrors;
    std::optional<Stream> stream;
    /// The axes are those of a tank that moves; none: they rest. What is fixed is fixed in it.
    std::optional<MovingFrame> frame;
    /// What the particles do not carry of the pressure of deep water; none: they carry all of it.
    std::optional<RestPressure> at_rest;
    /// With `at_rest`, of the bodies in their order: a solid below its band, on which Archimedes' force acts at the
    /// centroid of the volume.
    struct Submerged {
        double volume = 0;             ///< [m3]; in two dimensions per metre of span [m2]
        Vec3 centroid = Vec3::Zero();  ///< at the start [m]
        double radius = 0;             ///< of the sphere about it that holds the solid [m]
    };
    std::vector<Submerged> submerged;
    const Comm* ranks = nullptr;  ///< that share the particles; null: this process has all
    /// Gravity that all water, images and walls feel alike [m/s2]; with `at_rest` an effect brings it where it acts.
    Vec3 weight() const { return at_rest ? Vec3::Zero() : gravity; }
    /// What water feels at time `t`, but for the stream's ramp.
    FrameForce force(double t) const { return frame ? frame->force(t, gravity) : FrameForce{.at_pivot = gravity}; }
};

}  // namespace tw
