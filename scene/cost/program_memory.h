#pragma once
#include "methods/methods.h"
#include "scene/scene.h"

namespace tw {

/// What a process of the program takes beside its elements, of a particle run: 52 to 58 MB were the peak of runs of 25
/// to 3200 particles. interFoam's is part of its prediction [bytes].
inline constexpr double bytes_of_program = 55e6;

/// Predicted peak of all processes of a run together [bytes].
inline double all_bytes(const Scene& scene, const MethodCost& cost) {
    return cost.bytes + (elements_of(cost.method) == "particles" ? bytes_of_program * scene.run.ranks : 0);
}

}  // namespace tw
