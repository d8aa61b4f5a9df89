#pragma once
#include <optional>
#include <string>

#include "compare/compare.h"
#include "statistics/sustained_oscillation.h"

namespace tw {

/// Of a hull that is free in heave and pitch (table hull_motion), settled means as of the forces:
///   running_trim      bow up [deg]
///   rise              of the centre of gravity from where the hull floats at rest [m]; negative: sinkage
///   transom_sinkage   of the transom's keel from there, downward [m]
/// and where some run porpoises, beside them, porpoising_pitch [deg], porpoising_heave [m] and porpoising_period [s] with
/// a banner: the means are then those of an oscillation.
void add_hull_motion(Comparison& comparison, const CompareOptions& options);

/// Sustained oscillation of a hull in pitch and heave, of constant or growing amplitude (Savitsky 1964, section on
/// porpoising), after the record's mean_from. Named from an amplitude of 0.25 deg or of a hundredth of the beam on;
/// smaller ones are left to the intervals of the means. None in a wave.
struct Porpoising {
    Oscillation pitch, heave;  ///< [deg], [m]; zeros of the one that does not oscillate
    double period() const { return pitch.cycles > 0 ? pitch.period : heave.period; }
};
std::optional<Porpoising> porpoising(const RunRecord& record);

}  // namespace tw
