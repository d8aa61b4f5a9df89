#include "app/commands/templates.h"

namespace tw::app {

const std::vector<Template>& templates() {
    static const std::vector<Template> all{
        {"planing", R"(title = "Prismatic planing hull at 8 m/s"

# Axes: x to the stern (the stream's direction), z up, still water at z = 0. Numbers are SI or texts with a unit.
[hull]
shape    = "prismatic"     # or: file = "my_hull.stl"
length   = "4 m"
beam     = "1 m"
deadrise = "20 deg"
trim     = "5 deg"         # bow up
draft    = "0.2 m"         # depth of the lowest point below still water
half     = true            # symmetric about y = 0: solve one half, report the whole

[motion]
kind  = "stream"           # the hull is fixed, the water comes at it
speed = "8 m/s"

[resolution]
near_hull = "0.0625 m"     # particles, and cells at the wetted hull; refine this first

[run]
duration = "1.2 s"
methods  = ["sph", "fvm"]
)"},
        {"seaplane", R"(title = "Stepped seaplane hull taxiing at 30 m/s"

[hull]
shape = "seaplane"         # a stand-in of 36.9 m length; the real lines are not public
trim  = "5 deg"
draft = "0.9 m"
half  = true

[water]
depth = "10 m"

[motion]
kind  = "stream"
speed = "30 m/s"

[resolution]
near_hull = "0.25 m"

[run]
duration = "3 s"
methods  = ["sph", "fvm"]
)"},
        {"tank", R"(title = "Water column collapsing in a tank"

[tank]
size = ["0.584 m", "0.02 m", "0.4 m"]     # length, width, height; the low corner is the origin

[domain]
dimensions = 2

[[water_block]]
min = [0, 0, 0]
max = ["0.146 m", "0.02 m", "0.292 m"]

[motion]
kind = "none"

[resolution]
near_hull = "5 mm"

[[probe]]
pressure = ["0.584 m", 0, "20 mm"]

[[probe]]
height = ["0.4 m", 0]

[run]
duration = "0.6 s"
)"},
        {"waves", R"(title = "Box that floats in regular waves"

# The wave is made in a zone at the tank's left end, 1.5 of its lengths wide, and absorbed over one length at the right.
[tank]
min = ["-4 m", 0, "-0.4 m"]    # still water is z = 0: 0.4 m of it
max = ["3 m", "10 mm", "0.3 m"]

[domain]
dimensions = 2

[wave]
height = "80 mm"               # from trough to crest
period = "1.2 s"               # or its length; twinwake check says the other, and how the wave is resolved

[[body]]
name     = "box"
shape    = "box"               # or: file = "my_body.stl"
length   = "0.3 m"
beam     = "1 m"
height   = "0.2 m"
position = [0, 0]
draft    = "0.1 m"
density  = "500 kg/m3"
locked   = ["surge"]           # heaves and pitches, does not drift

[[probe]]                      # two gauges or more tell what is reflected
name   = "before"
height = ["-0.9 m", 0]
[[probe]]
name   = "near"
height = ["-0.6 m", 0]

[motion]
kind = "none"

[resolution]
near_hull = "10 mm"            # at least four in the wave's height, six to ten keep it well
)"},
        {"body", R"(title = "Sphere dropped on water"

[tank]
min = ["-0.5 m", "-0.5 m", "-0.6 m"]    # still water is z = 0
max = ["0.5 m", "0.5 m", "0.5 m"]

[[body]]
name     = "ball"
shape    = "sphere"            # or: file = "my_body.stl"
diameter = "0.2 m"
draft    = "-20 mm"            # depth of its lowest point: it hangs above the water
density  = "500 kg/m3"
velocity = [0, 0, -2]          # m/s; free to move from there on

[motion]
kind = "none"

[resolution]
near_hull = "20 mm"

[run]
duration = "0.4 s"
)"},
        {"hull", R"(title = "My hull at 30 m/s"

[hull]
file  = "my_hull.stl"      # STL, OBJ, PLY, VTP, STEP or IGES, relative to this file; twinwake hull info shows what is wrong with it
unit  = "m"                # of the file: m, mm, cm, ft, in
axes  = "xyz"              # which file axis points to the stern, to starboard or port, and up; e.g. "-xyz" when x points to the bow
trim  = "5 deg"
draft = "0.5 m"
half  = false              # true when it is symmetric about y = 0: half the cost

[motion]
kind  = "stream"
speed = "30 m/s"

[resolution]
near_hull = "0.1 m"        # a tenth to a fortieth of the beam

[run]
methods = ["sph", "fvm"]

# Everything else - domain, refinement, sampling, duration - follows from the hull's size, draft and speed:
# twinwake check shows what was chosen.
)"},
    };
    return all;
}

}  // namespace tw::app
