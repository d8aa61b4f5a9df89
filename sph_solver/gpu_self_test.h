#pragma once

namespace tw {

/// Water at rest in a box with a block on its floor, by the GPU of this machine for some steps: the largest error of
/// its pressure, which is rho g times the depth, over that at the floor [-]. Within `sound_gpu_error` where the device
/// and the kernels do what they should. Throws InputError where there is none, RunError where it fails.
double gpu_self_test();
inline constexpr double sound_gpu_error = 0.02;

}  // namespace tw
