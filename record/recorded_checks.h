#pragma once
#include <optional>

#include "record/run_record.h"

namespace tw {

/// Lines of runs with several sizes of particles: the mass of the finer side of an edge against that of the coarse
/// particles that stand for it, and the share of an edge's particles without water of the other size near.
inline constexpr const char* mass_drift_line = "mass drift of a finer zone";
inline constexpr const char* orphans_line = "orphans at a zone's edge";
/// Of runs with bodies that bend: the energy that the interface of water and body has made lately, of that exchanged.
inline constexpr const char* interface_line = "energy made at an elastic body (added mass)";
/// Of the particles: how much less room (or more) they take inside the water than their densities say.
inline constexpr const char* crowding_line = "crowding of the particles";
inline constexpr double largest_crowding = 0.01;  ///< [-]
/// The number of a record [J, in two dimensions J/m]: the most that surface tension can give to the water's motion.
inline constexpr const char* energy_of_surface = "energy_of_surface";
/// Whether a line that is not met warns only: the run's other numbers may be used, with this in mind.
bool only_warns(const RecordedCheck& line);

/// Keeps the worst of the record's line of this name and this one; a value that is not a number is the worst.
void note_worst(RunRecord& record, const RecordedCheck& line);

/// In a tank, at the last frame (row of table `samples`), the energy that was not there at the first one,
///
///   energy made = E(t) - E(0)   [J],  E: kinetic, potential and, where known, elastic and the air's
///
/// and the work of the water on bodies that move (free or prescribed) less that of a tank that moves. Walls at rest do no
/// work, so nothing but a fault of the method makes energy; the surface of the water may give as much as the number
/// `energy_of_surface` says. A stream brings its own: nothing, as before the first frame.
std::optional<double> energy_made(const RunRecord& record);
/// What the water of a tank has at its start from its height above the tank's floor, m g z [J].
std::optional<double> energy_of_height(const RunRecord& record);
/// The energy made after each frame as a line of the validity checks: a share of |E_p(0)| and the surface's energy,
/// limit 1 %.
void watch_energy(RunRecord& record);

}  // namespace tw
