#pragma once
#include <optional>
#include <span>
#include <vector>

#include "meshes/surface.h"

namespace tw {

/// Bounds of the hull's bottom within `part`; none where nothing of it lies there. Its bottom is what looks down: on
/// topsides no jet is born.
std::optional<Box> bottom_within(const Surface& hull, const Box& part);
/// As far as it consists of those triangles.
std::optional<Box> bottom_within(const Surface& hull, std::span<const std::size_t> triangles, const Box& part);

/// The parts of y that the bottom covers within `part`, those less than `apart` [m] from each other as one, in rising order.
struct Breadth {
    double min = 0, max = 0;  ///< [m]
};
std::vector<Breadth> breadths_within(const Surface& hull, std::span<const std::size_t> triangles, const Box& part,
                                     double apart);

}  // namespace tw
