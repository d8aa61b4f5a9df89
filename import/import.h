#pragma once
#include <filesystem>

#include "record/run_record.h"

namespace tw {

/// Turns the results of another source (experiment, commercial code, DualSPHysics, an OpenFOAM case of one's own) into
/// a run record, so that compare takes it beside the runs of the scene it belongs to. `mapping`: a TOML file that says
/// what is where; README.md shows one of each kind.
///
/// The record is in SI, in the scene's axes (x with the stream to the stern, z up), of the whole hull: half models are
/// doubled here, once. Moments are referred to the scene's moment reference. Scene, hull, speed, draft, domain and
/// hashes are the scene's; attributes imported_from (a name without folders) and import_kind say where the numbers come
/// from. Raster frames and the size at the hull are known where the mapping gives them; hull pressure, effects and
/// phases are not. Cells without a number are NaN.
///
/// Throws InputError, `file:line:column: what was found; what is expected`: the mapping, the scene or a source is not
/// there or not readable; a key, column or probe is unknown; a unit does not fit; a cell holds text; times do not
/// increase; a series has no number at all.
RunRecord import_record(const std::filesystem::path& mapping);

}  // namespace tw
