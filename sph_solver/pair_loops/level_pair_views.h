#pragma once
#include "sph_solver/device/kernel_of.h"
#include "sph_solver/pair_loops/views.h"

namespace tw {

/// What the first pair loop wants of the other level, see equations/level_pair.h.
struct MeetOtherData {
    WaterView water{}, other{};
    Lists list{};        ///< neighbours of `water` in `other`
    float inv_W_dp = 0;  ///< 1 / W(dp) [m3]
    OtherSums* sums = nullptr;
};
/// What the other level adds to the rates.
struct PressOtherData {
    WaterView water{}, other{};
    Lists list{};
    const PackedShiftSupport* shift = nullptr;
    PackedRate* rate = nullptr;
    float viscosity = 0;             ///< of the pair, see SecondPairLoopData [kg/m2/s]
    float tension_control_from = 2;  ///< see SecondPairLoopData [-]
};

#define TW_PAIR_PAIR_LOOPS(pair_loop) pair_loop(tw_meet_other, MeetOtherData) pair_loop(tw_press_other, PressOtherData)
TW_PAIR_PAIR_LOOPS(TW_KERNEL_OF)

}  // namespace tw
