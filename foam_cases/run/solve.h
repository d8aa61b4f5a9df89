#pragma once
#include <functional>
#include <optional>
#include <string>

#include "foam_cases/case_plan.h"
#include "foam_cases/read/solver_log.h"
#include "foam_cases/run/case_programs.h"

namespace tw {

struct SolverOutcome {
    bool stopped = false;  ///< asked for
    std::string failure;   ///< empty: none
    Ended process;
};

/// Runs the solver to its end time, a stop or a failure. `growing` is called about five times a second with the log so
/// far; it returns true to ask for a stop: the solver then writes its state and ends. `wrong_in_water`, asked about once
/// a second, says what is wrong with the water at the last write time (run/watchdog.h). `log` is read on from where it
/// stands.
SolverOutcome solve(const CasePlan& plan, const CasePrograms& programs, int ranks, SolverLog& log,
                    const std::function<bool()>& growing,
                    const std::function<std::optional<std::string>()>& wrong_in_water);

/// Reads what a log file has beyond `offset` into `log`; returns the new offset.
long long follow(const std::filesystem::path& file, long long offset, SolverLog& log);

}  // namespace tw
