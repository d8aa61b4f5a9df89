#pragma once
#include <string>

#include "record/run_record.h"
#include "scene/scene.h"

namespace tw {

/// The table of the net pressure on each element of an elastic plate's rigid counterpart [Pa], on the face out of which
/// the plate's normal points.
inline std::string plate_pressure_table(const std::string& body) { return "plate_pressure_" + body; }

/// The pressures are asked for this often in the plate's first period, and this often at least they have to be there.
inline constexpr double pressures_per_period = 50, fewest_per_period = 20;

/// Where the times without a force, in which a solver sets air and water in motion at once, take more than this share of
/// all that the fluid changes the plate's velocity by, the impulse itself lies in them and is left out.
inline constexpr double largest_false_start = 0.1;

/// interFoam cannot bend a plate. So the pressures that it has recorded on the rigid one (table `plate_pressure_table`)
/// are put onto the plate's shell after the run, with its supports or its frame, its velocity at the start and its
/// weight: one way, the water knows nothing of what the plate does. Pressures at times at which the record has no force,
/// the false start, are left out: the shell starts after them, unstrained, where the rigid plate then is and as fast as
/// that. What the scene's gauges read goes into the table of
/// the body under the names that the particles give them, at the times of that table. The attribute `structure` becomes
/// "rigid, strains one way", and `one_way` says in a sentence how often there were pressures in the plate's first
/// period, and that they are too few where they are fewer than `fewest_per_period`; and what was left out.
///
/// Does nothing without an elastic plate, without gauges, or with fewer than two times of pressures. Throws InputError
/// where the table has another number of elements than the plate, RunError where the shell cannot be stepped.
void add_one_way_strains(const Scene& scene, RunRecord& record);

}  // namespace tw
