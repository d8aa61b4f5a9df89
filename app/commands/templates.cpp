#include "app/commands/templates.h"

namespace tw::app {

const std::vector<Template>& templates() {
    static const std::vector<Template> all{
        {"hull", "your own hull, from a file, in a stream", R"(title = "My hull at 30 m/s"

# Axes: x to the stern (the stream's direction), z up, still water at z = 0. Numbers are SI or texts with a unit.
[hull]
file  = "my_hull.stl"      # STL, OBJ, PLY, VTP, STEP or IGES, relative to this file; twinwake hull info says what it holds
unit  = "m"                # of the file: m, mm, cm, ft, in (STEP and IGES say their own)
axes  = "xyz"              # which file axis points to the stern, to one side, and up; "-x-yz" when x points to the bow
trim  = "5 deg"            # bow up
draft = "0.5 m"            # depth of the lowest point below still water
half  = false              # true when it is symmetric about y = 0: half the cost, results for the whole hull

[motion]
kind  = "stream"           # the hull is held, the water comes at it
speed = "30 m/s"

# [water]
# depth = "10 m"           # a bed at this depth; without it the water is deep

[resolution]
near_hull = "0.1 m"        # particles, and cells at the wetted hull: a tenth to a fortieth of the wetted beam

[run]
methods = ["sph", "fvm"]   # particles, interFoam; without a duration a run ends when its loads have settled

# Everything else - domain, refinement, sampling, duration - follows from the hull's size, draft and speed:
# twinwake check shows what was chosen, and check --html draws it. All keys: twinwake reference.
)"},
        {"planing", "a prismatic planing hull in a stream", R"(title = "Prismatic planing hull at 8 m/s"

# Axes: x to the stern (the stream's direction), z up, still water at z = 0. Numbers are SI or texts with a unit.
[hull]
shape    = "prismatic"     # or: file = "my_hull.stl"; twinwake hull make lists the shapes and their numbers
length   = "4 m"
beam     = "1 m"
deadrise = "20 deg"
trim     = "5 deg"         # bow up
draft    = "0.2 m"         # depth of the lowest point below still water
half     = true            # symmetric about y = 0: solve one half, report the whole

[motion]
kind  = "stream"           # the hull is held, the water comes at it
speed = "8 m/s"

[resolution]
near_hull = "0.0625 m"     # particles, and cells at the wetted hull; refine this first

[run]
duration = "2 s"           # without it a run ends when its loads have settled
methods  = ["sph", "fvm"]  # particles, interFoam

# To compare with a measurement, name it, with its source; the report draws it beside both methods:
# [[measured]]
# quantity    = "lift"
# value       = "6100 N"
# uncertainty = "4 %"
# source      = "who measured it, where"
)"},
        {"seaplane", "a stepped seaplane hull in a stream", R"(title = "Stepped seaplane hull taxiing at 30 m/s"

# Axes: x to the stern (the stream's direction), z up, still water at z = 0. Numbers are SI or texts with a unit.
[hull]
shape = "seaplane"         # a stand-in of 36.9 m length; the real lines are not public
trim  = "5 deg"            # bow up
draft = "0.9 m"            # depth of the lowest point below still water
half  = true               # symmetric about y = 0: solve one half, report the whole

[water]
depth = "10 m"             # a bed at this depth; without it the water is deep

[motion]
kind  = "stream"           # the hull is held, the water comes at it
speed = "30 m/s"

[resolution]
near_hull = "0.25 m"       # particles, and cells at the wetted hull; the jet of spray needs a fifth of this

[run]
duration = "3 s"           # without it a run ends when its loads have settled
methods  = ["sph", "fvm"]  # particles, interFoam
)"},
        {"tank", "a column of water that collapses in a tank", R"(title = "Water column collapsing in a tank"

# Axes: x to the right, z up. Numbers are SI or texts with a unit.
[tank]
size = ["0.584 m", "0.02 m", "0.4 m"]     # length, width, height; the low corner is the origin

[domain]
dimensions = 2             # the x-z plane: the width above counts for nothing, forces are per metre of it

[[water_block]]            # the water at the start, at rest; [[obstacle]] puts solids into the tank
min = [0, 0, 0]
max = ["0.146 m", "0.02 m", "0.292 m"]

[motion]
kind = "none"              # nothing streams

[sph]
c0 = "60 m/s"              # particles: water that strikes a wall at U is compressed by U/c0; 2.3 m/s here, limit 5 %

[resolution]
near_hull = "5 mm"         # of particles and cells, here the same everywhere: 29 of them in the column's width

[[probe]]                  # pressure at a place: 20 mm above the floor, on the wall that the water strikes
pressure = ["0.584 m", 0, "20 mm"]

[[probe]]                  # height of the water at a place
height = ["0.4 m", 0]

[run]
duration = "0.6 s"         # the front strikes the wall at about 0.28 s
methods  = ["sph", "fvm"]  # particles, interFoam
)"},
        {"waves", "a box afloat in regular waves", R"(title = "Box that floats in regular waves"

# Axes: x to the right, z up, still water at z = 0. Numbers are SI or texts with a unit.
# The wave is made in a zone at the tank's left end, 1.5 of its lengths wide, and absorbed over one length at the right.
[tank]
min = ["-4 m", 0, "-0.4 m"]    # still water is z = 0: 0.4 m of it
max = ["3 m", "10 mm", "0.3 m"]

[domain]
dimensions = 2                 # the x-z plane; forces and masses are per metre of the width across

[wave]
height = "80 mm"               # from trough to crest
period = "1.2 s"               # or its length; twinwake check says the other, and how the wave is resolved

[[body]]                       # one section for each body
name     = "box"
shape    = "box"               # or: file = "my_body.stl"
length   = "0.3 m"
beam     = "1 m"
height   = "0.2 m"
position = [0, 0]
draft    = "0.1 m"             # depth of its lowest point below still water
density  = "500 kg/m3"         # or its mass
locked   = ["surge"]           # heaves and pitches, does not drift

[[probe]]                      # two gauges or more tell what is reflected
name   = "before"
height = ["-0.9 m", 0]
[[probe]]
name   = "near"
height = ["-0.6 m", 0]

[motion]
kind = "none"                  # nothing streams

[resolution]
near_hull = "10 mm"            # at least four in the wave's height, six to ten keep it well
)"},
        {"body", "a sphere dropped on water", R"(title = "Sphere dropped on water"

# Axes: x to the right, z up, still water at z = 0. Numbers are SI or texts with a unit.
[tank]
min = ["-0.5 m", "-0.5 m", "-0.6 m"]    # still water is z = 0: 0.6 m of it
max = ["0.5 m", "0.5 m", "0.5 m"]

[[body]]                       # one section for each body; twinwake new body FILE --from CAD_FILE writes them of yours
name     = "ball"
shape    = "sphere"            # or: file = "my_body.stl"
diameter = "0.2 m"
draft    = "-20 mm"            # depth of its lowest point: it hangs above the water
density  = "500 kg/m3"         # or its mass
velocity = [0, 0, -2]          # m/s at the start; free to move from there on, but for what `locked` names

[motion]
kind = "none"                  # nothing streams

[sph]
c0 = "60 m/s"                  # particles: water that is struck at U is compressed by U/c0; 2.1 m/s here, limit 5 %

[resolution]
near_hull = "20 mm"            # of particles and cells: ten in the diameter; twice as many for its motion

[run]
duration = "0.4 s"
methods  = ["sph", "fvm"]      # particles, interFoam
)"},
    };
    return all;
}

}  // namespace tw::app
