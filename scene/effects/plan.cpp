#include "scene/effects/plan.h"

#include <fmt/format.h>

#include <algorithm>

#include "record/influence_words.h"
#include "scene/effects/registry.h"

namespace tw {

std::vector<EffectChoice> plan_effects(Scene& scene, Section& section,
                                       const std::function<std::optional<bool>(const std::string& effect)>& asked) {
    FlowNumbers flow = flow_numbers(scene);
    if (!asked("gravity").value_or(true)) flow.bond = 0;  // no weight holds the surface level
    std::vector<EffectChoice> choices;
    for (const EffectPart& part : effects()) {
        const auto made = [&](const std::string& name) -> const EffectChoice* {
            return name.empty() ? nullptr : &*std::ranges::find(choices, name, &EffectChoice::name);
        };
        EffectQuestion question{scene, flow, asked(part.name), made(part.needs), made(part.excludes)};
        EffectChoice choice = part.plan(question);
        choice.name = part.name;
        if (!part.older.empty() && section.has(part.older))
            choice.reason += fmt::format("; {} is an older name of it", part.older);
        for (const std::string& words : bounds_in_words(choice.bounds)) choice.influence += "; " + words;
        if (choice.on) {
            if (question.needed && !question.needed->on)
                section.fail(part.name, fmt::format("needs {} = \"on\" as well", part.needs));
            if (question.excluded && question.excluded->on)
                section.fail(part.name, fmt::format("cannot be on together with {}", part.excludes));
            const std::string why = part.obstacle ? part.obstacle(scene) : "";
            if (!why.empty()) section.fail(part.name, why);
        }
        choices.push_back(std::move(choice));
    }
    section.finish();
    scene.effects = choices;  // defaults that follow from them
    for (std::size_t k = 0; k < choices.size(); ++k)
        if (effects()[k].settle) effects()[k].settle(scene, choices[k].on);
    return choices;
}

bool Scene::effect_on(const std::string& name) const {
    const std::string& known = effect_part(name).name;
    for (const EffectChoice& e : effects)
        if (e.name == known) return e.on;
    return false;
}

}  // namespace tw
