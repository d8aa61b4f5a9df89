#include "sph_solver/cuda/driver.h"

#include <dlfcn.h>

#include <array>
#include <cstdlib>
#include <map>
#include <vector>

#include <fmt/format.h>

#include "base/errors.h"
#include "sph_solver/device/launch.h"

// The kernels as PTX, each ends with a zero (sph_solver/kernels.cmake).
extern "C" const char tw_kernels_ptx[], tw_strict_kernels_ptx[];

namespace tw::cuda {

namespace {

// What is used of the driver's interface (CUDA Driver API, docs.nvidia.com/cuda/cuda-driver-api), by its own names.
using Result = int;
using Pointer = std::uint64_t;
constexpr int attribute_multiprocessors = 16, attribute_major = 75, attribute_minor = 76;
constexpr int oldest_major = 8;  // what the kernels are compiled for, sm_80

}  // namespace

struct Device::Library {
    void* handle = nullptr;
    void* context = nullptr;
    void* module = nullptr;
    int device = 0;
    std::string name, driver, file;
    std::size_t memory = 0;
    int multiprocessors = 0;
    int number = 0, count = 0;  ///< of the device, and of all
    int usable = 0;
    std::map<std::string, void*> kernels;

    Result (*cuInit)(unsigned) = nullptr;
    Result (*cuDriverGetVersion)(int*) = nullptr;
    Result (*cuDeviceGetCount)(int*) = nullptr;
    Result (*cuDeviceGet)(int*, int) = nullptr;
    Result (*cuDeviceGetName)(char*, int, int) = nullptr;
    Result (*cuDeviceGetAttribute)(int*, int, int) = nullptr;
    Result (*cuDeviceTotalMem)(std::size_t*, int) = nullptr;
    Result (*cuDevicePrimaryCtxRetain)(void**, int) = nullptr;
    Result (*cuDevicePrimaryCtxRelease)(int) = nullptr;
    Result (*cuCtxSetCurrent)(void*) = nullptr;
    Result (*cuCtxSynchronize)() = nullptr;
    Result (*cuModuleLoadDataEx)(void**, const void*, unsigned, int*, void**) = nullptr;
    Result (*cuModuleUnload)(void*) = nullptr;
    Result (*cuModuleGetFunction)(void**, void*, const char*) = nullptr;
    Result (*cuMemAlloc)(Pointer*, std::size_t) = nullptr;
    Result (*cuMemFree)(Pointer) = nullptr;
    Result (*cuMemGetInfo)(std::size_t*, std::size_t*) = nullptr;
    Result (*cuMemcpyHtoD)(Pointer, const void*, std::size_t) = nullptr;
    Result (*cuMemcpyDtoH)(void*, Pointer, std::size_t) = nullptr;
    Result (*cuMemcpyDtoD)(Pointer, Pointer, std::size_t) = nullptr;
    Result (*cuMemsetD8)(Pointer, unsigned char, std::size_t) = nullptr;
    Result (*cuLaunchKernel)(void*, unsigned, unsigned, unsigned, unsigned, unsigned, unsigned, unsigned, void*, void**,
                             void**) = nullptr;
    Result (*cuGetErrorString)(Result, const char**) = nullptr;
    void (*forget)(Pointer, std::size_t) = nullptr;  ///< of tests/fake_cuda alone

    ~Library() {
        if (module) cuModuleUnload(module);
        if (context) cuDevicePrimaryCtxRelease(device);
        // the library stays: the driver does not like to be taken out
    }

    /// Empty, or what is missing.
    std::string load(int process = 0) {
        const char* asked = std::getenv("TWINWAKE_LIBCUDA");
        file = asked && *asked ? asked : "libcuda.so.1";
        handle = dlopen(file.c_str(), RTLD_NOW | RTLD_LOCAL);
        if (!handle) return fmt::format("no driver was found ({})", dlerror());
        std::string missing;
        const auto find = [&](auto& function, const char* symbol) {
            function = reinterpret_cast<std::remove_reference_t<decltype(function)>>(dlsym(handle, symbol));
            if (!function && missing.empty()) missing = symbol;
        };
        find(cuInit, "cuInit"), find(cuDriverGetVersion, "cuDriverGetVersion");
        find(cuDeviceGetCount, "cuDeviceGetCount"), find(cuDeviceGet, "cuDeviceGet");
        find(cuDeviceGetName, "cuDeviceGetName"), find(cuDeviceGetAttribute, "cuDeviceGetAttribute");
        find(cuDeviceTotalMem, "cuDeviceTotalMem_v2");
        find(cuDevicePrimaryCtxRetain, "cuDevicePrimaryCtxRetain");
        find(cuDevicePrimaryCtxRelease, "cuDevicePrimaryCtxRelease_v2");
        find(cuCtxSetCurrent, "cuCtxSetCurrent"), find(cuCtxSynchronize, "cuCtxSynchronize");
        find(cuModuleLoadDataEx, "cuModuleLoadDataEx"), find(cuModuleUnload, "cuModuleUnload");
        find(cuModuleGetFunction, "cuModuleGetFunction");
        find(cuMemAlloc, "cuMemAlloc_v2"), find(cuMemFree, "cuMemFree_v2"), find(cuMemGetInfo, "cuMemGetInfo_v2");
        find(cuMemcpyHtoD, "cuMemcpyHtoD_v2"), find(cuMemcpyDtoH, "cuMemcpyDtoH_v2");
        find(cuMemcpyDtoD, "cuMemcpyDtoD_v2");
        find(cuMemsetD8, "cuMemsetD8_v2"), find(cuLaunchKernel, "cuLaunchKernel");
        find(cuGetErrorString, "cuGetErrorString");
        forget = reinterpret_cast<decltype(forget)>(dlsym(handle, "twinwake_forget"));
        if (!missing.empty()) return fmt::format("{} is too old, it has no {}", file, missing);
        if (const Result r = cuInit(0)) return words(r);
        int version = 0;
        cuDriverGetVersion(&version);
        driver = fmt::format("{}.{}", version / 1000, version % 1000 / 10);
        if (const Result r = cuDeviceGetCount(&count)) return words(r);
        if (count == 0) return "the driver knows no device";
        std::string too_old;
        std::vector<int> which;
        for (int k = 0; k < count; ++k) {
            int major = 0, minor = 0;
            if (!look_at(k) || cuDeviceGetAttribute(&major, attribute_major, device) ||
                cuDeviceGetAttribute(&minor, attribute_minor, device))
                continue;
            if (major >= oldest_major)
                which.push_back(k);
            else
                too_old = fmt::format("{} has compute capability {}.{}, and {}.0 is needed", name, major, minor,
                                      oldest_major);
        }
        if (which.empty()) return too_old.empty() ? "the driver does not say what its device is" : too_old;
        usable = static_cast<int>(which.size());
        const int k = which[static_cast<std::size_t>(process % usable)];
        look_at(k);
        cuDeviceGetAttribute(&multiprocessors, attribute_multiprocessors, device);
        cuDeviceTotalMem(&memory, device);
        number = k + 1;
        return "";
    }

    /// At the k-th of all; false: the driver does not know it.
    bool look_at(int k) {
        char buffer[256] = {};
        if (cuDeviceGet(&device, k) || cuDeviceGetName(buffer, 255, device)) return false;
        name = buffer;
        return true;
    }

    std::string words(Result r) const {
        const char* text = nullptr;
        cuGetErrorString(r, &text);
        return fmt::format("the driver says \"{}\" (error {})", text ? text : "?", r);
    }
    void check(Result r, const char* doing) const {
        if (r) throw RunError(fmt::format("{}, while {}: {}", name, doing, words(r)));
    }
};

std::string Device::reason_against() {
    Library library;
    return library.load();
}

std::string Device::name_here() {
    Library library;
    return library.load().empty() ? library.name : "";
}

double Device::memory_here() {
    Library library;
    return library.load().empty() ? double(library.memory) : 0;
}

int Device::count_here() {
    Library library;
    return library.load().empty() ? library.usable : 0;
}

std::shared_ptr<Device> Device::open(int process) { return std::shared_ptr<Device>(new Device(process)); }

Device::Device(int process) : library_(std::make_unique<Library>()) {
    Library& l = *library_;
    if (const std::string against = l.load(process); !against.empty())
        throw InputError(
            fmt::format("a GPU was asked for, and {}; `twinwake doctor` says what was looked for", against));
    l.check(l.cuDevicePrimaryCtxRetain(&l.context, l.device), "opening it");
    l.check(l.cuCtxSetCurrent(l.context), "opening it");
    const char* strict = std::getenv("TWINWAKE_STRICT_KERNELS");
    const char* const kernels = strict && *strict == '1' ? tw_strict_kernels_ptx : tw_kernels_ptx;
    std::array<char, 4096> log{};
    constexpr int error_log = 5, error_log_bytes = 6;
    int options[] = {error_log, error_log_bytes};
    void* values[] = {log.data(), reinterpret_cast<void*>(log.size() - 1)};
    if (const Result r = l.cuModuleLoadDataEx(&l.module, kernels, 2, options, values))
        throw InputError(fmt::format("{}: driver {} does not take the kernels of this program: {} {}", l.name, l.driver,
                                     l.words(r), log.data()));
}

Device::~Device() = default;

const std::string& Device::name() const { return library_->name; }
const std::string& Device::driver() const { return library_->driver; }
std::size_t Device::memory() const { return library_->memory; }
int Device::multiprocessors() const { return library_->multiprocessors; }
int Device::number() const { return library_->number; }
int Device::of() const { return library_->count; }
int Device::usable() const { return library_->usable; }

std::size_t Device::free_memory() const {
    std::size_t free = 0, all = 0;
    library_->check(library_->cuMemGetInfo(&free, &all), "asking for its memory");
    return free;
}

std::uint64_t Device::allocate(std::size_t bytes) {
    Pointer at = 0;
    if (const Result r = library_->cuMemAlloc(&at, bytes))
        throw RunError(fmt::format("{} has no {:.0f} MB left for the particles: {}", name(), double(bytes) / 1e6,
                                   library_->words(r)));
    return at;
}
void Device::release(std::uint64_t at) noexcept { library_->cuMemFree(at); }
void Device::forget(std::uint64_t at, std::size_t bytes) {
    if (library_->forget) library_->forget(at, bytes);
}
void Device::to_device(std::uint64_t to, const void* from, std::size_t bytes) {
    library_->check(library_->cuMemcpyHtoD(to, from, bytes), "copying to it");
    traffic_.to_device += bytes;
}
void Device::to_host(void* to, std::uint64_t from, std::size_t bytes) {
    library_->check(library_->cuMemcpyDtoH(to, from, bytes), "copying from it");
    traffic_.to_host += bytes;
}
void Device::within_device(std::uint64_t to, std::uint64_t from, std::size_t bytes) {
    library_->check(library_->cuMemcpyDtoD(to, from, bytes), "copying within it");
}
void Device::set_zero(std::uint64_t at, std::size_t bytes) {
    library_->check(library_->cuMemsetD8(at, 0, bytes), "clearing its memory");
}

void Device::launch(const char* kernel, std::size_t threads, std::span<void*> arguments) {
    if (threads == 0) return;
    Library& l = *library_;
    void*& function = l.kernels[kernel];
    if (!function) l.check(l.cuModuleGetFunction(&function, l.module, kernel), kernel);
    const auto blocks = static_cast<unsigned>((threads + threads_in_block - 1) / threads_in_block);
    l.check(l.cuLaunchKernel(function, blocks, 1, 1, threads_in_block, 1, 1, 0, nullptr, arguments.data(), nullptr),
            kernel);
}

void Device::finish() { library_->check(library_->cuCtxSynchronize(), "running its kernels"); }

}  // namespace tw::cuda
