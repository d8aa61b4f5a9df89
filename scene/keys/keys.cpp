#include "scene/keys/keys.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <stdexcept>

#include "methods/names.h"
#include "scene/effects/registry.h"
#include "scene/keys/key_rows.h"

namespace tw {
namespace {

using Rows = std::vector<SceneKey>;
using Kind = SceneKey::Kind;
using Hashed = SceneKey::Hashed;

Rows effect_keys() {
    Rows rows;
    for (const EffectPart& part : effects())
        rows.push_back({.name = part.name,
                        .kind = Kind::on_off,
                        .hashed = Hashed::scene,
                        .fallback = "auto",
                        .meaning = part.meaning,
                        .older = part.older});
    return rows;
}

std::vector<SceneKey> all_keys() {
    const std::pair<const char*, Rows> sections[] = {
        {"",
         {{.name = "title", .kind = Kind::text, .fallback = "name of the file", .meaning = "Title of the reports."}}},
        {"hull", hull_keys()},
        {"water", water_keys()},
        {"motion", motion_keys()},
        {"wave", wave_keys()},
        {"resolution", resolution_keys()},
        {"domain", domain_keys()},
        {"run", run_keys()},
        {"sampling", sampling_keys()},
        {"probe", probe_keys()},
        {"volume", volume_keys()},
        {"measured", measured_keys()},
        {"tank", tank_keys()},
        {"water_block", water_block_keys()},
        {"refine", refine_keys()},
        {"obstacle", obstacle_keys()},
        {"body", body_keys()},
        {"ply", ply_keys()},
        {"gauge", gauge_keys()},
        {"effects", effect_keys()},
        {sph_method, sph_keys()},
        {fvm_method, fvm_keys()}};
    std::vector<SceneKey> keys;
    for (const auto& [section, rows] : sections) {
        for (SceneKey key : rows) {
            key.section = section;
            keys.push_back(std::move(key));
        }
        for (const EffectPart& part : effects())
            for (SceneKey key : part.keys)
                if (key.section == section) {
                    key.effect = part.name;
                    keys.push_back(std::move(key));
                }
    }
    return keys;
}

}  // namespace

const std::vector<SectionRow>& scene_sections() {
    static const std::vector<SectionRow> sections{
        {"", false, "Above the first section."},
        {"hull", false, "The hull as it stands in the water. Without this section the scene has no hull."},
        {"water", false, "Water, air and gravity."},
        {"motion", false, "How hull and water move against each other."},
        {"wave", false,
         "A wave, regular or a sum of linear ones, in a tank or, as head or following waves, in a stream: a zone at "
         "one end makes it, one at the other absorbs it; of oblique waves in a stream zones at all four sides do both; "
         "without zones head waves enter with a stream at least as fast as they are. "
         "A tank begins with the wave, a stream calm."},
        {"resolution", false, "Sizes of particles and cells."},
        {"domain", false, "Extent of what is solved, around the hull or, in a channel, by itself."},
        {"run", false, "How long and how the scene is run."},
        {"sampling", false, "What is recorded, and when."},
        {"probe", true, "A place at which pressure or height is recorded; exactly one of the two is given."},
        {"volume", true,
         "A box in which the volume of water is recorded, as that behind a breakwater; with waves also the rate at "
         "which "
         "it grows."},
        {"measured", true,
         "What was measured of a quantity: the reports show it beside the runs, and say which of them miss it."},
        {"tank", false,
         "A tank instead of a domain: walls all around, open above. With `law` it moves, and all places and velocities "
         "are in its own axes."},
        {"water_block", true, "A box of water in a tank; without any, all below z = 0 is water."},
        {"refine", true,
         "A place to be resolved finer than what lies round it, in both methods: cells are halved there, and finer "
         "particles stand there where those round it are coarser. With a hull in a stream; of a section, by particles "
         "alone."},
        {"obstacle", true, "A fixed closed solid: a box (min and max), a file or a shape."},
        {"body", true,
         "A closed solid that moves in a tank or a stream, freely or as prescribed, or an elastic plate; the mesh "
         "method moves rigid ones."},
        {"ply", true, "A layer of a laminate, for the layups of elastic bodies."},
        {"gauge", true, "A place on an elastic body at which its displacement or a strain is recorded."},
        {"effects", false,
         "Physical effects: \"auto\" (the plan decides), \"on\" or \"off\". `--effect NAME=on` on the command line "
         "takes "
         "precedence."},
        {"uncertain", false,
         "Numbers of this scene that are known within an interval only: name of the number = half width of its 95 % "
         "interval, a size or per cent, e.g. `hull.draft = \"1 mm\"`, or `draft = \"1 mm\"` where the scene has no "
         "other "
         "draft. Of a repeated section the name stands between: "
         "`body.rod.density`, or its place: `body.1.density`; an entry of a list has its place behind it: "
         "`tank.size.3`. Studies run the coarsest size with either end of it, see "
         "[theory](theory.md#uncertain-input). In no hash."},
        {sph_method, false, "Numerics of the particle method."},
        {fvm_method, false, "Numerics of the mesh method (interFoam)."},
    };
    return sections;
}

const std::vector<SceneKey>& scene_keys() {
    static const std::vector<SceneKey> keys = all_keys();
    return keys;
}

const SceneKey& scene_key(std::string_view section, std::string_view name) {
    for (const SceneKey& key : scene_keys())
        if (key.section == section && key.name == name) return key;
    throw std::logic_error(fmt::format("no key [{}] {} in the table", section, name));
}

std::string fallback_text(const SceneKey& key) {
    if (!key.fallback.empty()) return key.fallback;
    Scene scene = unsaid(key);
    std::string text;
    with_value(key, scene, 0, [&](const auto& value) {
        using Value = std::decay_t<decltype(value)>;
        if constexpr (std::is_same_v<Value, double>)
            text = value_text(value, key.unit);
        else if constexpr (std::is_same_v<Value, int> || std::is_same_v<Value, std::string>)
            text = fmt::format("{}", value);
        else
            text = value.empty() ? "none" : fmt::format("{}", fmt::join(value, ", "));
    });
    if (text.empty()) throw std::logic_error(fmt::format("[{}] {}: no default in the table", key.section, key.name));
    return text;
}

}  // namespace tw
