#pragma once
#include <vector>

#include "record/components.h"

namespace tw::spray {

using Element = WaterElement;

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
