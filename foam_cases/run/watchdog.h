#pragma once
#include <filesystem>
#include <optional>
#include <string>

#include "foam_cases/case_plan.h"
#include "foam_cases/read/solver_log.h"
#include "record/run_record.h"

namespace tw {

/// Stops that OpenFOAM lacks: what makes the rest of a run wrong or endless. Fast air in some cells does not.
struct Limits {
    double smallest_step = 1e-8;                          ///< [s]
    double collapse = 1e-3;                               ///< of the usual (median) step [-]...
    int collapsed_steps = 100;                            ///< ...for so many steps on end
    double air_speed = 1e30;                              ///< [m/s], faster than air is pressed out of any gap
    double water_speed = 1e30;                            ///< [m/s]...
    double fast_water = 1e-3;                             ///< ...that no more than this share of the water may have [-]
    bool gains_no_water = false, loses_no_water = false;  ///< tanks; the second where they are closed
    double water = 0.02;                                  ///< share of the water that may come or go all the same [-]
    double stream_water = 1e30;  ///< share by which the water in a stream's box may become more or less [-]
    double fraction = 0.5;       ///< by which any cell's water fraction may lie outside 0 to 1 [-]
    double continuity = 1e-3;    ///< error that a step leaves, in volumes of the domain [-]; sound runs: up to 1e-5
    double energy_made = 0.2;    ///< over the water's height above the tank's floor at the start (energy_of_height) [-]
};
/// The limits that apply to a scene.
Limits limits_of(const CasePlan& plan);

/// In plain words what is wrong and a likely cause; nothing while all is well. `largest_speed`, of air and water [m/s],
/// may be NaN: unknown.
std::optional<std::string> trouble(const SolverLog& log, double largest_speed, const Limits& limits);

/// The same of what the record holds of the water: how much of it is too fast (column `fast_water` of the samples), and
/// energy that nothing has given it.
std::optional<std::string> water_trouble(const RunRecord& record, const Limits& limits);
/// Largest velocity that the `fastest` function object has written last [m/s]; NaN while there is none. What is later
/// than `now` [s], the step under way, is of an earlier start of the solver and does not count.
double latest_fastest(const std::filesystem::path& post_processing, double now);

/// Says so when fewer than `needed` bytes are free where `folder` lies.
std::optional<std::string> disk_trouble(const std::filesystem::path& folder, double needed);

}  // namespace tw
