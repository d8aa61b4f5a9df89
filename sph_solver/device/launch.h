#pragma once
namespace tw::cuda {
/// How kernels are started: so many threads make a block, 32 of them a warp, one for each cluster of particles.
inline constexpr int warp = 32, warps_in_block = 4, threads_in_block = warp * warps_in_block;
/// So many numbers of a running sum are one block's work.
inline constexpr int scanned_by_block = 8 * threads_in_block;
}  // namespace tw::cuda
