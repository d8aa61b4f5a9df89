#pragma once
#include "scene/scene.h"
#include "text/document.h"

namespace tw {

/// Puts what the command line asks for into the document, as if it stood in the file.
void apply_overrides(const SceneOverrides& overrides, TextValue& document);
/// Removes duration = "auto", which is what holds without the key.
void forget_auto_duration(TextValue& document);

}  // namespace tw
