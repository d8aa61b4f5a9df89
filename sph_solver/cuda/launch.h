#pragma once
// How the host starts kernels: by the type of what they do. Its name, and what the kernel is given beside it, stand in
// the lists of kernels, once (KernelOf: device/kernel_of.h).
#include <cstddef>

#include "sph_solver/cuda/driver.h"
#include "sph_solver/cuda/edges.h"
#include "sph_solver/cuda/faces.h"
#include "sph_solver/cuda/kernel_list.h"
#include "sph_solver/cuda/messages.h"
#include "sph_solver/cuda/near_walls.h"
#include "sph_solver/cuda/search.h"
#include "sph_solver/cuda/sorting.h"
#include "sph_solver/cuda/tasks.h"
#include "sph_solver/device/kernel_of.h"
#include "sph_solver/device/launch.h"
#include "sph_solver/loops/count_kinds.h"
#include "sph_solver/pair_loops/interpolate.h"
#include "sph_solver/pair_loops/views.h"

namespace tw {

TW_DEVICE_PAIR_LOOPS(TW_KERNEL_OF)
TW_DEVICE_TASKS(TW_KERNEL_OF)
TW_DEVICE_COUNTING_TASKS(TW_KERNEL_OF)
TW_DEVICE_CHOICES(TW_KERNEL_OF)
TW_DEVICE_LARGEST(TW_KERNEL_OF)
TW_DEVICE_OTHERS(TW_KERNEL_OF)

namespace cuda {

/// Starts the kernel of `task` on so many threads, with what it is given beside the task.
template <class Task, class... More>
void launch_threads(Device& device, std::size_t threads, Task task, More... more) {
    void* arguments[] = {&task, &more...};
    device.launch(KernelOf<Task>::name, threads, arguments);
}
/// For each index below `count`, of one thread.
template <class Task>
void launch(Device& device, const Task& task, std::size_t count) {
    launch_threads(device, count, task, count);
}
/// A pair loop, of a warp for each cluster.
template <class View>
void launch_pairs(Device& device, const View& view, const Array<Cluster>& clusters) {
    launch_threads(device, clusters.size() * warp, view, static_cast<const Cluster*>(clusters.data()),
                   static_cast<int>(clusters.size()));
}

}  // namespace cuda
}  // namespace tw
