#pragma once
#include "sph_solver/cuda/driver.h"

namespace tw::cuda {

/// What a device was measured to do at most.
struct Peaks {
    double flops;        ///< single precision, a fused product and sum counted as two [1/s]
    double cache_bytes;  ///< read of what its second cache holds [B/s]
};
Peaks measure_peaks(Device& device);

}  // namespace tw::cuda
