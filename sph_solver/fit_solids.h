#pragma once
#include <span>

#include "sph_solver/simulation.h"

namespace tw {

/// Fits water that begins at rest to the solids in it. `fill_levels` keeps every point of the lattice that is outside a
/// solid, so that a row of particles may stand on one face of it and half a cell of void beside the other. Here, of
/// each solid that cuts cells of the lattice:
///
/// 1. A cell that is cut is filled or not so that along the solid there are as many particles as the water's share of
/// the
///    cells asks for: what rounding leaves over is handed on to the cells beside it (error diffusion, Floyd & Steinberg
///    1976). A particle that fills one stands at the middle of the cell's water.
/// 2. The particles within four spacings of the solid are moved until their packing is even (even_packing.h); depths go
///    with them, so that the pressure stays that of the place.
///
/// A solid whose faces are faces of cells changes nothing. Streams carry their start away and are left as they are; so
/// are particles near the edge of a zone and beyond. `levels`: of `fill_levels`; their pressures at the start are found
/// afterwards.
void fit_to_solids(const SimulationSetup& setup, std::span<const Box> blocks, std::span<Fluid> levels);

}  // namespace tw
