#pragma once
#include "scene/scene.h"

namespace tw {

// Everything a scene does not say, as formulas of the hull's bounding box, draft and speed. Where a number comes from a
// measurement on the reference case (prismatic hull, length 4 m, beam 1 m, trim 5 deg, 8 m/s, draft 0.2 m) it says so.

/// Particle spacing and cell at the hull: a twentieth of the beam, and at least four of them in the draft.
double default_near_hull(const Hull& hull);
/// The largest particle spacing that can be meant: half the hull's shorter side.
double coarsest_particles(const Hull& hull);
/// Largest cell: near_hull * 2^n that does not exceed a twelfth of the length, n <= 4 (measured: finer outer cells
/// change the lift by less than 0.5 %). Without a hull: near_hull.
double default_spacing(double near_hull, const Hull* hull);
/// `wish` rounded to near_hull * 2^n, n >= 0.
double snapped_spacing(double wish, double near_hull);

/// Distances of the domain's faces from the hull. Displacement hulls (length Froude number below 1) get room for the
/// wave.
struct Margins {
    double ahead = 0;   ///< from the bow to the inlet [m]
    double behind = 0;  ///< from the stern to the outlet [m]
    double side = 0;    ///< from y = 0 to the side [m]
    double below = 0;   ///< from still water to the floor [m]
    double above = 0;   ///< from still water to the top [m]
};
Margins default_margins(const Hull& hull, double speed, double gravity);

/// Boxes round the wet bottom and spray root, the wetted hull, its surroundings, the wake and the free surface.
std::vector<RefinementBox> default_refinement(const Scene& scene);

/// Settling of the stream [s]: the flow is ramped up over this time (SPH).
double default_ramp(const Scene& scene);
/// Time scale of the scene [s]: L/U in a stream with a hull, sqrt(H/g) in a tank.
double time_scale(const Scene& scene);
/// Period of the oscillation that the start leaves in the wave resistance of a hull below Froude number 1 [s]; 0 where
/// there is none to wait for:
///
///   8 pi U / g = 8 pi F^2 L/U,   the wave of frequency g / 4U, which travels with the hull (group velocity U)
///
/// It decays like one over time (Wehausen 1964, J. Ship Research 7(3); Calisal 1980, USNA-EW-4-80, measured it). From F
/// = 0.5 on, where a hull begins to plane, the period of F = 0.5 is taken: three true ones are above 20 L/U.
double start_up_period(const Scene& scene);
/// Simulated time that a scene is run for unless it says otherwise [s]: in a stream the ramp, one L/U or start-up
/// period, whichever is longer, to settle, and two L/U or three whole periods for the means; a free hull two of its heaves to
/// settle and three for the means; in a tank 10 sqrt(H/g).
double default_duration(const Scene& scene);
/// Whether the loads come to a mean that ends the run (run_end.h): a hull held in a stream, with no body beside it.
bool loads_settle(const Scene& scene);
double default_interval(const Scene& scene);  ///< between samples [s]
/// Fills what is still zero or empty in run, sampling and the sound speed; domain, resolution and motion are known.
void fill_times(Scene& scene);
/// Voxels of this edge over the part of the domain where splash is measured.
RasterSpec default_raster(const Scene& scene, double spacing);
double voxels(const RasterSpec& raster);  ///< how many
inline constexpr double most_voxels = 1e9;
/// Pressure correctors of its steps.
int default_correctors(const Scene& scene);
/// Whether the loads of the FVM run become steady, because a stream passes a hull that is held: it then needs less than
/// for a splash or a body that moves (docs/decisions/015-interfoam-settings.md). Not for sections, which may shed
/// vortices, nor under water, with viscosity or with the surface captured geometrically, where nothing was measured. Once
/// the effects are planned.
bool hull_held_in_stream(const Scene& scene);
/// With the effect dynamic_pressure: of a fall through the layer that has weight, and that whose head is the pressure of
/// the bodies' motion, viscous or inertial [m/s].
double speed_under_quiet_surface(const Scene& scene);
/// Of the water: its stream, its fall from the surface with the walls of a tank that moves, or a body's [m/s].
double explained_speed(const Scene& scene);
/// Ten times the speed that the scene explains; where water strikes an elastic plate (struck_plate.h) so many times, with
/// which a dam break on a wall of rubber keeps within the limits of its checks (docs/results/structures.md).
inline constexpr double sound_of_impact = 40;
double default_sound_speed(const Scene& scene);
/// Largest speed of a place in a tank that moves, seen from the earth [m/s]; 0 where it rests.
double fastest_wall(const Scene& scene);

}  // namespace tw
