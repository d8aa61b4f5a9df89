#pragma once
// What each pair loop reads and writes: plain arrays and numbers, so that a pair loop can be compiled once per variant
// (and for a GPU) without dragging other code along. What the pair loops over the water have in common is a WaterView
// and, where they meet walls, a WallView. Those of the effects stand beside the effects.
#include <cstdint>

#include "sph_solver/domain/kind.h"
#include "sph_solver/equations/kernel.h"
#include "sph_solver/pair_loops/clusters.h"
#include "sph_solver/pair_loops/packed.h"

namespace tw {

/// One level's particles and their mirror images, in one index space, and who of them meets whom.
struct WaterView {
    Lists list{};  ///< Cluster::list
    const PackedPlace* place = nullptr;
    const PackedVelocityDensity* motion = nullptr;
    const PackedGradientPressure* stress = nullptr;
    /// Bit i % 32 of word i / 32: place i is at the free surface. One word more than that at the end.
    const std::uint32_t* surface = nullptr;
    /// Of the particles: only active ones load a body, and only those that follow the equations have rates; null: all
    /// of them are and do.
    const Kind* kind = nullptr;
    Kernel kernel{};
    float unit = 1;      ///< a fixed-point unit [m]
    float rho0 = 1000;   ///< [kg/m3]
    float inv_mass = 1;  ///< of a particle [1/kg]
    bool two_dimensional = false;
};

/// The walls' dummy particles, in an index space of their own.
struct WallView {
    Lists list{};                            ///< Cluster::wall_list
    const PackedPlace* place = nullptr;      ///< null: the pair loop meets none
    const float* p = nullptr;                ///< pressure of the dummies [Pa]
    const WallVelocity* velocity = nullptr;  ///< null: all walls are at rest
    /// Body b has the dummies [body_end[b - 1], body_end[b]), the first one from 0; null where there is one body. A
    /// cluster's wall blocks are ordered by body, none has dummies of two.
    const std::int32_t* body_end = nullptr;
    int bodies = 1;
    const PackedWallNormal* normal = nullptr;  ///< of the particles
};

/// Which neighbours of the clusters' lists are within reach.
struct PruneData {
    Lists lists;
    ListRef Cluster::*list = &Cluster::list;
    const PackedPlace* of = nullptr;     ///< the clusters' places
    const PackedPlace* place = nullptr;  ///< those that the lists refer to
    double reach = 0;                    ///< [fixed-point units]
};

/// The first pair loop of a step: -div u, and what the second one needs of the neighbourhood.
struct FirstPairLoopData {
    WaterView water{};
    WallView walls{};
    const OtherSums* other = nullptr;          ///< null: there is one phase
    PackedGradientPressure* stress = nullptr;  ///< gets the density gradient
    PackedShiftSupport* shift = nullptr;
    PackedRate* rate = nullptr;       ///< gets drho = -rho div u
    CarriedShare* carried = nullptr;  ///< may be null
    float inv_W_dp = 0;               ///< 1 / W(dp) [m3]
    float fastest_shift = 0;          ///< c0 / 10 [m/s], see Shifting
    float inv_dp = 0;                 ///< [1/m]
    float inv_void = 10;              ///< 1 / (1 - touch_support), see WallCompleteness [-]
    float surface_support = 0;        ///< of LevelSetup [-]
    float given_back = 0;             ///< [m], a of WaterCompleteness
};

/// The second one: the forces and the density diffusion.
struct SecondPairLoopData {
    WaterView water{};
    WallView walls{};
    const PackedLeaving* leaving = nullptr;  ///< of the particles, see edge_release.h; null: none leaves an edge
    float since_walls = 0;                   ///< since the nearest walls were found [s]
    PackedShiftSupport* shift = nullptr;     ///< turned along the free surface
    PackedRate* rate = nullptr;              ///< gets the acceleration, and as drho what is not compression
    WallLoad* wall_load =
        nullptr;  ///< from Cluster::wall_load on one for each body that the cluster has in reach, in order
    float diffusion = 0;           ///< delta c0 [m/s], see DensityDiffusion
    float packing = 0;             ///< k c0/h rho0 [kg/m3/s], see Packing; 0: off
    float packing_reach = 0;       ///< from a solid [m]
    float viscosity = 0;           ///< alpha c0 rho0 / 2 [kg/m2/s], see ArtificialViscosity
    float gx = 0, gy = 0, gz = 0;  ///< body force [m/s2]
    float tension_control_from = 2;  ///< Shepard sum from which tension is controlled; above 1.5: nowhere
};

/// Pressure at points from the water round them: wall dummies, surface samples, probes; see wall_pressure.h.
struct ExtrapolateData {
    WaterView water{};
    Lists list{};                                    ///< of the points, in clusters as particles are
    const PackedPlace* at = nullptr;                 ///< the points
    const WallAcceleration* acceleration = nullptr;  ///< of the points; null: at rest
    float* p = nullptr;                              ///< [Pa]
    float* support = nullptr;                        ///< sum_j V_j W_ij; may be null [-]
    const CarriedShare* carried = nullptr;           ///< of the particles; may be null
    float* flux = nullptr;  ///< 6 per point, as those of CarriedShare: sum_j p_j m V_j W [Pa]; needs `carried`
    float gx = 0, gy = 0, gz = 0;  ///< body force [m/s2]
};

}  // namespace tw
