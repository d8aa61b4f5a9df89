#pragma once
// What ranks exchange of things on a device, put into one message and taken out of it: plain data for kernels, as in
// tasks.h.
#include <cstddef>
#include <cstdint>

#include "sph_solver/fields/field_list.h"
#include "sph_solver/loops/pack_state.h"
#include "sph_solver/neighbours/pencil_grid.h"

namespace tw::cuda {

/// So many bytes of each element of an array, `apart` bytes from each other.
struct PartOfEach {
    std::byte* first;
    std::int32_t apart, bytes;
};

/// Some parts of each of some things, one behind the other.
struct Message {
    static constexpr int most_parts = 5;
    const int* which;
    PartOfEach parts[most_parts];
    int count;    ///< of parts
    int of_each;  ///< bytes of a thing
    std::byte* at;

    /// Copies those of the k-th thing.
    template <bool in>
    void copy(std::size_t k) const {
        std::byte* place = at + k * static_cast<std::size_t>(of_each);
        for (int n = 0; n < count; ++n) {
            const PartOfEach& part = parts[n];
            std::byte* const thing =
                part.first + static_cast<std::size_t>(which[k]) * static_cast<std::size_t>(part.apart);
            std::byte* const to = in ? thing : place;
            const std::byte* const from = in ? place : thing;
            if (of_each % 4 == 0 && part.bytes % 4 == 0)
                for (int b = 0; b < part.bytes; b += 4)
                    *reinterpret_cast<std::uint32_t*>(to + b) = *reinterpret_cast<const std::uint32_t*>(from + b);
            else
                for (int b = 0; b < part.bytes; ++b) to[b] = from[b];
            place += part.bytes;
        }
    }
};
struct PackMessage {
    Message message;
    void operator()(std::size_t k) const { message.copy<false>(k); }
};
struct UnpackMessage {
    Message message;
    void operator()(std::size_t k) const { message.copy<true>(k); }
};

// --- which particles a rank holds

/// Where particles are [fixed-point units].
struct TakeWide {
    StateView p;
    ToFixedPoint to_fixed_point;
    WidePlace* wide;

    void operator()(std::size_t i) const { wide[i] = to_fixed_point.wide(p.x[i], p.y[i], p.z[i]); }
};
/// Marks those in the run of which another rank may have to hear, or the others: by the marks of their pencils.
struct MarkInPencils {
    Pencils pencils;
    const WidePlace* wide;
    const std::uint8_t* left;  ///< those are out of the run
    const char* of_pencils;
    char wanted;
    int* marks;

    void operator()(std::size_t i) const { marks[i] = !left[i] && of_pencils[pencils.of(wide[i])] == wanted; }
};
/// Takes the marks off those that are copies.
struct MarkOwn {
    const char* own;
    int* marks;

    void operator()(std::size_t i) const { marks[i] = marks[i] && own[i]; }
};
/// How many of those before the first one of each pencil are marked.
struct StartMarked {
    const int* start;
    const int* before;
    int* to;

    void operator()(std::size_t c) const { to[c] = before[start[c]]; }
};

}  // namespace tw::cuda
