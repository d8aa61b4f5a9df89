#pragma once
#include <string>
#include <vector>

#include "sph_solver/bodies/elastic/coupling.h"
#include "structure/freedoms.h"
#include "structure/shell/gauge.h"
#include "structure/shell/shell.h"

namespace tw {

/// A place of an elastic body whose displacement is asked for.
struct DeflectionPoint {
    std::string name;
    Vec3 position = Vec3::Zero();  ///< at the start [m]; the nearest place of the mid-surface is meant
};

/// What an elastic body is made from: a shell as it stands at the start, and what holds or carries it.
struct ElasticSetup {
    structure::Shell shell;
    structure::Freedoms freedoms;
    /// Of the closed surface that the water sees, about the shell's mid-surface; at least the laminate's [m].
    double skin = 0;
    /// Two dimensions: the shell is a strip about the plane y = 0, so wide [m]; forces are per metre of it. Else 0.
    double width = 0;
    bool large_rotations = true;
    /// Of linear shells: share of its amplitude that an infinitely fast mode keeps each step (1: energy is kept).
    double kept = 1;
    Coupling coupling = {};
    double damping = 0;            ///< f = -damping M v [1/s]
    double largest_step = 0;       ///< of the structure [s]; 0: the water's
    Vec3 velocity = Vec3::Zero();  ///< at the start [m/s]
    std::vector<structure::Gauge> gauges = {};
    std::vector<DeflectionPoint> points = {};
};

}  // namespace tw
