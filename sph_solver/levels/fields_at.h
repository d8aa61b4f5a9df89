#pragma once
#include <vector>

#include "base/vec3.h"
#include "sph_solver/loops/at_edge.h"

namespace tw {

/// Places that are none of a level's particles, and what it is there, see LevelFields::interpolate.
struct FieldsAt : Asking {
    std::vector<Vec3> places{};  ///< [m]
    std::vector<PackedVelocityDensity> value{};
    std::vector<float> support{};       ///< sum_j V_j W_j of those particles [-]
    std::vector<float> mean_support{};  ///< of the particles near, each with its own surroundings [-]
    std::vector<float> compression{};   ///< rate of the density at the last evaluation [kg/m3/s]; empty unless wanted

    Given given(std::size_t k) const {
        return {value[k], support[k], mean_support[k], want_compression ? compression[k] : 0};
    }
    void take(std::size_t k, const Given& g) {
        value[k] = g.value, support[k] = g.support, mean_support[k] = g.mean_support;
        if (want_compression) compression[k] = g.compression;
    }
    void resize() {
        const std::size_t n = places.size();
        value.resize(n), support.resize(n), mean_support.resize(n), compression.resize(want_compression ? n : 0);
    }
};

}  // namespace tw
