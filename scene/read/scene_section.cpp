#include "scene/read/scene_section.h"

#include <fmt/format.h>

#include <cmath>

namespace tw {

std::string SceneSection::table_name() const {
    return name().starts_with('[') ? name().substr(1, name().size() - 2) : name();
}

const SceneKey& SceneSection::row(const std::string& key) const { return scene_key(table_name(), key); }

std::string SceneSection::written(const SceneKey& key) {
    if (key.older.empty() || !has(key.older)) return key.name;
    if (has(key.name)) fail(key.older, fmt::format("given twice: it is an older spelling of {}; keep one", key.name));
    know(key.name);
    return key.older;
}

std::optional<double> SceneSection::number(const std::string& name) {
    const SceneKey& key = row(name);
    return number(written(key), key.unit, key.range, key.hint);
}

std::optional<int> SceneSection::whole(const std::string& name) {
    const auto value = number(name);
    if (value && *value != std::floor(*value)) fail(name, "expected a whole number");
    return value ? std::optional(static_cast<int>(*value)) : std::nullopt;
}

std::optional<std::vector<double>> SceneSection::numbers(const std::string& name) {
    const SceneKey& key = row(name);
    return numbers(name, key.unit, key.kind == SceneKey::Kind::list ? 0 : key.kind == SceneKey::Kind::place3 ? 3 : 2);
}

std::optional<std::string> SceneSection::choice(const std::string& name) {
    const SceneKey& key = row(name);
    know(name);
    return has(name) ? std::optional(choice(name, "", key.choices)) : std::nullopt;
}

void SceneSection::read_slot(const SceneKey& key, Scene& scene) {
    const auto take = [](auto& into, auto value) {
        if (value) into = std::move(*value);
    };
    with_value(key, scene, 0, [&](auto& value) {
        using Value = std::decay_t<decltype(value)>;
        if constexpr (std::is_same_v<Value, double>)
            take(value, number(key.name));
        else if constexpr (std::is_same_v<Value, int>)
            take(value, whole(key.name));
        else if constexpr (std::is_same_v<Value, std::string>)
            take(value, key.choices.empty() ? text(key.name) : choice(key.name));
        else if constexpr (std::is_same_v<Value, std::vector<double>>)
            take(value, numbers(key.name));
        else
            take(value, choices(key.name));
    });
}

void SceneSection::read_into(Scene& scene) {
    for (const SceneKey& key : scene_keys())
        if (key.section == table_name()) read_slot(key, scene);
}

Scene SceneSection::entry() {
    Scene scene;
    for (const SceneKey& key : scene_keys())
        if (key.section == table_name() && key.slot.make_one) key.slot.make_one(scene);
    read_into(scene);
    return scene;
}

}  // namespace tw
