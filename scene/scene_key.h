#pragma once
#include <functional>
#include <string>
#include <type_traits>
#include <variant>
#include <vector>

#include "scene/scene.h"
#include "text/range.h"

namespace tw {

/// Where the checked scene keeps the value of a key: in a repeated section of its k-th entry, counted from 0 (else k is
/// not used). Without a place for a key from which a reader works something else out.
struct Slot {
    template <class Value>
    using In = std::function<Value&(Scene&, std::size_t)>;
    std::variant<std::monostate, In<double>, In<int>, In<std::string>, In<std::vector<double>>,
                 In<std::vector<std::string>>>
        place = {};
    /// Of a repeated section: the number of its entries, and making it one; else empty.
    std::function<std::size_t(const Scene&)> entries = {};
    std::function<void(Scene&)> make_one = {};
};
template <class Part, class Value>
Slot slot(Part Scene::*part, Value Part::*value) {
    return {Slot::In<Value>([part, value](Scene& scene, std::size_t) -> Value& { return scene.*part.*value; })};
}
/// Of the k-th entry of a list of the scene.
template <class Entry, class Value>
Slot entry_slot(std::vector<Entry> Scene::*list, Value Entry::*value) {
    return {Slot::In<Value>([list, value](Scene& scene, std::size_t k) -> Value& { return (scene.*list)[k].*value; }),
            [list](const Scene& scene) { return (scene.*list).size(); },
            [list](Scene& scene) { (scene.*list).resize(1); }};
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

/// Calls `use` with the value of a key in the scene, in a repeated section that of its k-th entry; not at all for a key
/// without a slot.
template <class Use>
void with_value(const SceneKey& key, Scene& scene, std::size_t k, Use use) {
    std::visit(
        [&](const auto& of) {
            if constexpr (!std::is_same_v<std::decay_t<decltype(of)>, std::monostate>) use(of(scene, k));
        },
        key.slot.place);
}

/// A new Scene, with one entry of the repeated section that a key stands in: it holds the key's default.
inline Scene unsaid(const SceneKey& key) {
    Scene scene;
    if (key.slot.make_one) key.slot.make_one(scene);
    return scene;
}

}  // namespace tw
