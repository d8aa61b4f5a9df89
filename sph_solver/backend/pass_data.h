#pragma once
#include <cstdint>

#include "sph_solver/domain/kind.h"
#include "sph_solver/equations/kernel.h"

namespace tw {

// What the pair passes read and write: plain arrays, so that the passes can be compiled once per instruction set (and
// for a GPU) without dragging other code along. One neighbour costs three 16-byte loads.

/// Position in units of `quantum`, modulo 2^32; volume m/rho [m3].
struct alignas(16) PlaceRecord {
    std::int32_t x, y, z;
    float volume;
};
/// a - b for coordinates modulo 2^32: exact for places up to 8000 dp apart, however long the domain is.
[[gnu::always_inline]] constexpr std::int32_t difference(std::int32_t a, std::int32_t b) {
    return static_cast<std::int32_t>(static_cast<std::uint32_t>(a) - static_cast<std::uint32_t>(b));
}
/// Velocity [m/s] and density deviation rho - rho0 [kg/m3].
struct alignas(16) VelocityDensityRecord {
    float u, v, w, drho;
};
/// Renormalised density gradient [kg/m4] and pressure [Pa].
struct alignas(16) GradientPressureRecord {
    float gx, gy, gz, p;
};

/// Neighbours: of the 32 places from `first` on, those whose bit is set. Sorted places lie in runs, so that a neighbour
/// costs two bytes instead of an index's four and a list is a quarter as long.
struct NeighbourBlock {
    std::int32_t first;
    std::uint32_t live;   ///< what the sweeps visit: who is within reach now or might be
    std::uint32_t maybe;  ///< who may come and go before the lists are made anew; asked by the `prune` pass
};

/// Where a group's blocks are: `size` of them from `first` on in one chunk of Lists. Not a pointer, so that groups may
/// be copied and sent to another device.
struct ListRef {
    std::int32_t chunk = 0, first = 0, size = 0;
};
/// The storage that ListRefs refer to.
struct Lists {
    NeighbourBlock* const* chunks = nullptr;
    NeighbourBlock* blocks(const ListRef& r) const { return r.size > 0 ? chunks[r.chunk] + r.first : nullptr; }
};

inline constexpr int most_lanes = 16;

/// A group of up to Passes::lanes particles that are neighbours in space and in memory.
struct Group {
    std::int32_t first = 0, size = 0;  ///< particles [first, first + size)
    ListRef list;                      ///< its neighbours among particles and mirror images
    ListRef wall_list;                 ///< its neighbours among the wall's dummy particles
    std::int32_t wall_load = -1;       ///< index of its first WallLoad; -1: no wall near
    std::int32_t x = 0, y = 0, z = 0;  ///< centre, in quanta: pair coordinates are relative to it
};
static_assert(sizeof(Group) == 48);

/// What tells whether a place x is within reach of a group's particles x_l, all relative to its centre [quanta]:
/// |x - x_l|^2 = |x|^2 + (n_l + a_l x + b_l y + c_l z), n = |x_l|^2, (a, b, c) = -2 x_l. Lanes beyond its size repeat
/// the last particle. Good to a millionth of the reach for a group of water; spray may stand hundreds of spacings apart
/// in one group, and then who is at the reach's rim, where the kernel vanishes, is known to 1e-4 of it only.
struct alignas(64) GroupReach {
    float n[most_lanes], a[most_lanes], b[most_lanes], c[most_lanes];
    std::int32_t x, y, z;     ///< the group's centre
    float far2, now2, sure2;  ///< squared reaches [quanta^2]
};

/// Who is on a list: within `far`, so that the list lasts a while; live at first: within `now`; never asked again:
/// within `sure`, because nobody goes so far before the list is made anew. `stale`: how far the sources may have moved
/// since they were sorted. Lengths in whatever unit their user says.
struct Reaches {
    double far, now, sure, stale = 0;
    Reaches operator/(double unit) const { return {far / unit, now / unit, sure / unit, stale / unit}; }
};
struct Reached {
    std::uint32_t far, now, sure;
};

/// Per-particle result of the gradient pass.
struct alignas(16) ShiftSupportRecord {
    float x, y, z;  ///< min(b v_i, c0 / 10) s_i of shifting.h [1/s]; after the second sweep along the free surface
    float support;  ///< sum_j V_j W_ij, walls and the particle itself counted [-]
};
/// What the other phase adds to the first sweep's sums, see equations/level_pair.h: of shifting [1/m], support [-],
/// div u [1/s], v^2 of shifting [m2/s2].
struct OtherSums {
    float x, y, z, support, divergence, difference2;
};
/// Per-particle rates [m/s2], [kg/m3/s].
struct alignas(16) RateRecord {
    float ax, ay, az, drho;
};
/// What the walls of one body do to one group, per unit of particle mass: sum of the accelerations, and of arm x
/// acceleration about the group's centre (pair forces are central, so the arm may end at the fluid particle).
struct WallLoad {
    float ax = 0, ay = 0, az = 0, mx = 0, my = 0, mz = 0;
    std::int32_t body = 0;
};
/// Velocity of the solid at a dummy [m/s].
struct alignas(16) WallVelocity {
    float u, v, w;
};
/// Acceleration of the solid at a dummy [m/s2].
struct alignas(16) WallAcceleration {
    float x, y, z;
};
/// Exterior unit normal of the nearest wall at a fluid particle (zero when none is near) and the distance from it [m]
/// (far when none is near), carried along between two searches by the particle's motion along the normal.
struct alignas(16) WallNormalRecord {
    float x, y, z, distance;
};
inline constexpr WallNormalRecord no_wall{0, 0, 0, 1e30f};

/// The way past the nearest wall of a particle beyond an edge: unit vector, and squared speed [m2/s2]; zero elsewhere.
struct alignas(16) LeavingRecord {
    float x, y, z, speed2;
};

/// How much of the pressure the pair forces carry from a particle: m = sum_j r_ji (x) grad_i W_ij V_j. In the continuum it
/// is the unit tensor; among particles the momentum flux is the sum of V p m over those in a volume, not p of it.
struct CarriedShare {
    float xx, xy, xz, yy, yz, zz;
};

struct PassData {
    Lists list, wall_list;  ///< of the groups
    // the particles and their mirror images, in one index space; then the wall's dummy particles in their own
    const PlaceRecord* place = nullptr;
    const VelocityDensityRecord* motion = nullptr;
    GradientPressureRecord* stress = nullptr;
    const PlaceRecord* wall_place = nullptr;
    const float* wall_p = nullptr;
    const WallVelocity* wall_velocity = nullptr;  ///< null: all walls are at rest
    /// Body b has the dummies [body_end[b - 1], body_end[b]), the first one from 0; null where there is one body. A
    /// group's wall blocks are ordered by body, none has dummies of two.
    const std::int32_t* body_end = nullptr;
    int bodies = 1;
    const WallNormalRecord* normal = nullptr;
    const LeavingRecord* leaving = nullptr;  ///< of the particles, see edge_release.h; null: none leaves an edge
    /// Bit i % 32 of word i / 32: place i is at the free surface. One word more than that at the end.
    const std::uint32_t* surface = nullptr;
    ShiftSupportRecord* shift = nullptr;
    RateRecord* rate = nullptr;
    WallLoad* wall_load =
        nullptr;  ///< from Group::wall_load on one for each body that the group has in reach, in order
    /// Of the particles: only active ones load a body, and only those that follow the equations have rates; null: all
    /// of them are and do.
    const Kind* kind = nullptr;
    CarriedShare* carried = nullptr;   ///< may be null
    const OtherSums* other = nullptr;  ///< null: there is one phase

    Kernel kernel;
    float quantum = 1;  ///< [m]
    float rho0 = 1000;
    float inv_mass = 1;            ///< of a particle [1/kg]
    float inv_W_dp = 0;            ///< 1 / W(dp)
    float diffusion = 0;           ///< delta c0 [m/s], see DensityDiffusion
    float viscosity = 0;           ///< alpha c0 rho0 / 2 [kg/m2/s], see ArtificialViscosity
    float fastest_shift = 0;       ///< c0 / 10 [m/s], see Shifting
    float inv_dp = 0;              ///< [1/m]
    float inv_void = 10;           ///< 1 / (1 - touch_support), see WallTouch
    float gx = 0, gy = 0, gz = 0;  ///< body force [m/s2]
    bool two_dimensional = false;
    float tension_control_from = 2;  ///< kernel support from which tension is controlled; above 1.5: nowhere
};

/// Points at which fields are extrapolated from the fluid: wall dummies, surface samples, probes.
struct ExtrapolateData {
    Lists list;
    const PlaceRecord* at = nullptr;  ///< the points, in groups as particles are
    const PlaceRecord* place = nullptr;
    const VelocityDensityRecord* motion = nullptr;
    const GradientPressureRecord* stress = nullptr;
    const WallAcceleration* acceleration = nullptr;  ///< of the points; null: at rest
    float* p = nullptr;                              ///< [Pa]
    float* support = nullptr;                        ///< sum_j V_j W_ij; may be null
    const CarriedShare* carried = nullptr;           ///< of the particles; may be null
    float* flux = nullptr;  ///< 6 per point, as those of CarriedShare: sum_j p_j m V_j W [Pa]; needs `carried`
    Kernel kernel;
    float quantum = 1, rho0 = 1000;
    float gx = 0, gy = 0, gz = 0;
};

/// Which neighbours of the groups' lists are within reach.
struct PruneData {
    Lists lists;
    ListRef Group::*list = &Group::list;
    const PlaceRecord* of = nullptr;     ///< the groups' places
    const PlaceRecord* place = nullptr;  ///< those that the lists refer to
    double reach = 0;                    ///< [quanta]
};

struct VelocityData;
struct ViscousData;
struct StrainData;
struct ColourData;
struct LevelPairData;
struct InterpolateData;

/// The pair passes of one instruction set.
struct Passes {
    const char* isa;
    int lanes;  ///< largest size of a group
    void (*prune)(const PruneData&, const Group*, int count);
    void (*continuity_and_gradient)(const PassData&, const Group*,
                                    int count);  ///< fills shift, stress.g and rate.drho = -rho div u
    void (*forces)(const PassData&, const Group*,
                   int count);  ///< fills rate; rate.drho = density diffusion; shift along surfaces
    void (*extrapolate)(const ExtrapolateData&, const Group*, int count);
    GroupReach (*reach_of)(const PlaceRecord* places, const Group&, const Reaches& quanta);
    /// Which of `count` <= 32 places sorted by z, those not above `top` (from the group's centre), are within the
    /// reaches of a particle of the group. Reads no place from `end` on.
    Reached (*reached)(const GroupReach&, const PlaceRecord* first, const PlaceRecord* end, int count,
                       std::int64_t top);
    // of the effects, see effects/passes.h
    void (*water_velocity)(const VelocityData&, const Group*, int count);
    void (*viscous_forces)(const ViscousData&, const Group*, int count);
    void (*strain_rate)(const StrainData&, const Group*, int count);
    void (*colour_gradient)(const ColourData&, const Group*, int count);
    void (*surface_curvature)(const ColourData&, const Group*, int count);
    void (*meet_other_phase)(const LevelPairData&, const Group*, int count);
    void (*press_other_phase)(const LevelPairData&, const Group*, int count);
    void (*interpolate)(const InterpolateData&, const Group*, int count);  ///< see levels/interpolate.h
};
/// The default of this processor, or what TWINWAKE_ISA names; see choose_passes.h.
const Passes& passes();
/// By name. Throws InputError for one that this processor cannot run.
const Passes& passes(const char* isa);

}  // namespace tw
