#pragma once
#include <array>

namespace tw {

/// Slip walls and symmetry planes on faces of the domain box, by exact mirror images: [axis][0 low, 1 high]. A periodic
/// axis has no planes: what leaves at one face comes in at the other, and sees the other side's particles as images.
struct Mirrors {
    std::array<std::array<bool, 2>, 3> on{};
    std::array<bool, 3> periodic{};
    /// Of these planes the walls that hold the water (no slip). Only the pair loops of viscosity know of them: to all
    /// others an image slides along the plane.
    std::array<std::array<bool, 2>, 3> holding{};
    bool any_holds() const { return holding != std::array<std::array<bool, 2>, 3>{}; }
};

}  // namespace tw
