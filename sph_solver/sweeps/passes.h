#pragma once
#include <cstdint>
#include <type_traits>

#include "sph_solver/sweeps/groups.h"

namespace tw {

struct PlaceRecord;

/// One sweep of one variant: a loop over `count` groups and their neighbours. What it reads and writes names it.
template <class View>
struct Pass {
    void (*run)(const View&, const Group*, int count) = nullptr;
};
template <class... Views>
struct PassTable : Pass<Views>... {};

// The list of sweeps. A further one is its struct in a file NAME_isa.cpp (sweep.h says how), and its view's name here.
using EngineSweeps = PassTable<struct PruneData, struct FirstSweepData, struct SecondSweepData, struct ExtrapolateData,
                               struct MeetOtherData, struct PressOtherData, struct InterpolateData>;
using EffectSweeps = PassTable<struct WaterVelocityData, struct ViscousForceData, struct StrainRateData,
                               struct ColourGradientData, struct CurvatureData, struct NearAirData>;

/// The sweeps of one variant: instruction set, lanes, exact or rough roots (sph_solver/CMakeLists.txt lists them).
struct Passes {
    const char* isa = "";
    int lanes = 0;  ///< largest size of a group
    EngineSweeps engine;
    EffectSweeps effects;
    GroupReach (*reach_of)(const PlaceRecord* places, const Group&, const Reaches& quanta) = nullptr;
    /// Which of `count` <= 32 places sorted by z, those not above `top` (from the group's centre), are within the
    /// reaches of a particle of the group. Reads no place from `end` on.
    Reached (*reached)(const GroupReach&, const PlaceRecord* first, const PlaceRecord* end, int count,
                       std::int64_t top) = nullptr;

    /// Runs the sweep of a view on `count` groups.
    template <class View>
    void run(const View& view, const Group* groups, int count) const {
        if constexpr (std::is_base_of_v<Pass<View>, EngineSweeps>)
            engine.Pass<View>::run(view, groups, count);
        else
            effects.Pass<View>::run(view, groups, count);
    }
};
/// The default of this processor, or what TWINWAKE_ISA names; see choose_passes.h.
const Passes& passes();
/// By name. Throws InputError for one that this processor cannot run.
const Passes& passes(const char* isa);

}  // namespace tw
