#pragma once
#include <string>
#include <utility>
#include <vector>

#include "compare/compare.h"

namespace tw {

/// The checks of one run, as they are made.
struct GateList {
    const RunRecord& record;
    const std::string& name;  ///< of the run, for people
    std::vector<Gate> gates = {};

    /// Met by a value up to the limit.
    void add(std::string gate, std::string unit, double value, double limit, std::string remark) {
        gates.push_back({std::move(gate), name, std::move(unit), value, limit, value <= limit + 1e-9 * std::abs(limit),
                         std::move(remark)});
    }
};

/// Whether the water is all there and at rest where it should be (metrics/water_kept.h).
void add_water_gates(GateList& list);
/// What a hull shows that the resolution or the method gets wrong: air smeared under it, suction at its edges, drag that
/// its bottom cannot have, force measures that differ.
void add_hull_gates(GateList& list);

}  // namespace tw
