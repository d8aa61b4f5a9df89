#pragma once
#include <span>

#include "meshes/query.h"
#include "meshes/zone.h"
#include "sph_solver/domain/level_setup.h"
#include "sph_solver/even_packing.h"
#include "sph_solver/lattice.h"

namespace tw {

/// Where the lattices of boxes of one water do not fit together, moves the particles near the face between them until
/// their packing is even (even_packing.h); depths go with them. `zone`: of the particles if they are finer than others,
/// of which those near its edge and beyond stay where they are; null: there is none.
void even_out_seams(const EvenPacking& packing, std::span<const Box> water, std::span<const Lattice> lattices,
                    std::span<const SurfaceQuery> solids, const Zone* zone, Fluid& fluid);

}  // namespace tw
