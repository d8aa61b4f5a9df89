#pragma once
#include <cstddef>
#include <optional>
#include <string>
#include <vector>

#include "compare/compare.h"
#include "meshes/surface.h"
#include "record/body_pose.h"

namespace tw {

// The solids of a comparison as pictures and the 3-D view draw them, and the pressures on a hull.

/// A body of a record as it stood at the start; of two dimensions as wide as the slab that the water is drawn as.
Surface drawn_body(const RunRecord& record, const BodyShape& body);

/// The bodies of a record, but not a free hull, where they stand at a time [s].
std::vector<Surface> bodies_at(const RunRecord& record, double time);

/// A hull or a body that is drawn beside the water, once for all sources that have the same.
struct DrawnSolid {
    Surface surface;
    std::vector<std::size_t> sources;
    std::vector<const BodyShape*> motions;  ///< one per source; null: it stays where it is

    bool moves() const { return motions.front() != nullptr; }
    /// A tank's, not a free hull.
    bool is_body() const;
};
/// Hulls before bodies, each with at most `most_triangles`. Pointers into the comparison's records.
std::vector<DrawnSolid> drawn_solids(const Comparison& comparison, std::size_t most_triangles);

/// Ends of the scale on which the page shows the pressures of all sources alike [Pa].
struct PressureRange {
    double low = 0, high = 0;
};
/// The middle 98 % of the pressures on wet triangles; nothing where no record has pressures.
std::optional<PressureRange> pressure_range(const Comparison& comparison);

/// The pressure on a triangle of a record's hull [Pa]; nothing where it is dry or unknown.
std::optional<double> wet_pressure(const RunRecord& record, std::size_t triangle);

/// The pressures of a record's last frame on a hull that is drawn with other, perhaps fewer, triangles than it was
/// recorded on: each has that of the nearest triangle that faces the same side. `recorded`: where the record's triangles
/// are. In base64 a byte each, 0 to 254 over the range and 255 where it is dry or unknown.
std::string packed_pressures(const RunRecord& record, const Surface& recorded, const Surface& drawn,
                             const PressureRange& range);

}  // namespace tw
