#pragma once
#include <cstddef>
#include <cstdint>

#include "sph_solver/domain/kind.h"
#include "sph_solver/fields/kept.h"
#include "sph_solver/fields/law.h"
#include "sph_solver/fields/quantities.h"
#include "sph_solver/pair_loops/packed.h"

// The quantities of a particle: its state, and what the pair loops read and write of it. Positions in double precision;
// density as the deviation from rho0, so that single precision loses nothing. A further quantity is one more line: host
// and GPU have their arrays, copies between them, sorting, splitting and merging, images, checkpoints and the
// prediction of memory from here.
//
// field(TYPE, NAME, LAW, KEPT, WITH): how an image has it (law.h), how long it stays with its particle, and which
// levels have it (kept.h). The first one is one that every particle has.

// clang-format off
#define TW_PARTICLE_FIELDS(field)                                                                                       \
    field(double,                 x,                 unseen,      saved,  water) /* [m] */                              \
    field(double,                 y,                 unseen,      saved,  water)                                        \
    field(double,                 z,                 unseen,      saved,  water)                                        \
    field(float,                  u,                 unseen,      saved,  water) /* [m/s] */                            \
    field(float,                  v,                 unseen,      saved,  water)                                        \
    field(float,                  w,                 unseen,      saved,  water)                                        \
    field(float,                  drho,              unseen,      saved,  water) /* rho - rho0 [kg/m3] */               \
    field(std::int64_t,           id,                unseen,      saved,  water) /* never reused */                     \
    field(Kind,                   kind,              unseen,      saved,  water)                                        \
    field(Trend,                  trend,             unseen,      moved,  coarser) /* of buffer particles */            \
    field(EdgeDistance,           from_edge,         unseen,      moved,  coarser) /* of the own zone */                \
    field(Daughters,              daughters,         unseen,      saved,  finer)                                        \
    field(float,                  compression,       unseen,      saved,  finer) /* of the overlap [kg/m3/s] */         \
    field(EdgeDistance,           from_finer_edge,   unseen,      moved,  finer)                                        \
    field(PackedPlace,            place,             place,       sorted, water)                                        \
    field(PackedVelocityDensity,  velocity_density,  hydrostatic, sorted, water)                                        \
    field(PackedGradientPressure, gradient_pressure, hydrostatic, sorted, water)                                        \
    field(PackedShiftSupport,     shift_support,     unseen,      sorted, water)                                        \
    field(PackedRate,             rate,              unseen,      sorted, water)                                        \
    field(PackedWallNormal,       wall_normal,       unseen,      sorted, walls) /* the nearest wall */                 \
    field(PackedLeaving,          wall_leaving,      unseen,      sorted, walls) /* the way off its edges */            \
    field(std::uint16_t,          wall_body,         unseen,      sorted, moving_bodies) /* whose wall it is */         \
    field(std::int32_t,           wall_triangle,     unseen,      sorted, elastic_bodies) /* on which triangle of it */ \
    field(CarriedShare,           carried,           tensor,      sorted, control_volume)                               \
    field(Aired,                  aired,             unseen,      saved,  ventilation)                                  \
    field(float,                  calm_height,       unseen,      saved,  sea_at_inlet) /* of the inlet's, without waves [m] */ \
    field(float,                  density_rate,      unseen,      sorted, coarser) /* last -rho div u [kg/m3/s] */
// clang-format on

namespace tw {

/// What the list says of a field, for templates.
template <Law law, Kept kept, With with>
struct AboutField {
    static constexpr bool moves = kept != Kept::sorted;
    static constexpr With had_with = with;               ///< what a level has that has it
    static constexpr bool always = with == With::water;  ///< every level has it
    /// Found with the nearest wall, and exchanged between ranks then.
    static constexpr bool of_walls = with == With::walls || with == With::moving_bodies || with == With::elastic_bodies;
};

/// All of them, each as an `As` of its type: arrays on a device, pointers for loops.
template <template <class> class As>
struct FieldsAs {
#define TW_AS(Type, name, law, kept, with) As<Type> name{};
    TW_PARTICLE_FIELDS(TW_AS)
#undef TW_AS

    /// Calls `f(field, other, about)` for each, with what `others` calls by the same name.
    template <class Self, class Others, class Function>
    static void each(Self& self, Others& others, const Function& f) {
#define TW_EACH(Type, name, law, kept, with) f(self.name, others.name, AboutField<Law::law, Kept::kept, With::with>{});
        TW_PARTICLE_FIELDS(TW_EACH)
#undef TW_EACH
    }
    /// The same for what stays with a particle when particles are sorted, come and go.
    template <class Self, class Others, class Function>
    static void each_moving(Self& self, Others& others, const Function& f) {
        each(self, others, [&f](auto& field, auto& other, auto about) {
            if constexpr (decltype(about)::moves) f(field, other);
        });
    }
};

template <class T>
using PointerTo = T*;
template <class T>
using OneOf = T;

/// Where they are; null: the level's particles have none.
struct FieldsView : FieldsAs<PointerTo> {
    /// Of what moves, particle i becomes what particle k of another view of the same level is.
    void copy(std::size_t i, const FieldsView& from, std::size_t k) const {
        each(*this, from, [i, k](auto* to, const auto* of, auto about) {
            if constexpr (decltype(about)::moves) {
                if (decltype(about)::always || to) to[i] = of[k];
            }
        });
    }
    /// Beside its state it has what new ones have.
    void begin(std::size_t i) const {
        each(*this, *this, [i](auto* field, const auto*, auto about) {
            if constexpr (decltype(about)::moves && !decltype(about)::always) {
                if (field) field[i] = {};
            }
        });
    }
};

}  // namespace tw
