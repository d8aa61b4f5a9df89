#include "scene/keys.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numbers>
#include <stdexcept>

#include "meshes/generate.h"
#include "methods/methods.h"
#include "scene/effects/registry.h"

namespace tw {
namespace {

using Kind = SceneKey::Kind;
using Hashed = SceneKey::Hashed;

constexpr double right_angle = std::numbers::pi / 2;
constexpr double fastest_sound = 1e5;  ///< [m/s]: a larger sound speed is refused as a mistake

std::vector<std::string> shape_names() {
    std::vector<std::string> names;
    for (const HullShape& shape : hull_shapes()) names.push_back(shape.name);
    return names;
}

// The table is read by its rows.
// clang-format off
using Rows = std::vector<SceneKey>;

/// What [[body]] and [tank] share: a prescribed motion of `who`, turns of which are about an axis `through` a point.
Rows motion_law_keys(const std::string& required, const std::string& who, const std::string& through) {
    return {
        {.name = "law", .kind = Kind::choice, .choices = {"constant", "ramp", "sinusoid", "table"},
         .hashed = Hashed::scene, .fallback = required,
         .meaning = "Path s(t) along `along` or about `about`: rate t; a rate that rises from 0 over `ramp`; amplitude (sin(2 pi t / period + phase) - sin(phase)), or with `ramp` amplitude sin(2 pi t / period + phase) about the place at the start, the amplitude rising from 0; a smooth curve through `times` and `values`."},
        {.name = "along", .kind = Kind::place3, .hashed = Hashed::scene, .fallback = "none",
         .meaning = "Direction of a prescribed motion."},
        {.name = "about", .kind = Kind::place3, .hashed = Hashed::scene, .fallback = "none",
         .meaning = "Axis of a prescribed rotation, through " + through + "."},
        {.name = "rate", .hashed = Hashed::scene, .fallback = "required of constant and ramp",
         .meaning = "Velocity along `along` [m/s], or about `about` [rad/s]."},
        {.name = "ramp", .unit = "s", .range = positive, .hashed = Hashed::scene, .fallback = "required of ramp",
         .meaning = "How long the rate rises, or the amplitude of a sinusoid."},
        {.name = "amplitude", .hashed = Hashed::scene, .fallback = "required of sinusoid",
         .meaning = "Amplitude along `along` [m], or about `about` [rad]."},
        {.name = "period", .unit = "s", .range = positive, .hashed = Hashed::scene, .fallback = "required of sinusoid",
         .meaning = "Period."},
        {.name = "phase", .unit = "rad", .hashed = Hashed::scene, .fallback = "0 deg",
         .meaning = "Phase at the start; 90 deg: from rest."},
        {.name = "times", .kind = Kind::list, .unit = "s", .hashed = Hashed::scene, .fallback = "required of table",
         .meaning = "Times of the table; they rise. " + who + " rests before the first and after the last."},
        {.name = "values", .kind = Kind::list, .hashed = Hashed::scene, .fallback = "required of table",
         .meaning = "Places along `along` [m], or angles about `about` [rad]."},
    };
}

/// What [hull], [[obstacle]] and [[body]] share.
Rows solid_keys() {
    return {
        {.name = "file", .kind = Kind::text, .hashed = Hashed::scene, .fallback = "none",
         .meaning = "Surface file: STL, OBJ, PLY or VTP, also compressed as .gz; relative to the scene file."},
        {.name = "shape", .kind = Kind::choice, .choices = shape_names(), .hashed = Hashed::scene,
         .fallback = "none",
         .meaning = "Parametric shape instead of a file; its parameters are further keys, see \"Shapes\"."},
        {.name = "unit", .kind = Kind::choice, .choices = {"m", "mm", "cm", "ft", "in"}, .hashed = Hashed::scene,
         .fallback = "m", .meaning = "Unit of length of the file."},
        {.name = "axes", .kind = Kind::text, .hashed = Hashed::scene, .fallback = "xyz",
         .meaning = "Which file axes point to the stern, sideways and up, e.g. \"-xyz\" when x points to the bow."},
    };
}

Rows hull_keys() {
    Rows rows = solid_keys();
    const Rows own{
        {.name = "trim", .unit = "rad", .range = {-right_angle, right_angle}, .hashed = Hashed::scene,
         .fallback = "0 deg", .meaning = "Trim angle, bow up positive."},
        {.name = "heel", .unit = "rad", .range = {-right_angle, right_angle}, .hashed = Hashed::scene,
         .fallback = "0 deg", .meaning = "Heel angle, starboard down positive."},
        {.name = "draft", .unit = "m", .hashed = Hashed::scene, .fallback = "a file keeps its own height",
         .meaning = "Depth of the lowest point of the posed hull below still water."},
        {.name = "position", .kind = Kind::place2, .unit = "m", .hashed = Hashed::scene, .fallback = "[0, 0]",
         .meaning = "Shift of the hull in x and y."},
        {.name = "half", .kind = Kind::flag, .hashed = Hashed::scene, .fallback = "false",
         .meaning = "The hull is symmetric about y = 0: the half at y > 0 is solved and the whole is reported."},
        {.name = "repair", .kind = Kind::flag, .hashed = Hashed::scene, .fallback = "false",
         .meaning = "Repair what can be repaired safely before the hull is used; every repair is reported."},
        {.name = "free", .kind = Kind::choices, .choices = {"heave", "pitch"}, .hashed = Hashed::scene,
         .fallback = "none: the hull is held",
         .meaning = "Motions in which a hull in a stream is free; `trim` and `draft` are then those at the start."},
        {.name = "mass", .unit = "kg", .range = positive, .hashed = Hashed::scene, .fallback = "required of a free hull",
         .meaning = "Mass of the whole hull, also of a half model; of a section per metre of span."},
        {.name = "lcg", .unit = "m", .hashed = Hashed::scene, .fallback = "required of a hull free in pitch",
         .meaning = "Centre of gravity ahead of the hull's aftmost point, along its own axis."},
        {.name = "vcg", .unit = "m", .hashed = Hashed::scene, .fallback = "required of a hull free in pitch",
         .meaning = "Centre of gravity above the hull's lowest point at zero trim."},
        {.name = "pitch_gyradius", .unit = "m", .range = positive, .hashed = Hashed::scene,
         .fallback = "a quarter of the hull's length",
         .meaning = "Radius of gyration in pitch, about the centre of gravity."},
        {.name = "release", .unit = "s", .range = not_negative, .hashed = Hashed::run, .fallback = "when the stream has its speed",
         .meaning = "The particle method holds a free hull until this time; the mesh method, whose stream has its speed at once, does not."},
    };
    rows.insert(rows.end(), own.begin(), own.end());
    return rows;
}

Rows water_keys() {
    return {
        {.name = "depth", .unit = "m", .range = positive, .hashed = Hashed::scene, .fallback = "deep",
         .meaning = "Depth of the water; the solved depth is smaller where the hull needs less."},
        {.name = "density", .unit = "kg/m3", .range = {1, 30000}, .hashed = Hashed::scene,
         .slot = slot(&Scene::water, &Water::density), .meaning = "Density of the water."},
        {.name = "viscosity", .unit = "m2/s", .range = {0, 1}, .hashed = Hashed::scene,
         .slot = slot(&Scene::water, &Water::kinematic_viscosity), .meaning = "Kinematic viscosity of the water."},
        {.name = "surface_tension", .unit = "N/m", .range = {0, 10}, .hashed = Hashed::scene,
         .slot = slot(&Scene::water, &Water::surface_tension), .meaning = "Surface tension between water and air."},
        {.name = "gravity", .unit = "m/s2", .range = {0, 1000, true}, .hashed = Hashed::scene,
         .slot = slot(&Scene::water, &Water::gravity), .meaning = "Gravitational acceleration, along -z.",
         .hint = "to leave gravity out write [effects] gravity = \"off\""},
        {.name = "air_density", .unit = "kg/m3", .range = {0, 100, true}, .hashed = Hashed::scene,
         .slot = slot(&Scene::water, &Water::air_density), .meaning = "Density of the air."},
        {.name = "air_viscosity", .unit = "m2/s", .range = {0, 1}, .hashed = Hashed::scene,
         .slot = slot(&Scene::water, &Water::air_kinematic_viscosity), .meaning = "Kinematic viscosity of the air."},
    };
}

Rows motion_keys() {
    return {
        {.name = "kind", .kind = Kind::choice, .choices = {"stream", "none"}, .hashed = Hashed::scene,
         .fallback = "stream with a hull, else none",
         .meaning = "A hull in a uniform stream, or still water (a tank)."},
        {.name = "speed", .unit = "m/s", .range = {0, 1000, true}, .hashed = Hashed::scene,
         .slot = slot(&Scene::motion, &Motion::speed), .fallback = "required in a stream",
         .meaning = "Speed of the stream, along +x.", .hint = "for still water write kind = \"none\""},
        {.name = "ramp", .unit = "s", .range = not_negative, .hashed = Hashed::run, .fallback = "0.3 L/U",
         .meaning = "Time over which the particle method starts the stream."},
    };
}

Rows resolution_keys() {
    return {
        {.name = "near_hull", .unit = "m", .range = positive, .hashed = Hashed::scene,
         .fallback = "the smaller of B/20 and D/4",
         .meaning = "Particle spacing, and size of the mesh cells at the wetted hull: the finest size."},
        {.name = "spacing", .unit = "m", .range = positive, .hashed = Hashed::scene,
         .fallback = "near_hull 2^n, at most L/12, n at most 4",
         .meaning = "Size of the largest cells, and of the particles farthest from solids as far as there is room for them; rounded to near_hull times a power of two."},
    };
}

Rows domain_keys() {
    const auto distance = [](const char* name, const char* fallback, const char* meaning) {
        return SceneKey{.name = name,
                        .unit = "m",
                        .range = positive,
                        .hashed = Hashed::scene,
                        .fallback = fallback,
                        .meaning = meaning};
    };
    const auto extent = [](const char* name, const char* meaning) {
        return SceneKey{.name = name,
                        .kind = Kind::pair,
                        .unit = "m",
                        .hashed = Hashed::scene,
                        .fallback = "from the distances",
                        .meaning = meaning};
    };
    return {
        distance("ahead", "0.6 L ahead of the keel's entry, at least 0.15 L; from Froude number 1 on, with particles of "
                 "several sizes, 0.4 L more", "Distance from the bow to the inlet."),
        distance("behind", "L", "Distance from the stern to the outlet."),
        distance("side", "2 B; below Froude number 1 at least L/2; above it, with particles of several sizes, so far that the sides change the lift by 0.5 %", "Distance from y = 0 to the sides."),
        distance("below",
                 "the larger of 1.6 B and 4 D (of a submerged body D and three of its heights); below Froude number 1 "
                 "also half a wavelength, at most L/2; above it, with particles of several sizes, so deep that the floor changes the lift by 0.5 %",
                 "Depth of the floor below still water."),
        distance("above", "the largest of L/2, L/4 above the deck and U^2/(8 g) (at most L)",
                 "Height of the top above still water."),
        extent("x", "Extent along the stream, instead of ahead and behind."),
        extent("y", "Extent across the stream, instead of side."),
        extent("z", "Extent in height, instead of below and above."),
        {.name = "dimensions", .kind = Kind::whole, .range = {2, 3}, .hashed = Hashed::scene, .fallback = "3",
         .meaning = "3, or 2 for the x-z plane: of a hull its section with y = 0; forces are then per metre of span."},
    };
}

Rows run_keys() {
    return {
        {.name = "duration", .unit = "s", .range = positive, .slot = slot(&Scene::run, &Run::duration),
         .fallback = "ramp + 3 L/U, below Froude number 1 at least ramp + 32 pi U/g, of a free hull five heaves more (check tells); 10 sqrt(H/g) in a tank "
                     "of water height H",
         .meaning = "Simulated time; a longer run of the same scene has the same hash."},
        {.name = "methods", .kind = Kind::choices, .choices = method_names(),
         .slot = slot(&Scene::run, &Run::methods),
         .meaning = "Which methods are run: particles (sph), OpenFOAM (fvm) or both."},
        {.name = "threads", .kind = Kind::whole, .range = {0, 4096}, .slot = slot(&Scene::run, &Run::threads),
         .meaning = "Threads of the particle method and ranks of the mesh method; 0: all cores."},
        {.name = "device", .kind = Kind::choice, .choices = {"cpu", "gpu", "auto"}, .slot = slot(&Scene::run, &Run::device),
         .meaning = "What makes the particles' steps: this processor, a GPU, or a GPU where there is one that can make "
                    "the scene's (check tells). Both give the same but for last digits."},
        {.name = "checkpoint", .unit = "s", .range = positive, .slot = slot(&Scene::run, &Run::checkpoint),
         .fallback = "a twentieth of the duration",
         .meaning = "Simulated time between saved states of the particle method."},
    };
}

Rows sampling_keys() {
    return {
        {.name = "interval", .unit = "s", .range = positive, .hashed = Hashed::scene,
         .slot = slot(&Scene::sampling, &Sampling::interval), .fallback = "L/U / 25; in a tank sqrt(H/g) / 25",
         .meaning = "Time between samples (frames of the water raster, energies, height probes); pressure probes "
                    "are sampled more often."},
        {.name = "mean_from", .unit = "s", .range = positive, .hashed = Hashed::scene,
         .slot = slot(&Scene::sampling, &Sampling::mean_from),
         .fallback = "ramp + L/U or 8 pi U/g, the longer, and two heaves of a free hull; 5 sqrt(H/g) for a hull in still water; none in a tank without a hull",
         .meaning = "Settled means do not begin before this time."},
        {.name = "snapshots", .unit = "s", .range = not_negative,
         .slot = slot(&Scene::sampling, &Sampling::snapshot_interval),
         .meaning = "Time between ParaView files; 0: none are written."},
        {.name = "raster_spacing", .unit = "m", .range = positive, .hashed = Hashed::scene,
         .fallback = "2 near_hull; near_hull in two dimensions",
         .meaning = "Edge of the voxels in which both methods count their water, for splash heights."},
        {.name = "cuts_x", .kind = Kind::list, .unit = "m", .hashed = Hashed::scene,
         .slot = slot(&Scene::sampling, &Sampling::cuts_x),
         .fallback = "where no cut is written: half a hull's length behind it",
         .meaning = "Planes x = const of surface profiles."},
        {.name = "cuts_y", .kind = Kind::list, .unit = "m", .hashed = Hashed::scene,
         .slot = slot(&Scene::sampling, &Sampling::cuts_y),
         .fallback = "where no cut is written: 3/4 of a hull's beam; the middle of a tank",
         .meaning = "Planes y = const of surface profiles."},
    };
}

Rows probe_keys() {
    return {
        {.name = "name", .kind = Kind::name, .hashed = Hashed::scene, .fallback = "P1, P2, ... or H1, H2, ...",
         .meaning = "Name of the probe's column in the record."},
        {.name = "pressure", .kind = Kind::place3, .unit = "m", .hashed = Hashed::scene, .fallback = "none",
         .meaning = "Place at which the pressure is recorded."},
        {.name = "height", .kind = Kind::place2, .unit = "m", .hashed = Hashed::scene, .fallback = "none",
         .meaning = "Place at which the height of the water is recorded."},
    };
}

Rows tank_keys() {
    Rows rows{
        {.name = "size", .kind = Kind::place3, .unit = "m", .hashed = Hashed::scene, .fallback = "from min and max",
         .meaning = "Length, width and height; the low corner is the origin."},
        {.name = "min", .kind = Kind::place3, .unit = "m", .hashed = Hashed::scene, .fallback = "from size",
         .meaning = "Low corner."},
        {.name = "max", .kind = Kind::place3, .unit = "m", .hashed = Hashed::scene, .fallback = "from size",
         .meaning = "High corner."},
        {.name = "pivot", .kind = Kind::place3, .unit = "m", .hashed = Hashed::scene, .fallback = "[0, 0, 0]",
         .meaning = "Point of the axis `about`, which stays in the earth while the tank turns."},
    };
    const Rows law = motion_law_keys("none: the tank rests", "The tank", "`pivot`");
    rows.insert(rows.end(), law.begin(), law.end());
    return rows;
}

Rows water_block_keys() {
    return {
        {.name = "min", .kind = Kind::place3, .unit = "m", .hashed = Hashed::scene, .fallback = "required",
         .meaning = "Low corner."},
        {.name = "max", .kind = Kind::place3, .unit = "m", .hashed = Hashed::scene, .fallback = "required",
         .meaning = "High corner."},
    };
}

Rows refine_keys() {
    return {
        {.name = "name", .kind = Kind::name, .fallback = "refine1, refine2, ...", .meaning = "Name in messages and meshes."},
        {.name = "around", .kind = Kind::choice, .choices = {"box", "wake", "free_surface", "spray_root"},
         .hashed = Hashed::scene, .fallback = "\"box\"",
         .meaning = "What is finer: a box; the wake behind the middle of the hull, half as wide again as it and down to "
                    "its draft; the still water's surface; or where jets leave the hull's bottom, between still water "
                    "and the height to which it rises on a wedge."},
        {.name = "min", .kind = Kind::place3, .unit = "m", .hashed = Hashed::scene, .fallback = "required of a box",
         .meaning = "Low corner of a box."},
        {.name = "max", .kind = Kind::place3, .unit = "m", .hashed = Hashed::scene, .fallback = "required of a box",
         .meaning = "High corner of a box."},
        {.name = "width", .unit = "m", .range = positive, .hashed = Hashed::scene, .fallback = "eight of its spacings",
         .meaning = "How far it reaches beyond what it is around; not of a box."},
        {.name = "length", .unit = "m", .range = positive, .hashed = Hashed::scene, .fallback = "to the outlet",
         .meaning = "Of a wake, behind the hull."},
        {.name = "spacing", .unit = "m", .range = positive, .hashed = Hashed::scene, .fallback = "near_hull",
         .meaning = "Largest particles and cells there: near_hull, the next smaller of its doubles, or down to an "
                    "eighth of it."},
    };
}

Rows obstacle_keys() {
    Rows rows = solid_keys();
    const Rows own{
        {.name = "name", .kind = Kind::name, .fallback = "obstacle1, obstacle2, ...",
         .meaning = "Name in messages."},
        {.name = "min", .kind = Kind::place3, .unit = "m", .hashed = Hashed::scene, .fallback = "none",
         .meaning = "Low corner of a box."},
        {.name = "max", .kind = Kind::place3, .unit = "m", .hashed = Hashed::scene, .fallback = "none",
         .meaning = "High corner of a box."},
        {.name = "position", .kind = Kind::place3, .unit = "m", .hashed = Hashed::scene, .fallback = "[0, 0, 0]",
         .meaning = "Shift of a surface from a file or a shape."},
    };
    rows.insert(rows.end(), own.begin(), own.end());
    return rows;
}

Rows body_keys() {
    Rows rows = solid_keys();
    const Rows own{
        {.name = "name", .kind = Kind::name, .hashed = Hashed::scene, .fallback = "body1, body2, ...",
         .meaning = "Name in messages and in the record."},
        {.name = "trim", .unit = "rad", .range = {-right_angle, right_angle}, .hashed = Hashed::scene,
         .fallback = "0 deg", .meaning = "Trim angle at the start, bow up positive: -75 deg with `speed` is an entry at 75 degrees, bow first."},
        {.name = "heel", .unit = "rad", .range = {-right_angle, right_angle}, .hashed = Hashed::scene,
         .fallback = "0 deg", .meaning = "Heel angle at the start, starboard down positive."},
        {.name = "draft", .unit = "m", .hashed = Hashed::scene, .fallback = "a file keeps its own height",
         .meaning = "Depth of the lowest point below still water at the start; negative: above it."},
        {.name = "position", .kind = Kind::place2, .unit = "m", .hashed = Hashed::scene, .fallback = "[0, 0]",
         .meaning = "Shift in x and y."},
        {.name = "density", .unit = "kg/m3", .range = positive, .hashed = Hashed::scene, .fallback = "from `mass`",
         .meaning = "Uniform density; mass, centre and inertia follow from the surface."},
        {.name = "mass", .unit = "kg", .range = positive, .hashed = Hashed::scene, .fallback = "from `density`",
         .meaning = "Mass; of a section per metre of span."},
        {.name = "centre", .kind = Kind::place3, .unit = "m", .hashed = Hashed::scene,
         .fallback = "that of the volume", .meaning = "Centre of mass, where the body stands at the start."},
        {.name = "inertia", .kind = Kind::place3, .unit = "kg m2", .hashed = Hashed::scene,
         .fallback = "of a uniform solid",
         .meaning = "Moments of inertia about the centre of mass and the shape's own x, y and z; of a section per metre."},
        {.name = "motion", .kind = Kind::choice, .choices = {"free", "prescribed"}, .hashed = Hashed::scene,
         .fallback = "free", .meaning = "Moved by water and weight, or as `law` says."},
        {.name = "locked", .kind = Kind::choices, .choices = {"surge", "sway", "heave", "roll", "pitch", "yaw"},
         .hashed = Hashed::scene, .fallback = "none",
         .meaning = "Motions along and about the earth's x, y and z that a free body does not make; in two dimensions sway, roll and yaw always."},
        {.name = "velocity", .kind = Kind::place3, .unit = "m/s", .hashed = Hashed::scene, .fallback = "[0, 0, 0]",
         .meaning = "Velocity of the centre of mass at the start, earth axes."},
        {.name = "speed", .unit = "m/s", .hashed = Hashed::scene, .fallback = "0",
         .meaning = "The same along the body's own axis, bow first, instead of `velocity`."},
        {.name = "spin", .kind = Kind::place3, .unit = "rad/s", .hashed = Hashed::scene, .fallback = "[0, 0, 0]",
         .meaning = "Angular velocity at the start, earth axes."},
    };
    const Rows law = motion_law_keys("required of a prescribed motion", "The body", "`centre`");
    const Rows plate{
        {.name = "elastic", .kind = Kind::choice, .choices = {"plate", "tyre"}, .hashed = Hashed::scene,
         .fallback = "none: the body is rigid",
         .meaning = "A rectangular plate that bends; of the keys above it has name, trim, density, mass (of plate and frame), locked (of the frame) and velocity. Or a tyre on a rigid rim, its axle along y, that meets the floor; of those above it has name, draft, position, density (of its rubber, 1100 kg/m3), mass (of tyre, rim and load), locked (of the rim, which never turns) and velocity."},
        {.name = "plate", .kind = Kind::place2, .unit = "m", .hashed = Hashed::scene, .fallback = "required of a plate",
         .meaning = "Length along its own x and breadth along its own y; in two dimensions the breadth has no effect."},
        {.name = "mesh", .kind = Kind::text, .hashed = Hashed::scene, .fallback = "the rectangle of `plate` and `cells`",
         .meaning = "File with the mid-surface of an elastic plate as quadrilaterals: .inp (Abaqus, CalculiX), .msh (Gmsh, ASCII) or .vtu (VTK), relative to the scene file, in `unit`; shifted by `middle`."},
        {.name = "cells", .kind = Kind::place2, .hashed = Hashed::scene, .fallback = "required of a plate; of a tyre [48, 20]",
         .meaning = "Elements along and across, or around and from bead to bead; in two dimensions one across, whatever stands here."},
        {.name = "middle", .kind = Kind::place3, .unit = "m", .hashed = Hashed::scene, .fallback = "[0, 0, 0]",
         .meaning = "Middle of the plate's mid-surface; its normal is z, turned by trim."},
        {.name = "thickness", .unit = "m", .range = positive, .hashed = Hashed::scene, .fallback = "from `layup`",
         .meaning = "Thickness of an isotropic plate."},
        {.name = "youngs_modulus", .unit = "Pa", .range = positive, .hashed = Hashed::scene, .fallback = "from `layup`",
         .meaning = "Young's modulus of an isotropic plate."},
        {.name = "poisson", .range = {-1, 0.5}, .hashed = Hashed::scene, .fallback = "from `layup`",
         .meaning = "Poisson's ratio of an isotropic plate."},
        {.name = "layup", .kind = Kind::text, .hashed = Hashed::scene, .fallback = "an isotropic plate",
         .meaning = "Stacking sequence, bottom first, as \"[45 C1/0 2*C2/90 C2]s\" with plies of the [[ply]] sections."},
        {.name = "clamped", .kind = Kind::choices, .hashed = Hashed::scene, .fallback = "none",
         .meaning = "Edges that neither move nor turn: x_min, x_max, y_min, y_max; of a mesh its node sets."},
        {.name = "hinged", .kind = Kind::choices, .hashed = Hashed::scene, .fallback = "none",
         .meaning = "Edges that do not move: x_min, x_max, y_min, y_max; of a mesh its node sets."},
        {.name = "carried", .kind = Kind::choices, .hashed = Hashed::scene, .fallback = "none",
         .meaning = "Edges clamped in a rigid frame, which moves: x_min, x_max, y_min, y_max; of a mesh its node sets."},
        {.name = "skin", .unit = "m", .range = positive, .hashed = Hashed::scene,
         .fallback = "6 near_hull, or the plate's thickness if larger",
         .meaning = "Thickness of the surface that the water sees, about the plate's middle."},
        {.name = "margin", .unit = "m", .range = not_negative, .hashed = Hashed::scene, .fallback = "4 near_hull",
         .meaning = "How far the plate goes on, held, beyond clamped edges: a wall there needs it for its particles."},
        {.name = "rotations", .kind = Kind::choice, .choices = {"large", "small"}, .hashed = Hashed::scene,
         .fallback = "large", .meaning = "Small: a linear plate, for deflections up to half a thickness."},
        {.name = "coupling", .kind = Kind::choice, .choices = {"pressure", "penalty", "background"},
         .hashed = Hashed::scene, .fallback = "pressure",
         .meaning = "Coupling of an elastic body with the particles: by the pressure of dummies, as for rigid walls; by penalty contact; or by its nodes as background particles."},
        {.name = "contact", .kind = Kind::choice, .choices = {"linear", "nonlinear", "adaptive"},
         .hashed = Hashed::scene, .fallback = "linear",
         .meaning = "How a penalty contact stiffens with its depth."},
        {.name = "contact_factor", .range = positive, .hashed = Hashed::scene, .fallback = "0.01",
         .meaning = "Stiffness of a penalty contact over that of a cube of real water with the particles' spacing."},
        {.name = "coupling_iterations", .kind = Kind::whole, .range = {1, 50}, .hashed = Hashed::scene, .fallback = "1",
         .meaning = "Coupling iterations of water and plate in each step; more than one repeats the sweep of the forces."},
        {.name = "damping", .unit = "Hz", .range = not_negative, .hashed = Hashed::scene, .fallback = "0 Hz",
         .meaning = "Rate c of a structural damping -c M v."},
        {.name = "structure_step", .unit = "s", .range = positive, .hashed = Hashed::scene,
         .fallback = "the water's", .meaning = "Longest time step of body and water."},
        {.name = "tyre", .kind = Kind::place3, .unit = "m", .hashed = Hashed::scene,
         .fallback = "[\"250 mm\", \"95 mm\", \"80 mm\"]",
         .meaning = "Outer diameter, diameter of the rim and width of a tyre, before it is inflated."},
        {.name = "walls", .kind = Kind::place3, .unit = "m", .hashed = Hashed::scene,
         .fallback = "[\"10 mm\", \"6 mm\", \"2 mm\"]",
         .meaning = "Thickness of a tyre's tread, side walls and inner tyre, which lies within both."},
        {.name = "tread", .kind = Kind::place3, .unit = "Pa", .hashed = Hashed::scene,
         .fallback = "calibrated, see docs/results/tyre.md",
         .meaning = "Mooney-Rivlin constants C10 and C01 and the bulk modulus of a tyre's tread."},
        {.name = "sidewall", .kind = Kind::place3, .unit = "Pa", .hashed = Hashed::scene,
         .fallback = "calibrated, see docs/results/tyre.md", .meaning = "The same of its side walls."},
        {.name = "inner_tyre", .kind = Kind::place3, .unit = "Pa", .hashed = Hashed::scene,
         .fallback = "assumed, see docs/results/tyre.md", .meaning = "The same of its inner tyre."},
        {.name = "pressure", .unit = "Pa", .range = not_negative, .hashed = Hashed::scene, .fallback = "0.138 MPa",
         .meaning = "Pressure in a tyre above that of the air; it follows the rubber."},
        {.name = "drop_height", .unit = "m", .range = not_negative, .hashed = Hashed::scene, .fallback = "from `velocity`",
         .meaning = "Height from which a tyre has fallen when the run starts, instead of `velocity`."},
        {.name = "contact_depth", .unit = "m", .range = positive, .hashed = Hashed::scene, .fallback = "0.1 mm",
         .meaning = "How deep 1 MPa presses a tyre's rubber into the rigid floor: the stiffness of the contact."},
    };
    for (const Rows& more : {own, law, plate}) rows.insert(rows.end(), more.begin(), more.end());
    return rows;
}

Rows ply_keys() {
    return {
        {.name = "name", .kind = Kind::name, .fallback = "required", .meaning = "Name in layups."},
        {.name = "thickness", .unit = "m", .range = positive, .hashed = Hashed::scene, .fallback = "required",
         .meaning = "Thickness."},
        {.name = "E1", .unit = "Pa", .range = positive, .hashed = Hashed::scene, .fallback = "required",
         .meaning = "Young's modulus along the fibres."},
        {.name = "E2", .unit = "Pa", .range = positive, .hashed = Hashed::scene, .fallback = "required",
         .meaning = "Young's modulus across them."},
        {.name = "nu12", .hashed = Hashed::scene, .fallback = "required", .meaning = "Larger Poisson's ratio."},
        {.name = "G12", .unit = "Pa", .range = positive, .hashed = Hashed::scene, .fallback = "required",
         .meaning = "Shear modulus in the plane."},
        {.name = "G13", .unit = "Pa", .range = positive, .hashed = Hashed::scene, .fallback = "G12",
         .meaning = "Shear modulus across the thickness, along the fibres."},
        {.name = "G23", .unit = "Pa", .range = positive, .hashed = Hashed::scene, .fallback = "G12",
         .meaning = "Shear modulus across the thickness, across the fibres."},
        {.name = "density", .unit = "kg/m3", .range = positive, .hashed = Hashed::scene, .fallback = "required",
         .meaning = "Density."},
    };
}

Rows gauge_keys() {
    return {
        {.name = "name", .kind = Kind::name, .hashed = Hashed::scene, .fallback = "gauge1, gauge2, ...",
         .meaning = "Name of its columns in the body's table of the record."},
        {.name = "body", .kind = Kind::text, .fallback = "the only elastic body", .meaning = "The body it belongs to."},
        {.name = "position", .kind = Kind::place3, .unit = "m", .hashed = Hashed::scene, .fallback = "required",
         .meaning = "Place on the plate's mid-surface at the start."},
        {.name = "direction", .kind = Kind::place3, .hashed = Hashed::scene, .fallback = "the displacement is recorded",
         .meaning = "Direction of a strain gauge."},
        {.name = "face", .kind = Kind::choice, .choices = {"top", "bottom"}, .hashed = Hashed::scene,
         .fallback = "top", .meaning = "Face of a strain gauge; the plate's normal points out of the top."},
    };
}

Rows sph_keys() {
    return {
        {.name = "h_over_dp", .range = {1.1, 3}, .hashed = Hashed::run,
         .slot = slot(&Scene::sph, &SphOptions::h_over_dp), .meaning = "Smoothing length over particle spacing."},
        {.name = "c0", .unit = "m/s", .range = {0, fastest_sound, true}, .hashed = Hashed::run,
         .slot = slot(&Scene::sph, &SphOptions::c0), .fallback = "10 times the larger of U and sqrt(2 g H)",
         .meaning = "Numerical sound speed; the density error grows with (speed/c0)^2, the run time with c0."},
        {.name = "delta", .range = {0, 1}, .hashed = Hashed::run, .slot = slot(&Scene::sph, &SphOptions::delta),
         .meaning = "Coefficient of the density diffusion."},
        {.name = "alpha", .range = {0, 1}, .hashed = Hashed::run, .slot = slot(&Scene::sph, &SphOptions::alpha),
         .meaning = "Coefficient of the artificial viscosity."},
        {.name = "scheme", .kind = Kind::choice,
         .choices = {"symplectic_euler", "kick_drift_kick", "predictor_corrector", "rk4_frozen_diffusion"},
         .hashed = Hashed::run, .slot = slot(&Scene::sph, &SphOptions::scheme), .meaning = "Time stepping scheme."},
        {.name = "cfl", .range = {0, 1, true}, .hashed = Hashed::run, .slot = slot(&Scene::sph, &SphOptions::cfl),
         .meaning = "Acoustic Courant number: the time step is cfl h / (c0 + speed)."},
        {.name = "equation_of_state", .kind = Kind::choice, .choices = {"linear", "tait", "mie_grueneisen"},
         .hashed = Hashed::run, .slot = slot(&Scene::sph, &SphOptions::equation_of_state),
         .meaning = "Pressure as a function of density."},
        {.name = "gamma", .range = {1, 20}, .hashed = Hashed::run, .slot = slot(&Scene::sph, &SphOptions::gamma),
         .meaning = "Exponent of the Tait equation of state."},
        {.name = "levels", .kind = Kind::whole, .range = {1, most_levels}, .hashed = Hashed::run,
         .slot = slot(&Scene::sph, &SphOptions::levels),
         .fallback = "up to spacing, where that is written, and round a hull held in a stream from Froude number 1 on; else 1",
         .meaning = "Sizes of particles: near_hull round hull, obstacles and moving bodies, twice that farther away, and so on.",
         .later = true},
        {.name = "zone", .range = {8, 200}, .hashed = Hashed::run, .slot = slot(&Scene::sph, &SphOptions::zone),
         .meaning = "With several levels: how far the finest particles reach from the bounding boxes of hull, obstacles and bodies, in their spacings.",
         .later = true},
        {.name = "wake", .kind = Kind::whole, .range = {0, 32}, .hashed = Hashed::run,
         .slot = slot(&Scene::sph, &SphOptions::wake),
         .fallback = "2 where sizes follow from spacing or the hull's speed; 0 where levels are written",
         .meaning = "With several levels and a hull in a stream: largest particles in its wake, over near_hull (1, 2, 4, ...; others are rounded down to these), where `[[refine]] around = \"wake\"` would have them; 0: none of its own.",
         .later = true},
        {.name = "touch_support", .range = {0.5, 0.999}, .hashed = Hashed::run,
         .slot = slot(&Scene::sph, &SphOptions::touch_support),
         .meaning = "Fullness of the kernel's half towards a wall from which on the approaching wall compresses the water."},
        {.name = "gate_point", .kind = Kind::list, .unit = "m", .hashed = Hashed::run,
         .slot = slot(&Scene::sph, &SphOptions::gate_point),
         .meaning = "With gate_normal: a plane beyond which detached water is taken out of the run at every frame, as droplets for `twinwake spray`. Three dimensions.",
         .later = true},
        {.name = "gate_normal", .kind = Kind::list, .hashed = Hashed::run,
         .slot = slot(&Scene::sph, &SphOptions::gate_normal), .meaning = "Direction from the plane to what lies beyond it.", .later = true},
        {.name = "gate_link", .range = {1, 10}, .hashed = Hashed::run,
         .slot = slot(&Scene::sph, &SphOptions::gate_link),
         .meaning = "Distance up to which particles count as connected at the gate, in spacings.", .later = true},
    };
}

Rows fvm_keys() {
    return {
        {.name = "max_courant", .range = {0, 20, true}, .hashed = Hashed::run,
         .slot = slot(&Scene::fvm, &FvmOptions::max_courant), .fallback = "4 in a stream, else 1",
         .meaning = "Largest Courant number of the flow."},
        {.name = "max_alpha_courant", .range = {0, 20, true}, .hashed = Hashed::run,
         .slot = slot(&Scene::fvm, &FvmOptions::max_alpha_courant),
         .fallback = "4 in a stream (2 with isoadvector), 0.5 with a body that moves, else 1",
         .meaning = "Largest Courant number at the water surface."},
        {.name = "interface_compression", .range = {0, 4}, .hashed = Hashed::run,
         .slot = slot(&Scene::fvm, &FvmOptions::interface_compression),
         .meaning = "cAlpha, which keeps the water surface sharp."},
        {.name = "interface", .kind = Kind::choice, .choices = {"mules", "isoadvector"}, .hashed = Hashed::run,
         .slot = slot(&Scene::fvm, &FvmOptions::interface),
         .meaning = "How the water surface is captured: by interFoam's limited fluxes, or geometrically by interIsoFoam, which is sharper and takes several times as long.",
         .later = true},
        {.name = "correctors", .kind = Kind::whole, .range = {1, 10}, .hashed = Hashed::run,
         .slot = slot(&Scene::fvm, &FvmOptions::correctors), .meaning = "Pressure correctors in each time step."},
        {.name = "body_mesh", .kind = Kind::choice, .choices = {"auto", "morphing", "whole"}, .hashed = Hashed::run,
         .slot = slot(&Scene::fvm, &FvmOptions::body_mesh),
         .meaning = "How the mesh follows a body that moves: morphed between body and walls, or moving as a whole.",
         .later = true},
        {.name = "openfoam", .kind = Kind::text, .slot = slot(&Scene::fvm, &FvmOptions::openfoam),
         .fallback = "found", .meaning = "Folder of an OpenFOAM installation."},
    };
}
// clang-format on

Rows effect_keys() {
    Rows rows;
    for (const EffectPart& part : effects())
        rows.push_back({.name = part.name,
                        .kind = Kind::on_off,
                        .hashed = Hashed::scene,
                        .fallback = "auto",
                        .meaning = part.meaning});
    return rows;
}

std::vector<SceneKey> all_keys() {
    const std::pair<const char*, Rows> sections[] = {
        {"",
         {{.name = "title", .kind = Kind::text, .fallback = "name of the file", .meaning = "Title of the reports."}}},
        {"hull", hull_keys()},
        {"water", water_keys()},
        {"motion", motion_keys()},
        {"resolution", resolution_keys()},
        {"domain", domain_keys()},
        {"run", run_keys()},
        {"sampling", sampling_keys()},
        {"probe", probe_keys()},
        {"tank", tank_keys()},
        {"water_block", water_block_keys()},
        {"refine", refine_keys()},
        {"obstacle", obstacle_keys()},
        {"body", body_keys()},
        {"ply", ply_keys()},
        {"gauge", gauge_keys()},
        {"effects", effect_keys()},
        {"sph", sph_keys()},
        {"fvm", fvm_keys()}};
    std::vector<SceneKey> keys;
    for (const auto& [section, rows] : sections) {
        for (SceneKey key : rows) {
            key.section = section;
            keys.push_back(std::move(key));
        }
        for (const EffectPart& part : effects())
            for (SceneKey key : part.keys)
                if (key.section == section) {
                    key.effect = part.name;
                    keys.push_back(std::move(key));
                }
    }
    return keys;
}

}  // namespace

const std::vector<SectionRow>& scene_sections() {
    static const std::vector<SectionRow> sections{
        {"", false, "Above the first section."},
        {"hull", false, "The hull as it stands in the water. Without this section the scene has no hull."},
        {"water", false, "Water, air and gravity."},
        {"motion", false, "How hull and water move against each other."},
        {"resolution", false, "Sizes of particles and cells."},
        {"domain", false, "Extent of what is solved, around the hull or, in a channel, by itself."},
        {"run", false, "How long and how the scene is run."},
        {"sampling", false, "What is recorded, and when."},
        {"probe", true, "A place at which pressure or height is recorded; exactly one of the two is given."},
        {"tank", false,
         "A tank instead of a domain: walls all around, open above. With `law` it moves, and all places and velocities "
         "are in its own axes."},
        {"water_block", true, "A box of water in a tank; without any, all below z = 0 is water."},
        {"refine", true,
         "A place to be resolved finer than what lies round it, in both methods: cells are halved there, and finer "
         "particles stand there where those round it are coarser. With a hull in a stream; of a section, by particles "
         "alone."},
        {"obstacle", true, "A fixed closed solid: a box (min and max), a file or a shape."},
        {"body", true,
         "A closed solid that moves in a tank or a stream, freely or as prescribed, or an elastic plate; the mesh "
         "method moves rigid ones."},
        {"ply", true, "A layer of a laminate, for the layups of elastic bodies."},
        {"gauge", true, "A place on an elastic body at which its displacement or a strain is recorded."},
        {"effects", false,
         "Physical effects: \"auto\" (the plan decides), \"on\" or \"off\". `--effect NAME=on` on the command line "
         "takes "
         "precedence."},
        {"sph", false, "Numerics of the particle method."},
        {"fvm", false, "Numerics of the mesh method (interFoam)."},
    };
    return sections;
}

const std::vector<SceneKey>& scene_keys() {
    static const std::vector<SceneKey> keys = all_keys();
    return keys;
}

const SceneKey& scene_key(std::string_view section, std::string_view name) {
    for (const SceneKey& key : scene_keys())
        if (key.section == section && key.name == name) return key;
    throw std::logic_error(fmt::format("no key [{}] {} in the table", section, name));
}

std::string fallback_text(const SceneKey& key) {
    if (!key.fallback.empty()) return key.fallback;
    Scene unsaid;
    std::string text;
    with_value(key, unsaid, [&](const auto& value) {
        using Value = std::decay_t<decltype(value)>;
        if constexpr (std::is_same_v<Value, double>)
            text = value_text(value, key.unit);
        else if constexpr (std::is_same_v<Value, int> || std::is_same_v<Value, std::string>)
            text = fmt::format("{}", value);
        else
            text = value.empty() ? "none" : fmt::format("{}", fmt::join(value, ", "));
    });
    if (text.empty()) throw std::logic_error(fmt::format("[{}] {}: no default in the table", key.section, key.name));
    return text;
}

}  // namespace tw
