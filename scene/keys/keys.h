#pragma once
#include <string>
#include <string_view>
#include <vector>

#include "scene/scene_key.h"

namespace tw {

// The table of everything that a scene file may say. The readers take ranges, units and choices from it, the messages
// what is known and expected, the hashes which numbers belong to which, and docs/scene_reference.md is made from it.
// A new key is one row here (the keys of an effect: in its part, see effects/), and a line in a reader only where it
// has no slot.

/// A section of the scene file.
struct SectionRow {
    std::string name;
    bool repeated = false;  ///< written as [[name]], any number of times
    std::string meaning;    ///< one sentence or two
};
const std::vector<SectionRow>& scene_sections();

/// All keys, section by section; those of [effects] and of the effects' parameters come from the registry.
const std::vector<SceneKey>& scene_keys();
/// Throws std::logic_error when the table has no such key.
const SceneKey& scene_key(std::string_view section, std::string_view name);
/// What holds without the key, as text: its `fallback`, else its value in a new Scene with its unit.
std::string fallback_text(const SceneKey& key);

}  // namespace tw
