#pragma once
#include <cstddef>
#include <cstdint>

#include "sph_solver/domain/kind.h"
#include "sph_solver/fields/quantities.h"
#include "sph_solver/loops/records.h"

namespace tw {

/// All that stays with a particle.
struct MovingView {
    StateView p;
    Kind* kind;
    std::int64_t* id;
    // null: the level's particles have none
    Aired* aired;
    Trend* trend;
    EdgeDistance* from_edge;
    Children* children;
    float* compression;
    EdgeDistance* from_finer_edge;

    /// Particle i becomes what particle k of another view of the same level is.
    void copy(std::size_t i, const MovingView& from, std::size_t k) const {
        const StateView& q = from.p;
        p.x[i] = q.x[k], p.y[i] = q.y[k], p.z[i] = q.z[k];
        p.u[i] = q.u[k], p.v[i] = q.v[k], p.w[i] = q.w[k], p.drho[i] = q.drho[k];
        kind[i] = from.kind[k], id[i] = from.id[k];
        if (aired) aired[i] = from.aired[k];
        if (trend) trend[i] = from.trend[k];
        if (from_edge) from_edge[i] = from.from_edge[k];
        if (children) children[i] = from.children[k];
        if (compression) compression[i] = from.compression[k];
        if (from_finer_edge) from_finer_edge[i] = from.from_finer_edge[k];
    }
    /// Beside its state it has what new ones have.
    void begin(std::size_t i) const {
        if (aired) aired[i] = Aired::unknown;
        if (trend) trend[i] = {};
        if (from_edge) from_edge[i] = {};
        if (children) children[i] = Children::none;
        if (compression) compression[i] = 0;
        if (from_finer_edge) from_finer_edge[i] = {};
    }
};

}  // namespace tw
