#pragma once
#include <string>
#include <vector>

#include "stability/hard_case.h"

namespace tw {

/// stable: it ran to its end and met every limit; warned: it ran to its end, and its numbers say that they are not to
/// be trusted; failed: the engine stopped it, or a law is broken (particles gone, energy made, still water that moves).
enum class Stability { stable, warned, failed };
const char* to_string(Stability stability);

/// The limits of a validity check.
struct StabilityLimit {
    std::string line, unit;
    double warned, failed;  ///< above which the case is that
    std::string meaning;    ///< what it says to be above, e.g. "c0 too low"
    std::string why;        ///< the reason of the limits
};
const std::vector<StabilityLimit>& stability_limits();

/// Up to this Courant number the solver is said to be stable (`SimulationSetup::cfl`, sph_solver/README.md).
inline constexpr double stated_courant_limit = 1.2;

struct StabilityJudgement {
    Stability stability = Stability::stable;
    std::string reason;  ///< empty when stable: every limit that was passed, or what the engine said
    std::string label;  ///< a few letters for a cell: the check that came nearest to its limit, or went farthest beyond
};
/// A value that is not a number is beyond every limit; a run that did nothing has failed. Where the time step was
/// longer than stated, a large Mach number is not laid at c0's door alone.
StabilityJudgement judge_stability(const HardCase& c, const HardCaseRun& run);

}  // namespace tw
