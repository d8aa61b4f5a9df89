#pragma once
#include <cstddef>
#include <string>
#include <vector>

#include "compare/compare.h"
#include "record/body_pose.h"

namespace tw {

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

}  // namespace tw
