#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "foam_cases/run/solver_log.h"

namespace tw {

/// Stops that OpenFOAM lacks: a time step that collapses, velocities beyond reason, a water volume that is no number.
struct Limits {
    double smallest_step = 1e-8;  ///< [s]
    double collapse = 1e-3;       ///< of the usual (median) step...
    int collapsed_steps = 100;    ///< ...for so many steps on end
    double speed = 1e30;          ///< [m/s]
    /// For so long [s] ten times that speed: a stream that starts at once squeezes the air out from between a flat bottom
    /// and the water that rises under it. A stepped hull at 80 m/s saw 1700 m/s at 7 ms, 450 m/s at 50 ms.
    double start_up = 0;
};
/// In plain words what is wrong and a likely cause; nothing while all is well. `largest_speed` [m/s] may be NaN:
/// unknown.
std::optional<std::string> trouble(const SolverLog& log, double largest_speed, const Limits& limits);

/// Largest velocity that the `fastest` function object has written last [m/s]; NaN while there is none. What is later
/// than `now` [s], the step under way, is of an earlier start of the solver and does not count.
double latest_fastest(const std::filesystem::path& post_processing, double now);

/// Says so when fewer than `needed` bytes are free where `folder` lies.
std::optional<std::string> disk_trouble(const std::filesystem::path& folder, double needed);

}  // namespace tw
