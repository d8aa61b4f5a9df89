#pragma once
#include <cstddef>
#include <cstdint>

#include "sph_solver/fields/field_list.h"
#include "sph_solver/pair_loops/packed.h"

namespace tw {

/// The wall nearest to a particle, which Walls::nearest finds.
struct NearestWall {
    PackedWallNormal normal = no_wall;
    PackedLeaving leaving{};     ///< the water's way past the wall, before and beyond an edge
    std::size_t body = 0;        ///< meaningful where `normal` is not `no_wall`
    std::int32_t triangle = -1;  ///< of the body's surface; likewise

    /// Takes it as the wall of particle i.
    void note(const FieldsView& of, std::size_t i) const {
        of.wall_normal[i] = normal;
        of.wall_leaving[i] = leaving;
        if (of.wall_body) of.wall_body[i] = static_cast<std::uint16_t>(body);
        if (of.wall_triangle) of.wall_triangle[i] = triangle;
    }
};

}  // namespace tw
