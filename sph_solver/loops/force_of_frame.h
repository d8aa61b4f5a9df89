#pragma once
#include "sph_solver/equations/vector.h"

namespace tw {

/// FrameForce of motion/moving_frame.h as plain numbers.
struct ForceOfFrame {
    V3<double> at_pivot;     ///< [m/s2]
    V3<double> pivot;        ///< [m]
    V3<double> gradient[3];  ///< its rows [1/s2]
    V3<double> spin;         ///< [rad/s]

    template <class FrameForce>
    static ForceOfFrame of(const FrameForce& f) {
        const auto plain = [](const auto& v) { return V3<double>{v.x(), v.y(), v.z()}; };
        const auto& G = f.gradient;
        return {plain(f.at_pivot),
                plain(f.pivot),
                {{G(0, 0), G(0, 1), G(0, 2)}, {G(1, 0), G(1, 1), G(1, 2)}, {G(2, 0), G(2, 1), G(2, 2)}},
                plain(f.spin)};
    }
    /// Adds in the order in which FrameForce::at does it.
    V3<double> at(const V3<double>& x, const V3<double>& u) const {
        const V3<double> r = x - pivot;
        const V3<double>&a = gradient[0], &b = gradient[1], &c = gradient[2];
        const V3<double> turned{a.x * r.x + a.y * r.y + a.z * r.z, b.x * r.x + b.y * r.y + b.z * r.z,
                                c.x * r.x + (c.y * r.y + c.z * r.z)};
        return at_pivot + turned - 2.0 * cross(spin, u);
    }
};

}  // namespace tw
