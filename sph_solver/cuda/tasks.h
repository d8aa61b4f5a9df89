#pragma once
// What a device is asked to do beside the pair loops: plain data for kernels, each with what is done to one particle,
// image, word or cluster. `Task::operator()(i)` is one index's part; any order of them gives the same.
#include <cstddef>
#include <cstdint>

#include "sph_solver/device/launch.h"
#include "sph_solver/equations/state_equation.h"
#include "sph_solver/fields/field_list.h"
#include "sph_solver/ghosts/laws.h"
#include "sph_solver/loops/after_first_pair_loop.h"
#include "sph_solver/loops/move.h"
#include "sph_solver/loops/pack_state.h"
#include "sph_solver/loops/surface.h"
#include "sph_solver/loops/wall_motion.h"
#include "sph_solver/pair_loops/clusters.h"

namespace tw::cuda {

/// Places of images, and what they have of their sources. `Force`: SameForce or ForceHalfway.
template <class Force>
struct RefreshImages {
    const Link* links;
    const LinkMap* maps;
    std::size_t n;   ///< particles
    double unit;     ///< a fixed-point unit [m]
    Hydrostatic still;
    Force force;
    PackedPlace* place;
    PackedVelocityDensity* motion;
    PackedGradientPressure* stress;  ///< null: not now

    void operator()(std::size_t k) const {
        const auto i = static_cast<std::size_t>(links[k].index);
        const LinkMap& map = maps[links[k].map];
        place[n + k] = seen_place(place[i], map);
        const V3<double> step = step_to_image(place[i], place[n + k], map, unit);
        const HydrostaticLine line = still.line(force(i, step), step);
        motion[n + k] = seen_on(line, motion[i], map);
        if (stress) stress[n + k] = seen_on(line, stress[i], map);
    }
};

template <class Force>
RefreshImages(const Link*, const LinkMap*, std::size_t, double, Hydrostatic, Force, PackedPlace*,
              PackedVelocityDensity*, PackedGradientPressure*) -> RefreshImages<Force>;
using RefreshImagesAtRest = RefreshImages<SameForce>;
using RefreshImagesInFrame = RefreshImages<ForceHalfway>;

/// Marks those at the free surface; by words of 32.
struct MarkSurface {
    LacksSupport lacks_support;
    const Link* links;
    std::size_t n, all;
    std::uint32_t* words;

    void operator()(std::size_t word) const { MarkBits{lacks_support, links, n, all, words}(word); }
};

struct LinearPressure {
    float c0_squared;  ///< [m2/s2]
    float operator()(float drho) const { return c0_squared * drho; }
};
struct PressureOfState {
    StateEquation state;
    double rho0;  ///< [kg/m3]
    float operator()(float drho) const { return state.pressure(rho0, drho); }
};
/// AfterFirstPairLoop beside walls.
template <class Pressure>
struct Compress {
    AfterFirstPairLoop after;
    NearWalls walls;
    Pressure pressure;

    void operator()(std::size_t i) const {
        after(i, pressure, [&](std::size_t k, const V3<double>& u) {
            return walls.leaving(k, {after.p.x[k], after.p.y[k], after.p.z[k]}, u);
        });
    }
};
template <class Pressure>
Compress(AfterFirstPairLoop, NearWalls, Pressure) -> Compress<Pressure>;
using CompressLinearly = Compress<LinearPressure>;
using CompressByState = Compress<PressureOfState>;

/// Move beside walls. A particle too near to one is left to the host: it is put on a list, in no order, and does
/// not count for the extremes.
struct MoveAll {
    Move move;
    PackedWallNormal* wall;  ///< null: there are none
    NearWalls walls;
    double held_from;  ///< nearer than this to a wall a particle is held [m]
    std::int32_t* too_near;
    int* count;

    template <class AddOne>
    void operator()(std::size_t i, MovedExtremes& part, const AddOne& add_one) const {
        const V3<double> shift = move.kick(i, part);
        const V3<double> along = move.along(i);
        move.drift_along(i, along, shift);
        if (wall && kept_out_of_solids(move.kind[i])) {
            PackedWallNormal& r = wall[i];
            const double leaving = walls.leaving(i, {move.p.x[i], move.p.y[i], move.p.z[i]}, along);
            r.distance += static_cast<float>(move.drift * leaving + dot(shift, normal_of(r)));
            if (static_cast<double>(r.distance) < held_from) {
                too_near[add_one(count)] = static_cast<std::int32_t>(i);
                return;
            }
        }
        move.note(i, part);
    }
};

/// The larger of each; of equal ones that of the lower index, which comes first.
inline void join(MovedExtremes& a, const MovedExtremes& b) {
    const auto take = [](double& x, std::size_t& at, double y, std::size_t of, bool better) {
        if (better || (x == y && of < at)) x = y, at = of;
    };
    if (b.broken && (!a.broken || b.fastest < a.fastest)) {
        a.broken = true, a.fastest = b.fastest;
    } else if (!a.broken) {
        take(a.speed2, a.fastest, b.speed2, b.fastest, b.speed2 > a.speed2);
    }
    take(a.low, a.thinnest, b.low, b.thinnest, b.low < a.low);
    take(a.high, a.densest, b.high, b.densest, b.high > a.high);
    const auto most = [](double& x, double y) { x = y > x ? y : x; };
    most(a.relative2, b.relative2), most(a.relative2_before, b.relative2_before);
    most(a.shift2, b.shift2), most(a.acceleration2, b.acceleration2);
}

/// One particle that the host has to look after: its state, and the wall near it.
struct HeldParticle : FieldsAs<OneOf> {
    std::int64_t index = 0;

    /// Whether `about` is of what the host may change.
    template <class About>
    static constexpr bool has(About) {
        return About::moves || About::of_walls;
    }
};
/// Takes such particles out of the arrays, and puts them back.
struct TakeHeld {
    FieldsView p;
    const std::int32_t* which;
    HeldParticle* to;

    void operator()(std::size_t k) const {
        const std::int64_t i = which[k];
        to[k].index = i;
        FieldsView::each(p, to[k], [i](const auto* field, auto& held, auto about) {
            if constexpr (HeldParticle::has(decltype(about){})) {
                if (field) held = field[i];
            }
        });
    }
};
struct PutHeld {
    const HeldParticle* from;
    FieldsView p;

    void operator()(std::size_t k) const {
        const std::int64_t i = from[k].index;
        FieldsView::each(p, from[k], [i](auto* field, const auto& held, auto about) {
            if constexpr (HeldParticle::has(decltype(about){})) {
                if (field) field[i] = held;
            }
        });
    }
};

}  // namespace tw::cuda
