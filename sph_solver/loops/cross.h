#pragma once
#include <cstddef>

#include "sph_solver/domain/kind.h"
#include "sph_solver/loops/pack_state.h"

namespace tw {

/// Which faces of the domain are open and which are planes, of one axis after another.
struct Faces {
    double low[3], high[3];  ///< [m]
    bool mirror[3][2] = {};  ///< [axis][0 low, 1 high]
    bool periodic[3] = {};
};

/// What becomes of a particle that has passed the inlet's or the outlet's plane of a stream along x.
struct CrossOpenings {
    double x_min, x_max;  ///< the planes [m]
    double buffer;        ///< length of the water beyond them [m]
    double dp;            ///< [m]

    enum class Outcome { stays, enters, leaves };
    Outcome operator()(double x, Kind& kind) const {
        switch (kind) {
            case Kind::inlet:
                if (x < x_min) break;
                kind = Kind::fluid;
                return Outcome::enters;
            case Kind::fluid:
                if (x > x_max)
                    kind = Kind::outlet;
                else if (x < x_min - 0.5 * dp)
                    return Outcome::leaves;  // washed back into the inlet
                break;
            case Kind::outlet:
            case Kind::buffer:
            case Kind::overlap:
            case Kind::slave:
                if (x > x_max + buffer) return Outcome::leaves;
                break;
        }
        return Outcome::stays;
    }
};

/// A particle that has crossed a plane or periodic face has changed places with its own image: puts it back. How often.
struct ReturnFromMirrors {
    StateView p;
    Faces faces;

    int operator()(std::size_t i) const {
        double* const place[3] = {p.x + i, p.y + i, p.z + i};
        float* const velocity[3] = {p.u + i, p.v + i, p.w + i};
        int returned = 0;
        for (int a = 0; a < 3; ++a) {
            double& x = *place[a];
            if (faces.periodic[a]) {
                const double length = faces.high[a] - faces.low[a];
                const double back = x < faces.low[a] ? length : x >= faces.high[a] ? -length : 0;
                x += back;
                returned += back != 0;
            }
            for (int side = 0; side < 2; ++side) {
                if (!faces.mirror[a][side]) continue;
                const double plane = side == 0 ? faces.low[a] : faces.high[a];
                if (side == 0 ? x >= plane : x <= plane) continue;
                x = 2 * plane - x;
                *velocity[a] = -*velocity[a];
                ++returned;
            }
        }
        return returned;
    }
};

/// The map's number (LinkMaps): three bits an axis, beyond the low (1) or high (2) face, reflected there, or (with 4)
/// moved by the domain's length. Calls `image(number)` for all that a particle at (x, y, z) has within `reach` of the
/// faces.
struct ImagesNear {
    static constexpr unsigned low = 1, high = 2, moved = 4;
    Faces faces;
    double reach;  ///< [m]

    template <class Image>
    void operator()(double x, double y, double z, const Image& image) const {
        const double place[3] = {x, y, z};
        unsigned choices[3][3], count[3];
        for (int a = 0; a < 3; ++a) {
            choices[a][0] = 0;
            count[a] = 1;
            const bool near_low = place[a] - faces.low[a] < reach, near_high = faces.high[a] - place[a] < reach;
            if (faces.periodic[a]) {
                if (near_high) choices[a][count[a]++] = low | moved;
                if (near_low) choices[a][count[a]++] = high | moved;
                continue;
            }
            if (faces.mirror[a][0] && near_low) choices[a][count[a]++] = low;
            if (faces.mirror[a][1] && near_high) choices[a][count[a]++] = high;
        }
        for (unsigned c = 0; c < count[2]; ++c)
            for (unsigned b = 0; b < count[1]; ++b)
                for (unsigned a = 0; a < count[0]; ++a)
                    if (const unsigned number = choices[0][a] | choices[1][b] << 3 | choices[2][c] << 6) image(number);
    }
};

}  // namespace tw
