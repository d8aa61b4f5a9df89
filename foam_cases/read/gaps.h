#pragma once
#include <optional>
#include <string>

#include "foam_cases/case_plan.h"
#include "foam_cases/read/solver_log.h"
#include "record/run_record.h"

namespace tw {

/// The attribute that says on what the forces of a record are.
inline constexpr const char* loads_of = "loads_of";

/// Rows that a run should have left and that are not there.
struct Gap {
    double time = 0;   ///< of the first of them [s]
    std::string what;  ///< e.g. "forces_total has rows for 1 of 50 time steps"
};

/// The earliest gap up to the time `until` [s], measured against the solver's log and the write interval
/// (numbers["write_interval"] of the record): every step has a row in forces_total, pressure and height, every write
/// time one in samples and forces, as far as the scene asks for these tables; forces on the solids of a tank only
/// where the record's case was written to keep them (attribute loads_of: those of earlier versions were not). Where
/// writes fall on steps, the step nearest to each write time has the row.
std::optional<Gap> first_gap(const CasePlan& plan, const SolverLog& log, const RunRecord& record, double until);

/// Whether the record of a hull has no pressure on it, which every write time leaves.
bool lacks_picture(const CasePlan& plan, const RunRecord& record);

}  // namespace tw
