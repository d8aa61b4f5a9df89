#pragma once
#include <optional>
#include <string>

#include "compare/compare.h"
#include "meshes/surface.h"

namespace tw {

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
