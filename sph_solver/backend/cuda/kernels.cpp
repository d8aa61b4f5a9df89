// Everything that runs on a device, for clang++ -x cuda --cuda-device-only: the sweeps and the loops as they stand in
// their files. Compiled twice: as fast as may be, and with TW_STRICT to the bits of the variant device_emulated.
#define __host__ __attribute__((host))
#define __device__ __attribute__((device))
extern "C++" __device__ inline double sqrt(double x) { return __builtin_sqrt(x); }  // beside the host's
#include <cstdlib>

#include <algorithm>  // Clang's own, of both
#include <cmath>
#include <cstdint>
#include <limits>
#include <memory>
#include <type_traits>

#pragma clang force_cuda_host_device begin
#define TW_THREADS
#define TW_ISA on_device
#include "sph_solver/backend/cuda/kernel_list.h"
#include "sph_solver/backend/cuda/tasks.h"
#include "sph_solver/effects/ventilation_isa.cpp"
#include "sph_solver/sweeps/engine_isa.cpp"
#pragma clang force_cuda_host_device end

namespace tw {
using on_device::pass;

#define sweep(name, View) \
    TW_SWEEP_KERNEL name(View d, const Group* groups, int count) { pass(d, groups, count); }
TW_DEVICE_SWEEPS(sweep)
#undef sweep

/// How many groups ask is known to the device alone.
TW_SWEEP_KERNEL tw_near_air(NearAirData d, const Group* groups, const int* count) { pass(d, groups, *count); }

#define task(name, Task)                           \
    TW_KERNEL name(Task task, std::size_t count) { \
        const std::size_t i = device::index();     \
        if (i < count) task(i);                    \
    }
TW_DEVICE_TASKS(task)
#undef task

TW_KERNEL tw_find_asking(cuda::FindAsking task, std::size_t count) {
    const std::size_t k = device::index();
    if (k < count) task(k, device::add_one);
}

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

}  // namespace tw
