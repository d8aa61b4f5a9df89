#pragma once
#include <set>
#include <string>

#include "import/mapping.h"
#include "record/run_record.h"
#include "text/csv_columns.h"

namespace tw {

// The steps of import_record, in their order. All throw InputError.

/// The record before anything is read: what follows from the scene, and nothing of a solver. Refuses columns of
/// [pressure] and [height] that are no probes of the scene, and water of a half model in a whole scene or the reverse.
RunRecord blank_record(const Mapping& mapping);

/// Where the source's moments are taken about, in the scene's axes [m]; nothing when nobody says.
using MomentPoint = std::optional<Vec3>;

// Each reader fills tables as its source has them: SI units and scene axes, but not doubled, moments about the point it
// returns.
MomentPoint read_csv(const Mapping& mapping, RunRecord& record);
/// One column in SI. `units`: of all columns, from a row of their own; they count where the mapping gives none.
std::vector<double> series_of(const ColumnSource& column, const CsvColumns& csv,
                              const std::vector<std::string>& units = {});
/// CSV of DualSPHysics' ComputeForces: the columns that the mapping leaves open are found by their names.
MomentPoint read_dualsphysics(Mapping mapping, RunRecord& record);
/// The `forces` function object of any OpenFOAM case: postProcessing/<function object>/<start time>/.
MomentPoint read_openfoam(const Mapping& mapping, RunRecord& record);

/// Pours the water that the mapping names into the scene's voxels, a frame for each of its times. Refuses scenes of
/// two dimensions, rows without numbers or out of order, and more water than cell.
void read_water(const WaterSource& water, RunRecord& record);

/// Refers `my` to the record's moment reference.
void refer_moment(const Mapping& mapping, const MomentPoint& point, RunRecord& record);
/// Doubles the loads of a half model, once.
void make_whole(RunRecord& record);

}  // namespace tw
