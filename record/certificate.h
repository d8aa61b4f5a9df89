#pragma once
#include "record/run_record.h"

namespace tw {

/// Keeps the worst of the record's line of this name and this one; a value that is not a number is the worst.
void note_worst(RunRecord& record, const CertificateLine& line);

/// In a tank, after each frame (the last row of table `samples`): the energy that was not there at the first one, as a
/// share of the potential energy then,
///
///   energy made = (E(t) - E(0)) / |E_p(0)|   [%],  limit 1 %,  E: kinetic, potential and, where known, elastic and the
///   air's
///
/// Walls at rest do no work, so nothing but a fault of the method makes energy. A stream brings its own: no line.
void watch_energy(RunRecord& record);

}  // namespace tw
