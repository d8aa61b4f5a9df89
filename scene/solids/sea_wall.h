#pragma once
#include <optional>

#include "scene/scene.h"

namespace tw {

/// What a wave meets: an obstacle that closes the tank from its floor to above still water.
struct SeaWall {
    double freeboard = 0;  ///< of the crest above still water, z = 0 [m]
    double cot_slope = 0;  ///< cotangent of the seaward face between still water and crest: 0 vertical [-]
    double depth = 0;      ///< of the water before it [m]
    bool plane = false;    ///< the face has this slope down to the floor
};

/// Nothing where the crest is below still water, where water passes under it or at its side, or where its face hangs
/// over.
std::optional<SeaWall> sea_wall_of(const Scene& scene, const Obstacle& obstacle);

/// What a wave has to come over before it reaches a box of water ([[volume]]): the highest obstacle whose seaward face
/// lies before the box, if it is such a wall; else what comes into the box is no overtopping, or not that of a wall.
std::optional<SeaWall> sea_wall_before(const Scene& scene, const Box& box);

}  // namespace tw
