// The functions of the CUDA driver that twinwake calls, for a machine without one. "Device" memory comes from the
// host's heap, filled with a pattern that is no number when it is allocated or an array there gets another length,
// between two fences; every copy, clearing and launch is checked against what is allocated. Kernels are those of the
// variant device_emulated and the loops of cuda/tasks.h, one index after another.
//
// FAKE_CUDA (environment): words of "no_device", "old_device", "two_devices" (the first is too old),
// "devices=N" (of which all can be used), "memory=N" (bytes of the
// device), "others=N" (bytes of it that other programs have), "lost_after=N" (launches until every call fails).
#include <cstdint>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <map>
#include <string>
#include <utility>

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
#include "sph_solver/pair_loops/interpolate.h"
#include "sph_solver/pair_loops/level_pair_views.h"
#include "sph_solver/pair_loops/views.h"

namespace tw::in_fake_cuda {
template <class View>
void pass(const View&, const Cluster*, int count);
ClusterReach reach_of(const PackedPlace* places, const Cluster& g, const Reaches& reaches);
Reached reached(const ClusterReach& g, const PackedPlace* first, const PackedPlace* end, int count, std::int64_t top);
}  // namespace tw::in_fake_cuda

namespace {

using namespace tw;
using Result = int;
enum { success = 0, invalid = 1, out_of_memory = 2, not_found = 500, lost = 719 };

std::string option(const std::string& name) {
    const char* all = std::getenv("FAKE_CUDA");
    const std::string text = std::string(" ") + (all ? all : "") + " ";
    const std::size_t at = text.find(" " + name);
    if (at == std::string::npos) return {};
    const std::size_t value = at + 1 + name.size();
    if (text[value] != '=') return "yes";
    return text.substr(value + 1, text.find(' ', value) - value - 1);
}

constexpr unsigned char poison = 0xff;  // as a float not a number, as an index -1
constexpr std::size_t fence = 64;
std::map<std::uint64_t, std::size_t>& blocks() {
    static std::map<std::uint64_t, std::size_t> all;
    return all;
}
long launches = 0;

[[noreturn]] void die(const char* what) {
    std::fprintf(stderr, "fake libcuda: %s\n", what);
    std::abort();
}
bool is_old(int device) { return !option("old_device").empty() || (device == 0 && !option("two_devices").empty()); }
bool is_lost() {
    const std::string after = option("lost_after");
    return !after.empty() && launches > std::atol(after.c_str());
}
/// Ends the program where [at, at + bytes) is not part of one block.
void check_inside(std::uint64_t at, std::size_t bytes) {
    auto block = blocks().upper_bound(at);
    if (block == blocks().begin()) die("memory that is not allocated");
    --block;
    if (at + bytes > block->first + block->second) die("more bytes than are allocated there");
}
std::size_t memory() {
    const std::string bytes = option("memory");
    return bytes.empty() ? std::size_t{4} << 30 : std::strtoull(bytes.c_str(), nullptr, 10);
}
std::size_t others() { return std::strtoull(("0" + option("others")).c_str(), nullptr, 10); }
std::size_t taken() {
    std::size_t sum = 0;
    for (const auto& [at, bytes] : blocks()) sum += bytes;
    return sum;
}

template <class T>
const T& argument(void** arguments, int k) {
    return *static_cast<const T*>(arguments[k]);
}
int add_one(int* counter) { return (*counter)++; }

template <class View>
void run_pair_loop(void** a) {
    in_fake_cuda::pass(argument<View>(a, 0), argument<const Cluster*>(a, 1), argument<int>(a, 2));
}
template <class View>
void run_pair_loop_of_chosen(void** a) {
    in_fake_cuda::pass(argument<View>(a, 0), argument<const Cluster*>(a, 1), *argument<const int*>(a, 2));
}
template <class Task>
void run_task(void** a) {
    const auto& task = argument<Task>(a, 0);
    for (std::size_t i = 0; i < argument<std::size_t>(a, 1); ++i) task(i);
}
template <class Condition>
void run_choice(void** a) {
    const auto& condition = argument<Condition>(a, 0);
    const auto* clusters = argument<const Cluster*>(a, 1);
    // from the end: what comes of it must not depend on the order
    for (std::size_t k = argument<std::size_t>(a, 4); k-- > 0;)
        if (condition(clusters[k])) argument<Cluster*>(a, 2)[add_one(argument<int*>(a, 3))] = clusters[k];
}
template <class Task>
void run_counting(void** a) {
    const auto& task = argument<Task>(a, 0);
    for (std::size_t i = argument<std::size_t>(a, 1); i-- > 0;) task(i, add_one);  // from the end, as above
}
void search(void** a) {
    const auto& task = argument<cuda::SearchNeighbours>(a, 0);
    for (int n = 0; n < argument<int>(a, 2); ++n) {
        const ClusterReach own = in_fake_cuda::reach_of(task.places, task.clusters[n], task.reaches);
        const auto ask = [&](const PackedPlace* first, const PackedPlace* end, int places, std::int64_t top) {
            return in_fake_cuda::reached(own, first, end, places, top);
        };
        task(static_cast<std::size_t>(n), ask, [](const auto& act) { act(); });
    }
}
void scan_blocks(void** a) {
    const auto& scan = argument<cuda::ScanBlocks>(a, 0);
    for (int first = 0; first < scan.n; first += cuda::scanned_by_block) {
        int sum = 0;
        for (int k = first; k < std::min(scan.n, first + cuda::scanned_by_block); ++k) sum += scan.of[k];
        scan.sums[first / cuda::scanned_by_block] = sum;
    }
}
void scan_sums(void** a) {
    const auto& scan = argument<cuda::ScanSums>(a, 0);
    int before = 0;
    for (int k = 0; k < scan.n; ++k) before += std::exchange(scan.sums[k], before);
    scan.sums[scan.n] = before;
}
void scan_fill(void** a) {
    const auto& scan = argument<cuda::ScanFill>(a, 0);
    int before = 0;
    for (int k = 0; k < scan.n; ++k) {
        if (k % cuda::scanned_by_block == 0) before = scan.sums[k / cuda::scanned_by_block];
        scan.before[k] = before;
        before += scan.of[k];
    }
    scan.before[scan.n] = before;
}
void move(void** a) {
    const auto& task = argument<cuda::MoveAll>(a, 0);
    auto* parts = argument<MovedExtremes*>(a, 1);
    const auto n = argument<std::size_t>(a, 2);
    for (std::size_t first = 0; first < n; first += cuda::threads_in_block) {
        MovedExtremes part;
        for (std::size_t i = first; i < std::min(n, first + cuda::threads_in_block); ++i) {
            MovedExtremes own;
            task(i, own, add_one);
            cuda::join(part, own);
        }
        parts[first / cuda::threads_in_block] = part;
    }
}

template <class Task>
void run_largest(void** a) {
    const auto& task = argument<Task>(a, 0);
    const auto n = argument<std::size_t>(a, 2);
    for (std::size_t first = 0; first < n; first += cuda::threads_in_block) {
        double& part = argument<double*>(a, 1)[first / cuda::threads_in_block] = 0;
        for (std::size_t k = first; k < std::min(n, first + cuda::threads_in_block); ++k)
            part = std::max(part, task(k));
    }
}

using EmulatedKernel = void (*)(void** arguments);
const std::map<std::string, EmulatedKernel>& kernels() {
    static const std::map<std::string, EmulatedKernel> all{
#define pair_loop(name, View) {#name, run_pair_loop<View>},
#define task(name, Task) {#name, run_task<Task>},
#define counting(name, Task) {#name, run_counting<Task>},
#define largest(name, Task) {#name, run_largest<Task>},
#define choose(name, Condition) {#name, run_choice<Condition>},
#define pair_loop_of_chosen(name, View) {#name, run_pair_loop_of_chosen<View>},
        TW_DEVICE_PAIR_LOOPS(pair_loop) TW_EFFECT_PAIR_LOOPS(pair_loop) TW_PAIR_PAIR_LOOPS(pair_loop)
            TW_DEVICE_TASKS(task) TW_DEVICE_COUNTING_TASKS(counting) TW_EFFECT_TASKS(task) TW_IMAGE_TASKS(task)
                TW_STAGE_TASKS(task) TW_INLET_TASKS(task) TW_BODY_TASKS(task) TW_DEVICE_LARGEST(largest)
                    TW_EFFECT_LARGEST(largest) TW_DEVICE_CHOICES(choose) TW_EFFECT_CHOICES(choose)
                        TW_EFFECT_PAIR_LOOPS_OF_CHOSEN(pair_loop_of_chosen)
#undef pair_loop
#undef task
#undef counting
#undef largest
#undef choose
#undef pair_loop_of_chosen
                            {"tw_move", move},
        {"tw_search", search},
        {"tw_scan_blocks", scan_blocks},
        {"tw_scan_sums", scan_sums},
        {"tw_scan_fill", scan_fill},
    };
    return all;
}

}  // namespace

#define DRIVER extern "C" __attribute__((visibility("default"))) Result

DRIVER cuInit(unsigned) { return success; }
DRIVER cuDriverGetVersion(int* version) { return *version = 13000, success; }
DRIVER cuDeviceGetCount(int* count) {
    const std::string several = option("devices");
    if (!several.empty()) return *count = std::atoi(several.c_str()), success;
    return *count = !option("no_device").empty() ? 0 : !option("two_devices").empty() ? 2 : 1, success;
}
DRIVER cuDeviceGet(int* device, int k) { return *device = k, success; }
DRIVER cuDeviceGetName(char* name, int size, int device) {
    const char* const text = is_old(device) ? "Old device" : "Emulated device";
    return std::snprintf(name, static_cast<std::size_t>(size), "%s", text), success;
}
DRIVER cuDeviceGetAttribute(int* value, int which, int device) {
    const bool old = is_old(device);
    *value = which == 75 ? (old ? 6 : 9) : which == 76 ? 0 : which == 16 ? 4 : -1;
    return *value < 0 ? invalid : success;
}
DRIVER cuDeviceTotalMem_v2(std::size_t* bytes, int) { return *bytes = memory(), success; }
DRIVER cuDevicePrimaryCtxRetain(void** context, int) { return *context = &launches, success; }
DRIVER cuDevicePrimaryCtxRelease_v2(int) { return success; }
DRIVER cuCtxSetCurrent(void*) { return success; }
DRIVER cuCtxSynchronize() { return is_lost() ? lost : success; }
DRIVER cuModuleLoadDataEx(void** module, const void* image, unsigned, int*, void**) {
    if (std::strstr(static_cast<const char*>(image), ".visible .entry tw_first_pair_loop") == nullptr) return invalid;
    launches = 0;
    return *module = &launches, success;
}
DRIVER cuModuleUnload(void*) { return success; }
DRIVER cuModuleGetFunction(void** function, void*, const char* name) {
    const auto found = kernels().find(name);
    if (found == kernels().end()) return not_found;
    return *function = reinterpret_cast<void*>(found->second), success;
}
DRIVER cuMemAlloc_v2(std::uint64_t* at, std::size_t bytes) {
    if (bytes == 0) return invalid;
    if (taken() + bytes > memory()) return out_of_memory;
    auto* raw = static_cast<unsigned char*>(std::malloc(bytes + 2 * fence));
    if (!raw) return out_of_memory;
    std::memset(raw, poison, bytes + 2 * fence);
    *at = reinterpret_cast<std::uint64_t>(raw + fence);
    blocks()[*at] = bytes;
    return success;
}
DRIVER cuMemFree_v2(std::uint64_t at) {
    const auto block = blocks().find(at);
    if (block == blocks().end()) die("memory freed that is not allocated");
    auto* raw = reinterpret_cast<unsigned char*>(at) - fence;
    for (std::size_t k = 0; k < fence; ++k)
        if (raw[k] != poison || raw[fence + block->second + k] != poison) die("a kernel wrote beyond an array");
    std::memset(raw, poison, block->second + 2 * fence);
    std::free(raw);
    blocks().erase(block);
    return success;
}
DRIVER cuMemGetInfo_v2(std::size_t* free, std::size_t* all) {
    return *all = memory(), *free = memory() - taken() - others(), success;
}
extern "C" __attribute__((visibility("default"))) void twinwake_forget(std::uint64_t at, std::size_t bytes) {
    check_inside(at, bytes);
    std::memset(reinterpret_cast<void*>(at), poison, bytes);
}
DRIVER cuMemcpyHtoD_v2(std::uint64_t to, const void* from, std::size_t bytes) {
    if (is_lost()) return lost;
    check_inside(to, bytes);
    return std::memcpy(reinterpret_cast<void*>(to), from, bytes), success;
}
DRIVER cuMemcpyDtoH_v2(void* to, std::uint64_t from, std::size_t bytes) {
    if (is_lost()) return lost;
    check_inside(from, bytes);
    return std::memcpy(to, reinterpret_cast<const void*>(from), bytes), success;
}
DRIVER cuMemcpyDtoD_v2(std::uint64_t to, std::uint64_t from, std::size_t bytes) {
    if (is_lost()) return lost;
    check_inside(to, bytes), check_inside(from, bytes);
    return std::memcpy(reinterpret_cast<void*>(to), reinterpret_cast<const void*>(from), bytes), success;
}
DRIVER cuMemsetD8_v2(std::uint64_t at, unsigned char value, std::size_t bytes) {
    if (is_lost()) return lost;
    check_inside(at, bytes);
    return std::memset(reinterpret_cast<void*>(at), value, bytes), success;
}
DRIVER cuLaunchKernel(void* function, unsigned blocks_x, unsigned, unsigned, unsigned threads, unsigned, unsigned,
                      unsigned, void*, void** arguments, void**) {
    if (blocks_x == 0 || threads != static_cast<unsigned>(cuda::threads_in_block)) return invalid;
    ++launches;
    if (is_lost()) return lost;
    reinterpret_cast<EmulatedKernel>(function)(arguments);
    return success;
}
DRIVER cuGetErrorString(Result r, const char** text) {
    *text = r == out_of_memory ? "out of memory"
            : r == not_found   ? "named symbol not found"
            : r == lost        ? "unspecified launch failure"
                               : "invalid argument";
    return success;
}
