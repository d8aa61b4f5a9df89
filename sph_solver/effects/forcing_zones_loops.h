#pragma once
#include <algorithm>
#include <cstddef>

#include "sph_solver/domain/kind.h"
#include "sph_solver/loops/pack_state.h"
#include "waves/wave_components.h"

namespace tw {

/// Adds the rates of forcing_zones.h.
struct ForceInZones {
    struct Zone {
        int axis;
        double begin, per_length;  ///< [m], 1 / (end - begin) [1/m]
        double gamma;              ///< [1/s]
        double share;              ///< of the stream's velocity [-]
    };
    static constexpr int most = 6;  ///< as many as a domain has faces

    StateView p;
    const Kind* kind;
    PackedRate* rate;
    Zone zones[most];
    int count;
    double stream;       ///< [m/s]
    double behind_from;  ///< [m]: behind it the start accelerates the water by `behind` more
    double behind;       ///< [m/s2]

    void operator()(std::size_t i) const {
        if (!follows_the_equations(kind[i])) return;
        if (p.x[i] > behind_from) rate[i].ax += static_cast<float>(behind);
        double by = 0, share = 1;
        for (int k = 0; k < count; ++k) {
            const Zone& z = zones[k];
            const double at = z.axis == 0 ? p.x[i] : z.axis == 1 ? p.y[i] : p.z[i];
            const double s = std::min((at - z.begin) * z.per_length, 1.0);
            if (s > 0 && z.gamma * s * s > by) by = z.gamma * s * s, share = z.share;
        }
        if (by == 0) return;
        PackedRate& r = rate[i];
        r.ax -= static_cast<float>(by * (static_cast<double>(p.u[i]) - share * stream));
        r.ay -= static_cast<float>(by * static_cast<double>(p.v[i]));
        r.az -= static_cast<float>(by * static_cast<double>(p.w[i]));
    }
};

/// The same where some of the zones draw the water to a wave, the others to the stream or to rest. `Wave`: a regular
/// one, or a sum of linear ones at that time.
template <class Wave>
struct ForceTowards {
    StateView p;
    const Kind* kind;
    PackedRate* rate;
    ForceInZones::Zone zones[ForceInZones::most];
    bool makes_wave[ForceInZones::most];
    int count;
    double time;    ///< [s]
    double stream;  ///< [m/s]
    Wave wave;

    void operator()(std::size_t i) const {
        if (!follows_the_equations(kind[i])) return;
        double by = 0;
        bool to_wave = false;
        for (int k = 0; k < count; ++k) {
            const ForceInZones::Zone& z = zones[k];
            const double at = z.axis == 0 ? p.x[i] : p.y[i], s = std::min((at - z.begin) * z.per_length, 1.0),
                         here = z.gamma * s * s;
            if (s > 0 && here > by) by = here, to_wave = makes_wave[k];
        }
        if (by == 0) return;
        double u = stream, v = 0, w = 0;
        if (to_wave) velocity(wave, i, u, v, w);
        PackedRate& r = rate[i];
        r.ax -= static_cast<float>(by * (static_cast<double>(p.u[i]) - u));
        r.ay -= static_cast<float>(by * (static_cast<double>(p.v[i]) - v));
        r.az -= static_cast<float>(by * (static_cast<double>(p.w[i]) - w));
    }

private:
    void velocity(const WaveSum& of, std::size_t i, double& u, double& v, double& w) const {
        wave_velocity(of, p.x[i], p.y[i], p.z[i], time, u, v, w);
    }
    void velocity(const WaveMoment& of, std::size_t i, double& u, double& v, double& w) const {
        wave_velocity(of, p.x[i], p.y[i], p.z[i], u, v, w);
    }
};
struct ForceTowardsWave : ForceTowards<WaveSum> {};
struct ForceTowardsSea : ForceTowards<WaveMoment> {};
static_assert(sizeof(ForceTowardsSea) <= 4096, "a device takes no more as the argument of a kernel");

}  // namespace tw
