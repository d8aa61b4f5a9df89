#pragma once
#include "scene/scene.h"

namespace tw {

// The empty twin of a scene with a wave and free bodies: the same tank, wave, sizes, times and numerics without the
// bodies, with a height gauge where each body's centre of mass is at the start. Over the wave that it shows there a
// response does not contain how well the wave is made, nor what it loses on its way.

/// A rigid body is free.
bool has_responses(const Scene& scene);
/// Whether studies run the scene's empty twin: by [wave] empty_twin; "auto": with a regular wave and a free rigid body,
/// in two dimensions, where it costs as much as the run itself.
bool wants_empty_twin(const Scene& scene);

/// Makes the checked scene its own empty twin. All that has followed from the bodies before (times, Courant numbers,
/// sound speed, effects) stays; obstacles and gauges stay too. Throws InputError: a gauge has the name of one that is
/// put in.
void leave_bodies_out(Scene& scene);

}  // namespace tw
