#pragma once
#include <string>

#include "scene/scene.h"

namespace tw {

/// The wave of [wave] for `check`: what it is by theory, how it is resolved, and what becomes of it on its way; empty: there
/// is none.
std::string wave_text(const Scene& scene);

}  // namespace tw
