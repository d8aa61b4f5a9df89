#pragma once
#include <string>
#include <string_view>

#include "scene/scene.h"

namespace tw {

// The twin of a scene with a regular wave: the same run with one thing left out, everything else as it follows from the
// whole scene.
//   Free bodies in a tank are left out (the empty twin), or where there are none its obstacles, with a height gauge where
//   each body's centre of mass is at the start, or each obstacle's middle. Over the wave that it shows there a response or
//   a force does not contain how well the wave is made, nor what it loses on its way.
//   Before a hull in a stream the wave is left out (the calm twin): what drag, trim and rise are more in waves than there
//   is added by the waves.

/// A rigid body is free.
bool has_responses(const Scene& scene);
/// What an empty twin would leave out is there.
bool has_empty_twin(const Scene& scene);
/// Whether studies run the scene's twin: by [wave] empty_twin and calm_twin; "auto": in two dimensions, where it costs as
/// much as the run itself, and not of obstacles, many of which are shores.
bool wants_wave_twin(const Scene& scene);
/// "its bodies", "its obstacles" or "the wave": what its twin leaves out.
std::string left_out_of_twin(const Scene& scene);
/// Name of the folder of its twins (record/wave_twin.h).
std::string_view folder_of_wave_twin(const Scene& scene);

/// Makes the checked scene its own twin. All that has followed from bodies and wave before (times, Courant numbers, sound
/// speed, box, effects) stays; gauges stay too, and beside free bodies obstacles. Throws InputError: a gauge has the name of one that is put in.
void make_wave_twin(Scene& scene);

}  // namespace tw
