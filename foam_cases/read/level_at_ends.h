#pragma once
#include <array>

#include "foam_cases/case_plan.h"
#include "record/run_record.h"

namespace tw {

/// Mean level of the water in the tenth of a stream's box that is nearest to its inlet, and to its outlet: by how much
/// the water in the tenth's cells exceeds the volume of those below still water, over its area [m]. Forcing zones do not
/// belong to the box. Only of streams with zones, on a mesh at rest.
class LevelAtEnds {
public:
    explicit LevelAtEnds(const Scene& scene);
    void add(const Vec3& cell, double volume, double water);  ///< of each cell [m], [m3]
    /// Into the last row of the record's samples; the inlet's mean from `mean_from` on becomes a validity check, which
    /// fails where it departs by more than 1 % of the depth.
    void keep(RunRecord& record) const;

private:
    struct End {
        const char* name;          ///< of its column
        double low = 0, high = 0;  ///< along x [m]
        double more = 0;           ///< water over that of the start [m3]
    };
    const Scene& scene_;
    std::array<End, 2> ends_;
    bool watched_ = false;
};

inline constexpr const char* inlet_level_line = "level at the inlet";

}  // namespace tw
