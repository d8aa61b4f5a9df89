#pragma once
#include <cstddef>
#include <cstdint>

#include "sph_solver/domain/kind.h"
#include "sph_solver/equations/vector.h"
#include "sph_solver/pair_loops/packed.h"

namespace tw {

/// Whom bodies may press on (bodies/wall_pushes.h): water nearer to a wall than a spacing.
struct MayBePressed {
    const PackedWallNormal* wall;
    const Kind* kind;
    double spacing;  ///< [m]

    bool operator()(std::size_t i) const {
        return static_cast<double>(wall[i].distance) < spacing && kind[i] == Kind::fluid;
    }
};
/// Adds what they press to the rates.
struct AddPushes {
    const std::int32_t* which;
    const V3<float>* push;  ///< [m/s2]
    PackedRate* rate;

    void operator()(std::size_t k) const {
        PackedRate& r = rate[which[k]];
        r.ax += push[k].x, r.ay += push[k].y, r.az += push[k].z;
    }
};

}  // namespace tw
