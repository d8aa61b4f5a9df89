#pragma once
#include "sph_solver/equations/vector.h"
#include "sph_solver/fields/law.h"
#include "sph_solver/loops/force_of_frame.h"
#include "sph_solver/loops/link_map.h"
#include "sph_solver/loops/pack_state.h"

namespace tw {

/// Water presses on a wall with dp/dn = rho g . n, not with dp/dn = 0: the mirrored field is the pressure less the
/// hydrostatic one. So an image carries on the source's hydrostatic line over `step` = image - source; without it the
/// pressure has a kink at a floor, which the diffusion turns into layers of alternating pressure (5 % of rho g H at the
/// floor of a channel). In a tank that moves g is all that the water feels there.
struct HydrostaticLine {
    V3<float> gradient;    ///< of the density [kg/m4]
    double deviation = 0;  ///< of the image's density from the source's [kg/m3]
    double pressure = 0;   ///< likewise [Pa]
};
struct Hydrostatic {
    double rho0, c0;  ///< [kg/m3], [m/s]
    HydrostaticLine line(const V3<double>& g, const V3<double>& step) const {
        return {gradient(g), deviation(g, step), pressure(g, step)};
    }
    double pressure(const V3<double>& g, const V3<double>& step) const {
        return rho0 * (g.x * step.x + (g.y * step.y + g.z * step.z));
    }
    double deviation(const V3<double>& g, const V3<double>& step) const { return pressure(g, step) / (c0 * c0); }
    V3<float> gradient(const V3<double>& g) const {  ///< of the density [kg/m4]
        const V3<double> of = rho0 / (c0 * c0) * g;
        return {static_cast<float>(of.x), static_cast<float>(of.y), static_cast<float>(of.z)};
    }
};

/// What water feels between particle i and its image, `step` from it: everywhere the same,
struct SameForce {
    V3<double> g;  ///< [m/s2]
    V3<double> operator()(std::size_t, const V3<double>&) const { return g; }
};
/// or, in a tank that moves, what it would feel halfway.
struct ForceHalfway {
    StateView p;
    ForceOfFrame force;
    V3<double> operator()(std::size_t i, const V3<double>& step) const {
        return force.at({p.x[i] + step.x / 2, p.y[i] + step.y / 2, p.z[i] + step.z / 2}, {p.u[i], p.v[i], p.w[i]});
    }
};

/// What an image has of its source's quantity, by the quantity's law and its elements' type.
template <Law law, class T>
T seen(const T& of, const LinkMap& map);

template <>
inline float seen<Law::scalar>(const float& s, const LinkMap&) {
    return s;
}
template <>
inline PackedVelocityDensity seen<Law::vector>(const PackedVelocityDensity& r, const LinkMap& map) {
    return {map.sign[0] * r.u, map.sign[1] * r.v, map.sign[2] * r.w, r.drho};
}
/// At rest on the plane, u_image = -u (the walls at rest of no_slip_velocity() in equations/viscosity.h).
template <>
inline PackedVelocityDensity seen<Law::held>(const PackedVelocityDensity& r, const LinkMap& map) {
    return {map.held[0] * r.u, map.held[1] * r.v, map.held[2] * r.w, r.drho};
}
template <>
inline PackedGradientPressure seen<Law::vector>(const PackedGradientPressure& r, const LinkMap& map) {
    return {map.sign[0] * r.gx, map.sign[1] * r.gy, map.sign[2] * r.gz, r.p};
}
template <>
inline CarriedShare seen<Law::tensor>(const CarriedShare& m, const LinkMap& map) {
    const float x = map.sign[0], y = map.sign[1], z = map.sign[2];
    return {m.xx, x * y * m.xy, x * z * m.xz, m.yy, y * z * m.yz, m.zz};
}
inline PackedPlace seen_place(const PackedPlace& p, const LinkMap& map) {
    return map.place(WidePlace{p.x, p.y, p.z}).packed(p.volume);
}
/// From a source to its image, but for the way that a periodic flow repeats after [m].
inline V3<double> step_to_image(const PackedPlace& from, const PackedPlace& to, const LinkMap& map, double unit) {
    const auto along = [&](std::int32_t a, std::int32_t b, bool repeats) {
        return repeats ? 0 : unit * difference(b, a);
    };
    return {along(from.x, to.x, map.repeats[0]), along(from.y, to.y, map.repeats[1]),
            along(from.z, to.z, map.repeats[2])};
}
inline PackedVelocityDensity seen_on(const HydrostaticLine& line, const PackedVelocityDensity& of, const LinkMap& map) {
    PackedVelocityDensity r = seen<Law::vector>(of, map);
    r.drho += static_cast<float>(line.deviation);
    return r;
}
inline PackedGradientPressure seen_on(const HydrostaticLine& line, PackedGradientPressure r, const LinkMap& map) {
    r.gx -= line.gradient.x, r.gy -= line.gradient.y, r.gz -= line.gradient.z;
    r = seen<Law::vector>(r, map);
    r.gx += line.gradient.x, r.gy += line.gradient.y, r.gz += line.gradient.z;
    r.p += static_cast<float>(line.pressure);
    return r;
}

/// Gives images what they have of values that stand before theirs, by a law that asks for no place.
template <Law law, class T>
struct SeeValues {
    const Link* links;
    const LinkMap* maps;
    std::size_t n;  ///< particles
    T* values;

    void operator()(std::size_t k) const {
        values[n + k] = seen<law>(values[static_cast<std::size_t>(links[k].index)], maps[links[k].map]);
    }
};
using SeeScalars = SeeValues<Law::scalar, float>;
using SeeVectors = SeeValues<Law::vector, PackedVelocityDensity>;
using SeeHeld = SeeValues<Law::held, PackedVelocityDensity>;

}  // namespace tw
