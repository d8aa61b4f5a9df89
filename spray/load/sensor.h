#pragma once
#include <vector>

#include "meshes/surface.h"
#include "spray/flight/fly.h"

namespace tw::spray {

/// A flat square that droplets arrive at; windows of it stand for the sensor, whose own face may be smaller than a drop.
struct Sensor {
    Vec3 centre = Vec3::Zero();  ///< [m]
    Vec3 normal{1, 0, 0};        ///< any length
    double extent = 0.1;         ///< edge of the square [m]

    /// Directions along its edges: the first is level, the second as upright as the plane allows; for a level sensor
    /// they are x and y.
    Vec3 across() const;
    Vec3 along() const;
    Surface surface() const;  ///< two triangles
};

/// A droplet that met the sensor.
struct Arrival {
    double time = 0;               ///< [s]
    double across = 0, along = 0;  ///< from the sensor's centre [m]
    double normal_speed = 0;       ///< [m/s]
    double diameter = 0;           ///< [m]
};

/// What of the landings hit target number `target`, in the order of time. Droplets whose normal speed is 0 only touch
/// the plane and are left out.
std::vector<Arrival> arrivals(const Sensor& sensor, int target, std::span<const Droplet> droplets,
                              std::span<const Landing> landings);

}  // namespace tw::spray
