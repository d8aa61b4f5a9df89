#pragma once
// What a kernel needs of the device, in the words of Clang: the toolkit's headers are not asked for. A file that
// includes this is compiled for the device alone (kernels.cpp).
#include <cstdint>

#include "sph_solver/device/launch.h"

#if !defined(__CUDA_ARCH__)
#error "for kernels only"
#endif

#define TW_KERNEL extern "C" __attribute__((global)) void
/// At most 64 registers a thread, so that half of the threads that a multiprocessor can hold are there.
#define TW_PAIR_LOOP_KERNEL extern "C" __attribute__((global, launch_bounds(tw::cuda::threads_in_block, 8))) void
#define TW_SHARED __attribute__((shared))

namespace tw::device {

using namespace cuda;  // launch.h

inline int thread() { return __nvvm_read_ptx_sreg_tid_x() % warp; }
inline int warp_in_block() { return __nvvm_read_ptx_sreg_tid_x() / warp; }
inline int warp_index() { return __nvvm_read_ptx_sreg_ctaid_x() * warps_in_block + warp_in_block(); }
inline int warp_count() { return __nvvm_read_ptx_sreg_nctaid_x() * warps_in_block; }
inline std::int64_t index() {
    return std::int64_t{__nvvm_read_ptx_sreg_ctaid_x()} * threads_in_block + __nvvm_read_ptx_sreg_tid_x();
}

inline int thread_in_block() { return __nvvm_read_ptx_sreg_tid_x(); }
inline int block() { return __nvvm_read_ptx_sreg_ctaid_x(); }

inline void sync_block() { __syncthreads(); }
inline int add_one(int* counter) { return __nvvm_atom_add_gen_i(counter, 1); }
inline void sync_warp() { __nvvm_bar_warp_sync(~0u); }
inline float from_thread_xor(float x, int mask) { return __nvvm_shfl_sync_bfly_f32(~0u, x, mask, 31); }
inline std::uint32_t threads_where(bool condition) { return __nvvm_vote_ballot_sync(~0u, condition); }

/// Memory that the threads of a warp share.
template <class T, int size>
inline T* room_of_warp() {
    static TW_SHARED T room[warps_in_block][size];
    return room[warp_in_block()];
}

/// Memory that the threads of a block share, for elements that begin as nothing.
template <class T, int size>
inline T* room_of_block() {
    static TW_SHARED __attribute__((aligned(16))) unsigned char room[size * sizeof(T)];
    return reinterpret_cast<T*>(room);
}

inline float exact_root(float x) { return __builtin_sqrtf(x); }
#ifdef TW_STRICT
/// Rounded as a processor rounds them.
inline float root(float x) { return __builtin_sqrtf(x); }
inline float quotient(float a, float b) { return a / b; }
#else
/// To the last bit or two.
inline float root(float x) { return __nvvm_sqrt_approx_f(x); }
inline float quotient(float a, float b) { return __nvvm_div_approx_f(a, b); }
#endif

}  // namespace tw::device
