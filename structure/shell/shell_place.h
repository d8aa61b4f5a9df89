#pragma once
#include "structure/shell/shell.h"

namespace tw::structure {

/// A place of a shell's mid-surface.
struct ShellPlace {
    int element = -1;
    Eigen::Vector2d at = Eigen::Vector2d::Zero();  ///< xi, eta of the element, each in [-1, 1]
    double distance = 0;                           ///< of the point that was asked for [m]

    /// N of the element's four nodes: a value there is sum_i N_i of theirs.
    std::array<double, 4> shares() const {
        return {(1 - at[0]) * (1 - at[1]) / 4, (1 + at[0]) * (1 - at[1]) / 4, (1 + at[0]) * (1 + at[1]) / 4,
                (1 - at[0]) * (1 + at[1]) / 4};
    }
};

/// The place of the reference mid-surface nearest to `point` [m].
ShellPlace nearest_place(const Shell& shell, const Vec3& point);

}  // namespace tw::structure
