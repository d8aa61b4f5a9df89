#pragma once
#include <cmath>
#include <string>

#include "base/numbers.h"
#include "text/plain_number.h"

namespace tw {

/// An angle for people, in degrees; less than a millionth of one is rounding of the turns that it came from: "0".
inline std::string plain_degrees(double radians, int digits = 3) {
    const double degrees = radians / degree;
    return plain_number(std::abs(degrees) < 1e-6 ? 0 : degrees, digits);
}

}  // namespace tw
