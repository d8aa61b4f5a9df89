// Rows of what stands in the water: hull, tank, obstacles, bodies, and what elastic ones are made of.
#include <numbers>

#include "meshes/generate.h"
#include "scene/keys/key_rows.h"

namespace tw {
namespace {

using Rows = std::vector<SceneKey>;
using Kind = SceneKey::Kind;
using Hashed = SceneKey::Hashed;

constexpr double right_angle = std::numbers::pi / 2;

std::vector<std::string> shape_names() {
    std::vector<std::string> names;
    for (const HullShape& shape : hull_shapes()) names.push_back(shape.name);
    return names;
}

// The table is read by its rows.
// clang-format off
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
         .meaning = "Times of the table; they rise. " + who + " rests before the first. After the last it rests too where the rows come to rest, else it keeps their last velocity."},
        {.name = "values", .kind = Kind::list, .hashed = Hashed::scene, .fallback = "required of table",
         .meaning = "Places along `along` [m], or angles about `about` [rad]."},
    };
}

/// What [hull], [[obstacle]] and [[body]] share.
Rows solid_keys() {
    return {
        {.name = "file", .kind = Kind::text, .hashed = Hashed::scene, .fallback = "none",
         .meaning = "Surface file: STL, OBJ, PLY, VTP, STEP or IGES, also compressed as .gz; relative to the scene file. \"boat.step#keel\" takes the solid that a STEP, OBJ or ascii STL file calls keel."},
        {.name = "shape", .kind = Kind::choice, .choices = shape_names(), .hashed = Hashed::scene,
         .fallback = "none",
         .meaning = "Parametric shape instead of a file; its parameters are further keys, see \"Shapes\"."},
        {.name = "unit", .kind = Kind::choice, .choices = {"m", "mm", "cm", "ft", "in"}, .hashed = Hashed::scene,
         .fallback = "m", .meaning = "Unit of length of the file."},
        {.name = "axes", .kind = Kind::text, .hashed = Hashed::scene, .fallback = "xyz",
         .meaning = "Which axes of the file or shape point to the stern, sideways and up, e.g. \"-xyz\" when x points to the bow."},
    };
}

}  // namespace

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
         .meaning = "A free hull is held until this time; in the mesh method, whose stream has its speed at once, where the library for it is built."},
    };
    rows.insert(rows.end(), own.begin(), own.end());
    return rows;
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

Rows obstacle_keys() {
    Rows rows = solid_keys();
    const Rows own{
        {.name = "name", .kind = Kind::name, .hashed = Hashed::scene, .fallback = "obstacle1, obstacle2, ...",
         .meaning = "Name in messages and in the record."},
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
        {.name = "filter", .unit = "s", .range = positive, .hashed = Hashed::scene,
         .slot = entry_slot(&Scene::bodies, &MovingBody::filter), .fallback = "5 ms",
         .meaning = "Time over which the largest force is a mean, as the measurement it is compared with was filtered.", .later = true},
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
        {.name = "friction", .range = not_negative, .hashed = Hashed::scene,
         .slot = entry_slot(&Scene::bodies, &MovingBody::friction),
         .meaning = "Coulomb's coefficient between a free body and the floor and sides of its tank, on which it may stand or come to rest.", .later = true},
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
        {.name = "poisson", .range = {-1, 0.5, true}, .hashed = Hashed::scene, .fallback = "from `layup`",
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
         .meaning = "Coupling iterations of water and plate in each step; more than one repeats the pair loop of the forces (coupling sub-iterations)."},
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
// clang-format on

}  // namespace tw
