#pragma once
#include <string>

#include "scene/scene.h"

namespace tw::app {

/// What would be solved, as pictures: side and plan view with hull, still water, domain, forcing zones and the sizes of
/// particles and cells; an <svg> element.
std::string scene_picture(const Scene& scene);

/// The page of a scene that has not been run: what to look at first, the picture, the effects, and all that `check`
/// says, which is `text`.
std::string check_page(const Scene& scene, const std::string& text);

}  // namespace tw::app
