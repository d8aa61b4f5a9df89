#pragma once
#include <functional>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "scene/scene.h"
#include "text/range.h"

namespace tw {

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

/// Calls `use` with the value of a key in the scene; not at all for a key without a slot.
template <class Use>
void with_value(const SceneKey& key, Scene& scene, Use use) {
    std::visit(
        [&](const auto& of) {
            if constexpr (!std::is_same_v<std::decay_t<decltype(of)>, std::monostate>) use(of(scene));
        },
        key.slot);
}

}  // namespace tw
