#pragma once
#include <cstddef>
#include <cstdint>

#include "sph_solver/domain/kind.h"
#include "sph_solver/fields/quantities.h"
#include "sph_solver/loops/link_map.h"
#include "sph_solver/pair_loops/packed.h"

namespace tw {

/// Whether a particle is at the free surface: a buffer particle where the coarser particles near it are.
struct LacksSupport {
    const Kind* kind;
    const Trend* trend;  ///< null: there are no buffer particles
    const PackedShiftSupport* shift;
    double surface_support;  ///< of LevelSetup [-]

    bool operator()(std::size_t i) const {
        const bool buffer = trend && kind[i] == Kind::buffer;
        return static_cast<double>(buffer ? trend[i].support : shift[i].support) < surface_support;
    }
};

/// A bit for each particle and each image of one: `has(i)`, i < n; images are those of `links`.
template <class Has>
struct MarkBits {
    Has has;
    const Link* links;
    std::size_t n, all;
    std::uint32_t* words;  ///< bit i % 32 of word i / 32

    void operator()(std::size_t word) const {
        std::uint32_t bits = 0;
        const std::size_t end = all < 32 * word + 32 ? all : 32 * word + 32;
        for (std::size_t i = 32 * word; i < end; ++i)
            bits |= std::uint32_t{has(i < n ? i : static_cast<std::size_t>(links[i - n].index))} << (i % 32);
        words[word] = bits;
    }
};
template <class Has>
MarkBits(Has, const Link*, std::size_t, std::size_t, std::uint32_t*) -> MarkBits<Has>;
inline bool marked(const std::uint32_t* words, std::size_t i) { return (words[i / 32] >> (i % 32) & 1u) != 0; }

}  // namespace tw
