#pragma once
// Particles at the domain's faces: plain data for kernels, as in tasks.h.
#include <cstddef>
#include <cstdint>

#include "sph_solver/fields/field_list.h"
#include "sph_solver/loops/cross.h"
#include "sph_solver/neighbours/pencil_grid.h"

namespace tw::cuda {

/// Marks the particles that have crossed the inlet's plane, and those that have left.
struct Cross {
    CrossOpenings cross;
    const double* x;  ///< [m]
    Kind* kind;
    int *entered, *gone;

    void operator()(std::size_t i) const {
        const CrossOpenings::Outcome outcome = cross(x[i], kind[i]);
        entered[i] = outcome == CrossOpenings::Outcome::enters;
        gone[i] = outcome == CrossOpenings::Outcome::leaves;
    }
};
/// The particle that takes the place of one that has entered, a buffer's length upstream.
struct Enter {
    FieldsView on;
    const int *entered, *before;  ///< how many of those before have entered
    int* gone;
    std::size_t n;
    double buffer;  ///< its length [m]
    std::int64_t next_id;

    void operator()(std::size_t i) const {
        if (!entered[i]) return;
        const std::size_t k = n + static_cast<std::size_t>(before[i]);
        on.copy(k, on, i);
        on.begin(k);
        if (on.calm_height) on.calm_height[k] = on.calm_height[i];
        on.x[k] -= buffer, on.v[k] = 0, on.w[k] = 0;
        on.kind[k] = Kind::inlet, on.id[k] = next_id + before[i], gone[k] = 0;
    }
};
/// Puts back what has crossed a mirror, takes what has left through an open top, and says where the others are.
struct PutBack {
    ReturnFromMirrors mirrors;
    double top;  ///< [m]
    bool open_top;
    ToFixedPoint to_fixed_point;
    const int* gone;  ///< null: nobody is
    WidePlace* wide;
    std::uint8_t* left;

    void operator()(std::size_t i) const {
        mirrors(i);
        const StateView& p = mirrors.p;
        left[i] = (gone && gone[i]) || (open_top && p.z[i] > top);
        wide[i] = to_fixed_point.wide(p.x[i], p.y[i], p.z[i]);
    }
};

}  // namespace tw::cuda
