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
        {"own", R"(title = "My hull at 30 m/s"

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
