#pragma once
#include <limits>
#include <numbers>

namespace tw {

using std::numbers::pi;
inline constexpr double degree = pi / 180;  ///< [rad]
inline constexpr double infinite = std::numeric_limits<double>::infinity();
inline constexpr double nan = std::numeric_limits<double>::quiet_NaN();  ///< a value that is not known

}  // namespace tw
