#pragma once
#include <array>

#include "base/vec3.h"

namespace tw {

/// How a point of an elastic body hangs on its shell, see elastic_body.h.
struct Tie {
    std::array<int, 4> nodes{};
    std::array<double, 4> shares{};  ///< of the four nodes, in their order [-]
    Vec3 arm = Vec3::Zero();  ///< at the start [m]
};

}  // namespace tw
