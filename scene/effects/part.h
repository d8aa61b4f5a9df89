#pragma once
#include <optional>
#include <string>
#include <vector>

#include "scene/effects/flow_numbers.h"
#include "scene/scene_key.h"

namespace tw {

/// What the plan of one effect is decided from.
struct EffectQuestion {
    const Scene& scene;
    const FlowNumbers& flow;
    std::optional<bool> asked;       ///< what the scene or the command line says; nothing for "auto"
    const EffectChoice* needed{};    ///< the choice for the effect that this one needs; null: it needs none
    const EffectChoice* excluded{};  ///< and for the one that it cannot be on with

    /// On or off: as asked, else `automatic`.
    EffectChoice choice(bool automatic) const;
};

/// "drag: ...; lift: ...; splash: ...; remark", the words of every effect's influence.
std::string influence(const std::string& drag, const std::string& lift, const std::string& splash,
                      const std::string& remark = "");

/// The same share of each of these kinds of quantities, to either side.
std::vector<EffectBound> equal_shares(const std::vector<std::string>& kinds, double share, const std::string& source);

/// One physical effect that a run can be made with or without: everything that is said of it before a run.
struct EffectPart {
    enum class Solved { by_both_methods, by_particles_only, by_neither };
    std::string name;        ///< also its key in [effects]
    std::string older = {};  ///< an older name of it, that is still read
    std::string meaning;
    Solved solved = Solved::by_both_methods;
    std::string needs = {};     ///< an effect without which this one cannot be on; earlier in the list
    std::string excludes = {};  ///< an effect with which it cannot be on; earlier in the list
    /// On or off, the reason, the expected influence and the cost.
    EffectChoice (*plan)(const EffectQuestion& question) = nullptr;
    /// Why it cannot be on in this scene, and what to do; empty: it can. Null: it always can.
    std::string (*obstacle)(const Scene& scene) = nullptr;
    /// Changes the scene's numbers once the choice is made. Null: none.
    void (*settle)(Scene& scene, bool on) = nullptr;
    std::vector<SceneKey> keys = {};  ///< its parameters in other sections; they count only while it is on
    bool in_the_throughput = false;   ///< the throughput in cost_estimate.cpp was measured with it on
};

/// A number of the scene takes the value that a choice wants, unless the file gives it. `key`: "section.key".
template <class Value>
void take_default(Scene& scene, const std::string& key, double& number, const Value& value) {
    if (!scene.places.contains(key)) number = value();
}

}  // namespace tw
