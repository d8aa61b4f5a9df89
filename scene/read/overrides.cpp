#include "scene/read/overrides.h"

#include <fmt/format.h>

#include <set>

namespace tw {
namespace {

/// Puts a command line option into the document as if it stood in the file; its messages name the option.
void override_key(TextValue& document, const std::string& section, const std::string& key, const std::string& option,
                  TextValue value) {
    TextValue* table = document.find(section);
    if (!table) {
        TextValue empty;
        empty.kind = TextValue::Kind::table;
        document.members.push_back({section, empty});
        table = &document.members.back().second;
    }
    value.option = option;
    std::erase_if(table->members, [&](const auto& m) { return m.first == key; });
    table->members.push_back({key, std::move(value)});
}

TextValue number_value(double number) {
    TextValue v;
    v.kind = TextValue::Kind::number;
    v.number = number;
    v.text = fmt::format("{:.10g}", number);
    return v;
}

TextValue text_value(const std::string& text) {
    TextValue v;
    v.kind = TextValue::Kind::text;
    v.text = text;
    return v;
}

}  // namespace

void apply_overrides(const SceneOverrides& o, TextValue& document) {
    if (o.hull_file) {
        // Only what says how the hull stands in the water outlives a swap; a shape's own parameters would be unknown
        // keys.
        if (TextValue* hull = document.find("hull"))
            std::erase_if(hull->members, [](const auto& m) {
                static const std::set<std::string> kept{"trim",   "heel", "draft",          "position", "half",
                                                        "repair", "unit", "axes",           "free",     "mass",
                                                        "lcg",    "vcg",  "pitch_gyradius", "release"};
                return !kept.contains(m.first);
            });
        override_key(document, "hull", "file", "--hull", text_value(o.hull_file->string()));
    }
    if (o.speed) override_key(document, "motion", "speed", "--speed", number_value(*o.speed));
    if (o.spacing) override_key(document, "resolution", "spacing", "--spacing", number_value(*o.spacing));
    if (o.near_hull) override_key(document, "resolution", "near_hull", "--near-hull", number_value(*o.near_hull));
    if (o.duration) {  // all of it: who asks for a time wants to see it
        override_key(document, "run", "duration", "--duration", number_value(*o.duration));
        override_key(document, "run", "stop", "--duration", text_value("duration"));
    }
    if (o.wave_length) {
        if (TextValue* wave = document.find("wave"))
            std::erase_if(wave->members, [](const auto& m) { return m.first == "period"; });
        override_key(document, "wave", "length", "--wave-length", number_value(*o.wave_length));
    }
    if (o.trim) override_key(document, "hull", "trim", "--trim", number_value(*o.trim));
    for (const auto& [name, on] : o.effects)
        override_key(document, "effects", name, "--effect " + name, text_value(on ? "on" : "off"));
}

void forget_auto_duration(TextValue& document) {
    TextValue* run = document.find("run");
    if (!run || run->kind != TextValue::Kind::table) return;
    std::erase_if(run->members, [](const auto& m) {
        return m.first == "duration" && m.second.kind == TextValue::Kind::text && m.second.text == "auto";
    });
}

}  // namespace tw
