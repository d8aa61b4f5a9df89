// Everything that runs on a device, for clang++ -x cuda --cuda-device-only: the pair loops and the loops as they stand
// in their files. Compiled twice: as fast as may be, and with TW_STRICT to the bits of the variant device_emulated.
#define __host__ __attribute__((host))
#define __device__ __attribute__((device))
extern "C++" __device__ inline double sqrt(double x) { return __builtin_sqrt(x); }  // beside the host's
#include <cstdlib>

#include <algorithm>  // Clang's own, of both
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <optional>
#include <type_traits>

#pragma clang force_cuda_host_device begin
#define TW_THREADS
#define TW_ISA on_device
#include "sph_solver/cuda/edges.h"
#include "sph_solver/cuda/faces.h"
#include "sph_solver/cuda/kernel_list.h"
#include "sph_solver/cuda/messages.h"
#include "sph_solver/cuda/near_walls.h"
#include "sph_solver/cuda/search.h"
#include "sph_solver/cuda/sorting.h"
#include "sph_solver/cuda/tasks.h"
#include "sph_solver/effects/kernels.h"
#include "sph_solver/loops/count_kinds.h"
#include "sph_solver/loops/force_on_dummies.h"
#include "sph_solver/loops/inlet_wave.h"
#include "sph_solver/pair_loops/interpolate_isa.cpp"
#include "sph_solver/pair_loops/level_pair_isa.cpp"
#include "sph_solver/pair_loops/right_hand_side_isa.cpp"
#pragma clang force_cuda_host_device end

namespace tw {
using on_device::pass;

#define pair_loop(name, View) \
    TW_PAIR_LOOP_KERNEL name(View d, const Cluster* clusters, int count) { pass(d, clusters, count); }
TW_DEVICE_PAIR_LOOPS(pair_loop)
TW_EFFECT_PAIR_LOOPS(pair_loop)
TW_PAIR_PAIR_LOOPS(pair_loop)
#undef pair_loop

/// How many clusters were chosen is known to the device alone.
#define pair_loop(name, View) \
    TW_PAIR_LOOP_KERNEL name(View d, const Cluster* clusters, const int* count) { pass(d, clusters, *count); }
TW_EFFECT_PAIR_LOOPS_OF_CHOSEN(pair_loop)
#undef pair_loop

#define task(name, Task)                           \
    TW_KERNEL name(Task task, std::size_t count) { \
        const std::size_t i = device::index();     \
        if (i < count) task(i);                    \
    }
TW_DEVICE_TASKS(task)
TW_EFFECT_TASKS(task)
TW_IMAGE_TASKS(task)
TW_STAGE_TASKS(task)
TW_INLET_TASKS(task)
TW_BODY_TASKS(task)
#undef task

#define choose(name, Condition)                                                                                \
    TW_KERNEL name(Condition condition, const Cluster* clusters, Cluster* chosen, int* count, std::size_t n) { \
        const std::size_t k = device::index();                                                                 \
        if (k < n && condition(clusters[k])) chosen[device::add_one(count)] = clusters[k];                     \
    }
TW_DEVICE_CHOICES(choose)
TW_EFFECT_CHOICES(choose)
#undef choose

#define task(name, Task)                           \
    TW_KERNEL name(Task task, std::size_t count) { \
        const std::size_t i = device::index();     \
        if (i < count) task(i, device::add_one);   \
    }
TW_DEVICE_COUNTING_TASKS(task)
#undef task

/// Each block leaves one part.
TW_KERNEL tw_move(cuda::MoveAll task, MovedExtremes* parts, std::size_t count) {
    MovedExtremes* const room = device::room_of_block<MovedExtremes, cuda::threads_in_block>();
    const int thread = device::thread_in_block();
    MovedExtremes own;
    const std::size_t i = device::index();
    if (i < count) task(i, own, device::add_one);
    room[thread] = own;
    for (int half = cuda::threads_in_block / 2; half > 0; half /= 2) {
        device::sync_block();
        if (thread < half) cuda::join(room[thread], room[thread + half]);
    }
    if (thread == 0) parts[device::block()] = room[0];
}

/// Each block leaves the largest of its own.
template <class Task>
__device__ inline void leave_largest(const Task& task, double* parts, std::size_t count) {
    double* const room = device::room_of_block<double, cuda::threads_in_block>();
    const int thread = device::thread_in_block();
    const std::size_t k = device::index();
    room[thread] = k < count ? task(k) : 0;
    for (int half = cuda::threads_in_block / 2; half > 0; half /= 2) {
        device::sync_block();
        if (thread < half && room[thread + half] > room[thread]) room[thread] = room[thread + half];
    }
    if (thread == 0) parts[device::block()] = room[0];
}
#define largest(name, Task) \
    TW_KERNEL name(Task task, double* parts, std::size_t count) { leave_largest(task, parts, count); }
TW_DEVICE_LARGEST(largest)
TW_EFFECT_LARGEST(largest)
#undef largest

/// A warp for each cluster, which asks for 32 places at once.
TW_KERNEL tw_search(cuda::SearchNeighbours task, const Cluster* clusters, int count) {
    using namespace on_device;
    const int thread = device::thread();
    for (int n = first_cluster(); n < count; n = next_cluster(n)) {
        const ClusterReach& own = reach_of_warp(task.places, clusters[n], task.reaches);
        const auto ask = [&](const PackedPlace* first, const PackedPlace*, int places, std::int64_t top) {
            const bool there = thread < places;
            const PackedPlace p = first[there ? thread : 0];
            // places are asked eight at a time, up to the first eight that begin above
            const std::uint32_t below = device::threads_where(there && difference(p.z, own.z) <= top);
            const bool asked = there && (below >> (thread & ~(lanes - 1)) & 1) != 0;
            const float d2 = distance2(own, p);
            return Reached{device::threads_where(asked && d2 < own.far2), device::threads_where(asked && d2 < own.now2),
                           device::threads_where(asked && d2 < own.sure2)};
        };
        task(static_cast<std::size_t>(n), ask, [&](const auto& act) {
            if (thread == 0) act();
        });
    }
}

// What the card can do at most, for benchmarks: 16 fused products and sums a round, in eight chains; and reading an
// array over and over that the second cache holds.
TW_KERNEL tw_peak_arithmetic(cuda::PeakArithmetic peak) {
    const auto [result, rounds] = peak;
    float x[8];
    for (int k = 0; k < 8; ++k) x[k] = static_cast<float>(device::thread_in_block() + k);
    for (int r = 0; r < rounds; ++r)
        for (int twice = 0; twice < 2; ++twice)
#pragma unroll
            for (int k = 0; k < 8; ++k) x[k] = __builtin_fmaf(x[k], 0.999f, 0.5f);
    float sum = 0;
    for (int k = 0; k < 8; ++k) sum += x[k];
    if (sum == -1) *result = sum;
}
TW_KERNEL tw_peak_cache(cuda::PeakCache peak) {
    const auto [result, array, length, rounds] = peak;
    int sum = 0;
    const int all = static_cast<int>(__nvvm_read_ptx_sreg_nctaid_x()) * cuda::threads_in_block;
    for (int r = 0; r < rounds; ++r)
        for (int k = static_cast<int>(device::index()); k < length; k += all) {
            const PackedPlace p = array[k];
            sum += p.x + p.y + p.z + static_cast<int>(p.volume);
        }
    if (sum == -12345) *result = 1;
}

// Sums of all before, in three steps: of blocks, of these, and within them.
namespace {
constexpr int of_thread = cuda::scanned_by_block / cuda::threads_in_block;
}
TW_KERNEL tw_scan_blocks(cuda::ScanBlocks scan) {
    const auto [of, sums, n] = scan;
    int* const room = device::room_of_block<int, cuda::threads_in_block>();
    const int thread = device::thread_in_block(), first = device::block() * cuda::scanned_by_block + thread * of_thread;
    int sum = 0;
    for (int k = first; k < first + of_thread && k < n; ++k) sum += of[k];
    room[thread] = sum;
    for (int half = cuda::threads_in_block / 2; half > 0; half /= 2) {
        device::sync_block();
        if (thread < half) room[thread] += room[thread + half];
    }
    if (thread == 0) sums[device::block()] = room[0];
}
/// By one block: each sum becomes that of all before it, and the one past the last that of all.
TW_KERNEL tw_scan_sums(cuda::ScanSums scan) {
    const auto [sums, n] = scan;
    int* const room = device::room_of_block<int, cuda::threads_in_block>();
    const int thread = device::thread_in_block(), each = (n + cuda::threads_in_block - 1) / cuda::threads_in_block;
    int own = 0;
    for (int k = thread * each; k < (thread + 1) * each && k < n; ++k) own += sums[k];
    room[thread] = own;
    device::sync_block();
    int before = 0;
    for (int t = 0; t < thread; ++t) before += room[t];
    for (int k = thread * each; k < (thread + 1) * each && k < n; ++k) {
        const int value = sums[k];
        sums[k] = before;
        before += value;
    }
    if (thread == cuda::threads_in_block - 1) sums[n] = before;
}
TW_KERNEL tw_scan_fill(cuda::ScanFill scan) {
    const auto [of, sums, before_each, n] = scan;
    int* const room = device::room_of_block<int, cuda::threads_in_block>();
    const int thread = device::thread_in_block(), first = device::block() * cuda::scanned_by_block + thread * of_thread;
    int own = 0;
    for (int k = first; k < first + of_thread && k < n; ++k) own += of[k];
    room[thread] = own;
    device::sync_block();
    int before = sums[device::block()];
    for (int t = 0; t < thread; ++t) before += room[t];
    for (int k = first; k < first + of_thread && k < n; ++k) {
        const int value = of[k];
        before_each[k] = before;
        before += value;
        if (k == n - 1) before_each[n] = before;
    }
}

}  // namespace tw
