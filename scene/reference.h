#pragma once
#include <string>

namespace tw {

/// Every section, key, effect and shape of a scene file as Markdown, made from the tables (keys.h, effects/registry.h,
/// meshes/generate.h). docs/scene_reference.md is this text; a test holds the two together.
std::string scene_reference();

}  // namespace tw
