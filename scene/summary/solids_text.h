#pragma once
#include <string>

#include "scene/scene.h"

namespace tw {

// The hull and the bodies of a scene in sentences, for `check`: lines that end in a newline, lengths in m.

std::string hull_text(const Hull& hull);
/// Where it is, its mass and how it moves; of an elastic one its structure.
std::string body_text(const MovingBody& body, const Scene& scene);
/// A prescribed motion.
std::string law_text(const MotionLaw& law);
/// "(x, y, z)" [m].
std::string place_text(const Vec3& p);

}  // namespace tw
