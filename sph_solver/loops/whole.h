#pragma once
#include <cmath>
#include <cstdint>

namespace tw {

/// The nearest whole number, of two the even one.
inline std::int64_t nearest_whole(double x) {
#ifdef TW_THREADS
    return __nvvm_d2ll_rn(x);
#else
    return std::llrint(x);
#endif
}

}  // namespace tw
