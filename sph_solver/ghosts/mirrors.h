#pragma once
#include <array>
#include <cstdint>
#include <vector>

#include "base/vec3.h"
#include "sph_solver/backend/pass_data.h"
#include "sph_solver/domain/mirrors.h"
#include "sph_solver/fields/particles.h"
#include "sph_solver/neighbours/columns.h"

namespace tw {

/// One image of a particle, three bits an axis: beyond the low (1) or high (2) face, reflected there, or (with 4) moved
/// by the domain's length.
struct MirrorImage {
    std::int32_t source = 0;
    std::uint16_t planes = 0;
    int plane(int axis) const { return (planes >> (3 * axis)) & 3; }
    bool moved(int axis) const { return ((planes >> (3 * axis)) & 4) != 0; }
    bool reflected(int axis) const { return plane(axis) != 0 && !moved(axis); }
    float sign(int axis) const { return reflected(axis) ? -1.0f : 1.0f; }  ///< of vectors
};

/// All images of particles within `reach` of a plane or periodic face, corners included.
std::vector<MirrorImage> make_mirror_images(const Mirrors& mirrors, const Box& domain, const Particles& particles,
                                            double reach);

/// Makes the places of a domain's images, by one entry for each combination of planes: x' = offset + x, or offset - x
/// where `turn` is -1 (else 0), in quanta.
class MirrorPlanes {
public:
    MirrorPlanes(const Box& domain, const Quanta& quanta);
    PlaceRecord place(const PlaceRecord& p, const MirrorImage& image) const {
        return place(WidePlace{p.x, p.y, p.z}, image).record(p.volume);
    }
    WidePlace place(const WidePlace& p, const MirrorImage& image) const {
        const Map& m = maps_[image.planes];
        return {coordinate(p.x, m, 0), coordinate(p.y, m, 1), coordinate(p.z, m, 2)};
    }

private:
    struct Map {
        std::int64_t offset[3] = {}, turn[3] = {};
    };
    static std::int64_t coordinate(std::int64_t x, const Map& m, int a) {
        return m.offset[a] + ((x ^ m.turn[a]) - m.turn[a]);
    }
    std::array<Map, 512> maps_;
};
inline VelocityDensityRecord mirrored(const VelocityDensityRecord& m, const MirrorImage& image) {
    return {image.sign(0) * m.u, image.sign(1) * m.v, image.sign(2) * m.w, m.drho};
}
/// The same for the friction of walls that hold the water: at rest on the plane, u_image = -u (the walls at rest of
/// no_slip_velocity() in equations/viscosity.h).
inline VelocityDensityRecord mirrored_by_holding(const VelocityDensityRecord& m, const MirrorImage& image,
                                                 const Mirrors& mirrors) {
    VelocityDensityRecord v = mirrored(m, image);
    for (int axis = 0; axis < 3; ++axis) {
        if (!image.reflected(axis)) continue;
        if (!mirrors.holding[static_cast<std::size_t>(axis)][static_cast<std::size_t>(image.plane(axis) - 1)]) continue;
        const float turned[3] = {axis == 0 ? v.u : -v.u, axis == 1 ? v.v : -v.v, axis == 2 ? v.w : -v.w};
        v.u = turned[0], v.v = turned[1], v.w = turned[2];
    }
    return v;
}
inline GradientPressureRecord mirrored(const GradientPressureRecord& s, const MirrorImage& image) {
    return {image.sign(0) * s.gx, image.sign(1) * s.gy, image.sign(2) * s.gz, s.p};
}
inline CarriedShare mirrored(const CarriedShare& m, const MirrorImage& image) {
    const float x = image.sign(0), y = image.sign(1), z = image.sign(2);
    return {m.xx, x * y * m.xy, x * z * m.xz, m.yy, y * z * m.yz, m.zz};
}

/// Water presses on a wall with dp/dn = rho g . n, not with dp/dn = 0: the mirrored field is the pressure less the
/// hydrostatic one. So an image carries on the source's hydrostatic line over `step` = image - source; without it the
/// pressure has a kink at a floor, which the diffusion turns into layers of alternating pressure (5 % of rho g H at the
/// floor of a channel). In a tank that moves g is all that the water feels there.
struct Hydrostatic {
    double rho0, c0;
    double pressure(const Vec3& g, const Vec3& step) const { return rho0 * g.dot(step); }
    double deviation(const Vec3& g, const Vec3& step) const { return pressure(g, step) / (c0 * c0); }
    Vec3 gradient(const Vec3& g) const { return rho0 / (c0 * c0) * g; }  ///< of the density [kg/m4]
};

/// A particle that has crossed a plane or periodic face has changed places with its own image: puts it back. Returns
/// how many.
std::int64_t return_from_mirrors(const Mirrors& mirrors, const Box& domain, Particles& particles);

}  // namespace tw
