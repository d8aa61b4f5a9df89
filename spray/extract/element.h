#pragma once
#include <span>
#include <vector>

#include "base/vec3.h"

namespace tw::spray {

/// A piece of water as a run leaves it: a particle, or the water of one cell.
struct Element {
    Vec3 place = Vec3::Zero();     ///< [m]
    Vec3 velocity = Vec3::Zero();  ///< [m/s]
    double volume = 0;             ///< of its water [m3]
    double size = 0;               ///< particle spacing, or cube root of the cell's volume [m]
};

/// All water of a run at one time.
struct WaterFrame {
    double time = 0;  ///< [s]
    std::vector<Element> elements;
};

/// Mass, momentum and energy of a lot of water.
struct Budget {
    double volume = 0;             ///< [m3]
    Vec3 momentum = Vec3::Zero();  ///< [kg m/s]
    double kinetic_energy = 0;     ///< [J]
    double potential_energy = 0;   ///< [J], of gravity, 0 at the origin
    std::size_t pieces = 0;

    void add(double more_volume, const Vec3& place, const Vec3& velocity, double density, const Vec3& gravity) {
        const double mass = density * more_volume;
        volume += more_volume;
        momentum += mass * velocity;
        kinetic_energy += 0.5 * mass * velocity.squaredNorm();
        potential_energy -= mass * gravity.dot(place);
        ++pieces;
    }
    Budget& operator+=(const Budget& other) {
        volume += other.volume, momentum += other.momentum, kinetic_energy += other.kinetic_energy;
        potential_energy += other.potential_energy, pieces += other.pieces;
        return *this;
    }
};

}  // namespace tw::spray
