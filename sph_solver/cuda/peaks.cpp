#include "sph_solver/cuda/peaks.h"

#include <algorithm>
#include <chrono>
#include <limits>

#include "sph_solver/cuda/launch.h"
#include "sph_solver/pair_loops/packed.h"

namespace tw::cuda {

Peaks measure_peaks(Device& device) {
    const auto seconds_of = [&](const auto& work) {
        double least = std::numeric_limits<double>::infinity();
        for (int trial = 0; trial < 5; ++trial) {
            device.finish();
            const auto start = std::chrono::steady_clock::now();
            work();
            device.finish();
            least = std::min(least, std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count());
        }
        return least;
    };
    Array<float> result(device);
    result.resize(1);
    const std::size_t threads = static_cast<std::size_t>(device.multiprocessors()) * 16 * threads_in_block;
    const PeakArithmetic arithmetic{result.data(), 20000};
    const double flops = 2.0 * 16 * arithmetic.rounds * double(threads) /
                         seconds_of([&] { launch_threads(device, threads, arithmetic); });
    constexpr int length = 1 << 20;  // 16 MB
    Array<PackedPlace> array(device);
    array.resize(length);
    array.set_zero();
    const PeakCache cache{result.data(), array.data(), length, 100};
    const double bytes = double(length) * sizeof(PackedPlace) * cache.rounds /
                         seconds_of([&] { launch_threads(device, threads, cache); });
    return {flops, bytes};
}

}  // namespace tw::cuda
