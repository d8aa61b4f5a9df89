#pragma once
#include <cstddef>

#include "sph_solver/domain/kind.h"
#include "sph_solver/loops/force_of_frame.h"
#include "sph_solver/loops/pack_state.h"

namespace tw {

/// Adds the rates of moving_tank.h.
struct FeelMotion {
    StateView p;
    const Kind* kind;
    ForceOfFrame force;
    V3<double> gravity;  ///< [m/s2]
    PackedRate* rate;

    void operator()(std::size_t i) const {
        if (!follows_the_equations(kind[i])) return;
        const V3<double> more = force.at({p.x[i], p.y[i], p.z[i]}, {p.u[i], p.v[i], p.w[i]}) - gravity;
        PackedRate& r = rate[i];
        r.ax += static_cast<float>(more.x);
        r.ay += static_cast<float>(more.y);
        r.az += static_cast<float>(more.z);
    }
};

}  // namespace tw
