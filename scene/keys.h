#pragma once
#include <functional>
#include <string>
#include <string_view>
#include <type_traits>
#include <variant>
#include <vector>

#include "scene/scene.h"
#include "text/range.h"

namespace tw {

// The table of everything that a scene file may say. The readers take ranges, units and choices from it, the messages
// what is known and expected, the hashes which numbers belong to which, and docs/scene_reference.md is made from it.
// A new key is one row here (the keys of an effect: in its part, see effects/), and a line in a reader only where it
// has no slot.

/// The value of a key in the checked scene; none for a key from which a reader works something else out.
using Slot = std::variant<std::monostate, std::function<double&(Scene&)>, std::function<int&(Scene&)>,
                          std::function<std::string&(Scene&)>, std::function<std::vector<double>&(Scene&)>,
                          std::function<std::vector<std::string>&(Scene&)>>;
template <class Part, class Value>
Slot slot(Part Scene::*part, Value Part::*value) {
    return std::function<Value&(Scene&)>([part, value](Scene& scene) -> Value& { return scene.*part.*value; });
}

struct SceneKey {
    enum class Kind {
        number,   ///< SI value or text with a unit
        whole,    ///< number without a fraction
        flag,     ///< true or false
        on_off,   ///< "auto", "on" or "off"
        text,     ///< text in quotes
        name,     ///< letters, digits and '_', beginning with a letter
        choice,   ///< one of `choices`
        choices,  ///< list of some of `choices`; of names where there are none
        pair,     ///< [low, high] with low < high
        place2,   ///< [x, y]
        place3,   ///< [x, y, z]
        list,     ///< list of numbers
    };
    /// Which hash covers the value (hash.h).
    enum class Hashed {
        scene,   ///< a number that all methods use: the scene hash, and with it all run hashes
        run,     ///< numerics of the method whose section it stands in: that method's run hash; elsewhere how a run
                 ///< begins: all run hashes
        nowhere  ///< changes nothing that is solved
    };
    std::string section = {};
    std::string name;
    Kind kind = Kind::number;
    std::string unit = "-";  ///< SI; "-": none
    Range range = {};
    std::vector<std::string> choices = {};
    Hashed hashed = Hashed::nowhere;
    Slot slot = {};
    std::string fallback = {};  ///< what holds without the key, in words; empty: what the slot of a new Scene holds
    std::string meaning;        ///< one sentence
    std::string hint = {};      ///< follows the message that the value is out of range
    std::string effect = {};    ///< counts only while this effect is on
    std::string older = {};     ///< an older spelling that is still read
    /// Came after records with hashes existed: what a new Scene holds adds nothing to the hash.
    bool later = false;
};

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
/// Calls `use` with the value of a key in the scene; not at all for a key without a slot.
template <class Use>
void with_value(const SceneKey& key, Scene& scene, Use use) {
    std::visit(
        [&](const auto& of) {
            if constexpr (!std::is_same_v<std::decay_t<decltype(of)>, std::monostate>) use(of(scene));
        },
        key.slot);
}
/// What holds without the key, as text: its `fallback`, else its value in a new Scene with its unit.
std::string fallback_text(const SceneKey& key);

}  // namespace tw
