#pragma once
#include <cstddef>

#include "sph_solver/fields/quantities.h"
#include "sph_solver/loops/surface.h"

namespace tw {

/// Whether air is at a particle, see effects/ventilation.h; after the marks at the free surface.
struct AirAtParticles {
    Aired* aired;
    const WallNormalRecord* wall;  ///< null: there are no walls
    const float* drho;
    const ShiftSupportRecord* shift;
    const std::uint32_t* surface;
    float reach;    ///< [m]
    float support;  ///< [-]

    /// Beside a wall, not pressed on it and short of support.
    bool loose(std::size_t i) const {
        return wall && wall[i].distance < reach && drho[i] <= 0 && shift[i].support < support;
    }
    /// Air that was there is there still.
    bool stays(std::size_t i) const {
        return (marked(surface, i) && aired[i] != Aired::no) || (aired[i] == Aired::yes && loose(i));
    }
    /// From a particle near by.
    bool may_come(std::size_t i) const { return marked(surface, i) || loose(i); }
    void note(std::size_t i, const std::uint32_t* stays, const std::uint8_t* near) const {
        aired[i] = marked(stays, i) || (near[i] && may_come(i)) ? Aired::yes : Aired::no;
    }
};

}  // namespace tw
