#pragma once
#include <cmath>
#include <filesystem>
#include <limits>

#include "foam_cases/case_plan.h"
#include "foam_cases/read/solver_log.h"
#include "record/run_record.h"

namespace tw {

/// A probe that lies in no cell reads as a huge number: not known.
inline double found_by_probe(double value) {
    return std::abs(value) > 1e100 ? std::numeric_limits<double>::quiet_NaN() : value;
}

/// The record's table of pressures, made anew from what the function object `pressureProbes` has left below `post`
/// (postProcessing) at every step. In water
///
///   p(x) = p_rgh(x') + rho(x') g . x   [Pa]
///
/// x: the probe's own place; x': that place, or where a wall is there, a twentieth of a cell off it. p_rgh, the pressure
/// less the hydrostatic part, has no gradient across a wall at rest, and g is that of a tank's own axes where it moves
/// (interFoam's own p is half a cell's hydrostatic pressure off on the plane walls of a tank that moves, and in the
/// corners of all). In air (water fraction below a half) it is p(x').
void read_pressure_probes(const CasePlan& plan, const std::filesystem::path& post, RunRecord& record);

/// The record's table of heights likewise, from the water fractions of the function object `heightColumns`, as
/// record/gauge_level.h defines them.
void read_height_probes(const CasePlan& plan, const std::filesystem::path& post, const SolverLog& log,
                        RunRecord& record);

}  // namespace tw
