#pragma once
#include <cstddef>

#include "sph_solver/effects/ventilation.h"
#include "sph_solver/fields/quantities.h"
#include "sph_solver/loops/surface.h"
#include "sph_solver/pair_loops/clusters.h"

namespace tw {

/// Whether air is at a particle, see ventilation.h; after the marks at the free surface.
struct AirAtParticles {
    Aired* aired;
    const PackedWallNormal* wall;  ///< null: there are no walls
    const float* drho;             ///< rho - rho0 [kg/m3]
    const std::uint32_t* surface;
    float reach;  ///< [m]

    /// Beside a wall and not pressed on it.
    bool loose(std::size_t i) const { return wall && wall[i].distance < reach && drho[i] <= 0; }
    /// Air that was there is there still.
    bool stays(std::size_t i) const {
        return (marked(surface, i) && aired[i] != Aired::no) || (aired[i] == Aired::yes && loose(i));
    }
    /// From a particle near by.
    bool may_come(std::size_t i) const { return marked(surface, i) || loose(i); }
    bool comes(std::size_t i, Round round) const {
        return round != Round::no_air && (marked(surface, i) || (loose(i) && round == Round::air_and_tension));
    }
    void note(std::size_t i, const std::uint32_t* stays, const Round* round) const {
        aired[i] = marked(stays, i) || comes(i, round[i]) ? Aired::yes : Aired::no;
    }
};

/// Marks those that air stays at; by words of 32.
struct MarkAir {
    AirAtParticles air;
    const Link* links;
    std::size_t n, all;
    std::uint32_t* words;

    void operator()(std::size_t word) const {
        MarkBits{[&](std::size_t i) { return air.stays(i); }, links, n, all, words}(word);
    }
};
/// The clusters that air may come to.
struct MayGetAir {
    AirAtParticles air;
    const std::uint32_t* stays;

    bool operator()(const Cluster& g) const {
        for (int l = 0; l < g.size; ++l) {
            const auto i = static_cast<std::size_t>(g.first + l);
            if (!marked(stays, i) && air.may_come(i)) return true;
        }
        return false;
    }
};
struct NoteAir {
    AirAtParticles air;
    const std::uint32_t* stays;
    const Round* round;

    void operator()(std::size_t i) const { air.note(i, stays, round); }
};

}  // namespace tw
