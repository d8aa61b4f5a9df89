#pragma once
#include <string>
#include <vector>

#include "motion/wall_contact.h"
#include "scene/scene.h"

namespace tw {

/// A wall of the tank that a body may touch.
struct MetWall {
    std::string name;  ///< "the floor", "the wall at high x"
    WallPlane plane;
    int axis;  ///< across it
    bool high;
};

/// The walls with which the particle method solves a body's contact: of a free rigid body those of a tank, floor, lid and
/// sides; of any other body, and in a stream, whose sides and floor are where the solved water ends, none.
std::vector<MetWall> walls_met(const MovingBody& body, const Scene& scene);

/// How far a surface may be from a wall and stand on it [m]: a millionth of the tank, the rounding of surface files.
double touching(const Scene& scene);

/// Those of them that the body touches at the start.
std::vector<MetWall> walls_touched(const MovingBody& body, const Scene& scene);

}  // namespace tw
