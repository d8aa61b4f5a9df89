#pragma once
#include "scene/scene.h"

namespace tw {

/// Time steps of interFoam in a tank, with bodies or without. A step is the shorter of the longest one that still water
/// is taken in and that in which the fastest water crosses the share Co of a cell of edge a:
///
///   N = integral of max(1/dt_still, u/(Co a)) dt + l_jet/(Co a) + N_start
///
///   u        the fastest of: the front of the deepest water over the shallowest, 2 (sqrt(g h_deep) -
///            sqrt(g h_shallow)) (Ritter 1892, Stoker 1957), which grows as 1 - exp(-2 t sqrt(g/h_deep)); crests of
///            waves, walls of a tank that moves and the flow past bodies, whose cells are crossed in `crossings`
///            steps at Co = 1
///   l_jet    what the jets of bodies that enter run: their root goes as the half width that is wet, and the jet itself
///            twice as far (Wagner 1932)
///   N_start  steps that grow by a fifth from the first one on
///
/// Of a body that is let go at rest no step is longer than release_step (scene/mesh/step_limits.h), for which dt_still
/// stands. `crossings`: steps for each cell that a stream's water crosses at Co = 1, as measured in streams [-].
double steps_of_cells_in_tank(const Scene& scene, double crossings);

/// Of the water in the crests of the scene's waves [m/s]; 0 where it has none.
double speed_of_crests(const Scene& scene);

}  // namespace tw
