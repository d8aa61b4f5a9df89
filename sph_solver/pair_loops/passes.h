#pragma once
#include <cstdint>
#include <type_traits>

#include "sph_solver/pair_loops/clusters.h"

namespace tw {

struct PackedPlace;

/// One pair loop of one variant: a loop over `count` clusters and their neighbours. What it reads and writes names it.
template <class View>
struct Pass {
    void (*run)(const View&, const Cluster*, int count) = nullptr;
};
template <class... Views>
struct PassTable : Pass<Views>... {};

// The list of pair loops. A further one is its struct in a file NAME_isa.cpp (pair_loop.h says how), and its view's
// name here.
using EnginePairLoops =
    PassTable<struct PruneData, struct FirstPairLoopData, struct SecondPairLoopData, struct ExtrapolateData,
              struct MeetOtherData, struct PressOtherData, struct InterpolateData>;
using EffectPairLoops = PassTable<struct WaterVelocityData, struct ViscousForceData, struct StrainRateData,
                                  struct ColourGradientData, struct CurvatureData, struct NearAirData>;

/// The pair loops of one variant: instruction set, lanes, exact or rough roots (sph_solver/CMakeLists.txt lists them).
struct Passes {
    const char* isa = "";
    int lanes = 0;  ///< largest size of a cluster
    EnginePairLoops engine;
    EffectPairLoops effects;
    ClusterReach (*reach_of)(const PackedPlace* places, const Cluster&, const Reaches& fixed_point) = nullptr;
    /// Which of `count` <= 32 places sorted by z, those not above `top` (from the cluster's centre), are within the
    /// reaches of a particle of the cluster. Reads no place from `end` on.
    Reached (*reached)(const ClusterReach&, const PackedPlace* first, const PackedPlace* end, int count,
                       std::int64_t top) = nullptr;

    /// Runs the pair loop of a view on `count` clusters.
    template <class View>
    void run(const View& view, const Cluster* clusters, int count) const {
        if constexpr (std::is_base_of_v<Pass<View>, EnginePairLoops>)
            engine.Pass<View>::run(view, clusters, count);
        else
            effects.Pass<View>::run(view, clusters, count);
    }
};
/// The default of this processor, or what TWINWAKE_ISA names; see choose_passes.h.
const Passes& passes();
/// By name. Throws InputError for one that this processor cannot run.
const Passes& passes(const char* isa);

}  // namespace tw
