#pragma once
#include "record/raster.h"
#include "sph_solver/simulation.h"

namespace tw {

/// Where the water of all sizes of particles is. Each place belongs to one size, and near an edge the particles of that
/// size that count leave a gap to the others of up to half a coarse spacing, or overlap them by as much: the whole
/// depth of such a gap would be missing under the surface. So each size is poured as far as it goes, buffer particles
/// and what stands for finer ones included, and a voxel takes the finest size in whose zone its centre lies. Spray of a
/// finer size beyond its zone, where the coarse one has no water, is poured with that. `span` [m]: of the particles of
/// a two-dimensional run, 1 otherwise.
Raster water_raster(const Simulation& simulation, const RasterSpec& spec, double span);

}  // namespace tw
