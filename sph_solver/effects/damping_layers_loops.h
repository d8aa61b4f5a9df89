#pragma once
#include <algorithm>
#include <cstddef>

#include "sph_solver/domain/kind.h"
#include "sph_solver/loops/records.h"

namespace tw {

/// Adds the rates of damping_layers.h.
struct DampInLayers {
    struct Layer {
        int axis;
        bool high;
        double face, width;  ///< [m]
    };
    static constexpr int most = 6;  ///< as many as a domain has faces

    StateView p;
    const Kind* kind;
    RateRecord* rate;
    Layer layers[most];
    int count;
    double strength;   ///< [1/s]
    double stream;     ///< [m/s]
    V3<double> moved;  ///< way of the layers [m]

    void operator()(std::size_t i) const {
        if (!follows_the_equations(kind[i])) return;
        const V3<double> x{p.x[i] - moved.x, p.y[i] - moved.y, p.z[i] - moved.z};
        double s = 0;
        for (int k = 0; k < count; ++k) {
            const Layer& l = layers[k];
            const double at = l.axis == 0 ? x.x : l.axis == 1 ? x.y : x.z;
            const double inside = l.high ? l.face - at : at - l.face;
            s = std::max(s, 1 - inside / l.width);
        }
        if (s <= 0) return;
        s = std::min(s, 1.0);
        const double by = strength * s * s;
        RateRecord& r = rate[i];
        r.ax -= static_cast<float>(by * (static_cast<double>(p.u[i]) - stream));
        r.ay -= static_cast<float>(by * static_cast<double>(p.v[i]));
        r.az -= static_cast<float>(by * static_cast<double>(p.w[i]));
    }
};

}  // namespace tw
