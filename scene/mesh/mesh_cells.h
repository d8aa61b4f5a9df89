#pragma once
#include <vector>

#include "scene/box/forcing_zones.h"

namespace tw {

/// Size of the cells that blockMesh makes, before any is halved [m]: near_hull where cells have one size (two
/// dimensions; tanks without refinement and without a body that moves), else spacing.
double background_cell(const Scene& scene);

/// Whole halvings from there to near_hull.
int finest_halvings(const Scene& scene);

/// How often cells are halved along the surfaces of hull and bodies in two dimensions. With none the stream does not
/// leave the trailing edge of a plate: it turns round it into the cell behind (docs/decisions/024-hull-force-cured.md).
inline constexpr int section_levels = 2;

/// Edge of the finest cells [m]: near_hull, and along hull and bodies of two dimensions so much less.
double finest_cell(const Scene& scene);

/// Along a forcing zone each cell is so much longer than the one before it, so that the last, where waves have gone, is
/// as long as a fifth of the zone and one more of the first.
inline constexpr double growth_in_zones = 1.2;
/// How many cells a zone of this width has along itself, the first of the size `cell`: the sum of their lengths is
///
///   width = cell (q^n - 1) / (q - 1),   q = growth_in_zones
double cells_along_zone(double width, double cell);
/// The zones in which cells grow: those of a stream, which lie outside the box that was asked for, but for one that
/// makes a wave. In a tank they lie inside, where bodies and solids may be.
std::vector<ForcingZone> grown_zones(const Scene& scene);

/// At least so many cells of one size lie between two others (nCellsBetweenLevels).
inline constexpr int cells_between_levels = 3;

/// Three dimensions: where cells have the size near_hull round a body that the mesh follows: below and beside it, and
/// where its cavity and splash are behind it.
std::vector<RefinementBox> boxes_round_bodies(const Scene& scene);

/// Cells of the mesh method's mesh, as predicted.
double predicted_cells(const Scene& scene);

}  // namespace tw
