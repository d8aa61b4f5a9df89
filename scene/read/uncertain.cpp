#include "scene/read/uncertain.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <cmath>

#include "base/errors.h"
#include "base/read_file.h"
#include "meshes/generate.h"
#include "methods/methods.h"
#include "scene/keys/keys.h"
#include "scene/read/overrides.h"
#include "text/did_you_mean.h"
#include "text/units.h"

namespace tw {
namespace {

std::vector<std::string> parts_of(const std::string& name) {
    std::vector<std::string> parts{""};
    for (const char c : name)
        if (c == '.')
            parts.emplace_back();
        else
            parts.back() += c;
    return parts;
}

/// Counted from 1; 0: it is no number of a place.
std::size_t place_in_list(const std::string& part) {
    std::size_t n = 0;
    const auto [end, error] = std::from_chars(part.data(), part.data() + part.size(), n);
    return error == std::errc{} && end == part.data() + part.size() ? n : 0;
}

/// What a name of a number leads to, or why it leads nowhere.
struct Found {
    TextValue* value = nullptr;
    std::string key;  ///< of its section: "draft"
    std::string unit = "-";
    std::string why_not;
};

/// The entry of a list that a part of a name means: of tables the one of this `name`, else the N-th.
TextValue* entry_of(TextValue& list, const std::string& part) {
    for (TextValue& entry : list.list)
        if (const TextValue* name = entry.find("name"); name && name->text == part) return &entry;
    const std::size_t n = place_in_list(part);
    return n >= 1 && n <= list.list.size() ? &list.list[n - 1] : nullptr;
}

std::vector<std::string> names_in(const TextValue& value) {
    std::vector<std::string> names;
    for (const auto& [name, member] : value.members) names.push_back(name);
    for (std::size_t k = 0; k < value.list.size(); ++k) {
        const TextValue* name = value.list[k].find("name");
        names.push_back(name ? name->text : fmt::format("{}", k + 1));
    }
    return names;
}

/// A name, a file or a choice, also where it reads like a number.
bool holds_words(const std::string& section, const std::string& key) {
    using Kind = SceneKey::Kind;
    constexpr std::array words{Kind::flag, Kind::on_off, Kind::text, Kind::name, Kind::choice, Kind::choices};
    return std::ranges::any_of(scene_keys(), [&](const SceneKey& known) {
        return known.section == section && known.name == key && std::ranges::find(words, known.kind) != words.end();
    });
}

/// Unit of a key that stands in the scene: of the table, or of a parameter of the section's shape.
std::string unit_of(const std::string& section, const TextValue& table, const std::string& key) {
    for (const SceneKey& known : scene_keys())
        if (known.section == section && known.name == key) return known.unit;
    if (const TextValue* shape = table.find("shape"))
        for (const HullShape& known : hull_shapes())
            if (known.name == shape->text)
                for (const HullParameter& p : known.parameters)
                    if (p.name == key) return p.kind;
    return "-";
}

/// Sections that say how a scene is solved and recorded, not what it is.
bool is_choice(const std::string& section) {
    constexpr std::array choices{"resolution", "run", "sampling", "effects", "measured", "uncertain"};
    return std::ranges::find(choices, section) != choices.end() || find_method(section);
}

/// The section that every scene has, also where it does not write it.
constexpr const char* water_section = "water";

/// The numbers that a key without its section may mean: "draft" is hull.draft where nothing else has a draft.
std::vector<std::string> meant_by(const TextValue& document, const std::string& key) {
    std::vector<std::string> names;
    for (const auto& [section, value] : document.members) {
        if (is_choice(section)) continue;
        if (value.find(key)) names.push_back(section + "." + key);
        const std::vector<std::string> entries = names_in(value);
        for (std::size_t k = 0; k < value.list.size(); ++k)
            if (value.list[k].find(key)) names.push_back(section + "." + entries[k] + "." + key);
    }
    if (names.empty())  // not written: hull.trim where there is a hull
        for (const SceneKey& known : scene_keys())
            if (const TextValue* table = document.find(known.section);
                known.name == key && !is_choice(known.section) &&
                (table ? table->kind == TextValue::Kind::table : known.section == water_section))
                names.push_back(known.section + "." + key);
    return names;
}

/// Writes a number that the scene does not say, and whose default is known, into its section: hull.trim = "0 deg".
TextValue* write_default(TextValue& table, const std::string& section, const std::string& key) {
    for (const SceneKey& known : scene_keys()) {
        if (known.section != section || known.name != key || known.kind != SceneKey::Kind::number) continue;
        try {
            TextValue value;
            value.kind = TextValue::Kind::number;
            value.text = fallback_text(known);
            value.number = quantity(value.text, known.unit);
            value.place = table.place;
            table.members.push_back({key, std::move(value)});
            return &table.members.back().second;
        } catch (const UnitError&) { return nullptr; }  // "required in a stream": no number
    }
    return nullptr;
}

Found find_number(TextValue& document, const std::string& name) {
    const std::vector<std::string> parts = parts_of(name);
    Found found;
    TextValue *at = &document, *section = nullptr;
    std::string so_far;
    for (const std::string& part : parts) {
        TextValue* next = at->kind == TextValue::Kind::table  ? at->find(part)
                          : at->kind == TextValue::Kind::list ? entry_of(*at, part)
                                                              : nullptr;
        if (!next && at == &document && part == water_section) {
            document.members.push_back({part, {}});
            next = &document.members.back().second;
            next->kind = TextValue::Kind::table;
        }
        if (!next && at != &document && at->kind == TextValue::Kind::table)
            next = write_default(*at, parts.front(), part);
        if (!next) {
            const std::vector<std::string> known = names_in(*at);
            found.why_not = fmt::format("{} has no {}", so_far.empty() ? "the scene" : so_far + " of the scene", part);
            if (!known.empty())
                found.why_not += fmt::format("; it has: {}{}", fmt::join(known, ", "), did_you_mean(part, known));
            return found;
        }
        if (at->kind == TextValue::Kind::table && at != &document) section = at, found.key = part;
        so_far += (so_far.empty() ? "" : ".") + part;
        at = next;
    }
    if (section) found.unit = unit_of(parts.front(), *section, found.key);
    bool number = at->kind == TextValue::Kind::number;
    if (at->kind == TextValue::Kind::text && section && !holds_words(parts.front(), found.key)) try {
            quantity(at->text, found.unit);
            number = true;
        } catch (const UnitError&) {}
    if (!number)
        found.why_not = fmt::format("{} = {} is no number", name, at->shown());
    else
        found.value = at;
    if (at->kind == TextValue::Kind::list && !at->list.empty())
        found.why_not += fmt::format("; expected one of its entries: {}.1 to {}.{}", name, name, at->list.size());
    return found;
}

/// Why a change of this key would not say what is not known of the case; empty: it would.
std::string why_no_input(const std::string& name, const std::string& key) {
    const std::string section = parts_of(name).front();
    if (find_method(section)) return "belongs to the numerics of one method";
    if (is_choice(section)) return "says how the scene is solved and recorded, not what it is";
    for (const SceneKey& known : scene_keys())
        if (known.section == section && known.name == key && known.kind == SceneKey::Kind::whole) return "is a count";
    return {};
}

/// Name and half width of every number, however its key is written: hull.draft = ..., "hull.draft" = ... or
/// hull = { draft = ... }.
void flatten(const TextValue& table, const std::string& before,
             std::vector<std::pair<std::string, const TextValue*>>& all) {
    for (const auto& [key, value] : table.members) {
        const std::string name = before.empty() ? key : before + "." + key;
        if (value.kind == TextValue::Kind::table)
            flatten(value, name, all);
        else
            all.emplace_back(name, &value);
    }
}

double half_width_of(const TextValue& written, double value, const std::string& unit) {
    double width = 0;
    if (written.kind == TextValue::Kind::number) {
        width = written.number;
        if (unit == "rad")
            throw UnitError(fmt::format("a plain number is in radians; expected \"{} deg\" or \"{} rad\"", written.text,
                                        written.text));
    } else if (written.kind != TextValue::Kind::text) {
        throw UnitError("expected a half width such as \"1 mm\" or \"2 %\"");
    } else if (written.text.ends_with('%')) {
        width = quantity(written.text, "-") * std::abs(value);
        if (value == 0) throw UnitError("per cent of a number that is 0; expected a size");
    } else {
        width = quantity(written.text, unit);
    }
    if (!(width > 0) || !std::isfinite(width)) throw UnitError("expected a half width greater than 0");
    return width;
}

}  // namespace

void change_numbers(TextValue& document, const ChangedNumbers& changed, const std::filesystem::path& file) {
    for (const auto& [name, number] : changed) {
        const Found found = find_number(document, name);
        if (!found.value) throw InputError(fmt::format("{}: {}: {}", file.string(), name, found.why_not));
        TextValue& value = *found.value;
        value.kind = TextValue::Kind::number;
        value.number = number;
        value.text = fmt::format("{}", number);
        value.option = "[uncertain] " + name;
    }
}

std::vector<UncertainNumber> uncertain_numbers_of(const UncertainTable& of, const TextValue& document) {
    std::vector<std::pair<std::string, const TextValue*>> named;
    flatten(of.table, "", named);
    std::vector<UncertainNumber> numbers;
    TextValue scene = document;
    for (const auto& [as_written, written] : named) {
        std::string name = as_written;
        const auto fail = [&, written = written](const std::string& why) {
            throw InputError(fmt::format("{}:{}:{}: [uncertain] {} = {}: {}", of.file.string(), written->place.line,
                                         written->place.column, name, written->shown(), why));
        };
        if (name.find('.') == std::string::npos && !scene.find(name)) {
            const std::vector<std::string> meant = meant_by(scene, name);
            if (meant.size() > 1)
                fail(fmt::format("several numbers of the scene are called {}; expected one of {}", name,
                                 fmt::join(meant, ", ")));
            if (!meant.empty()) name = meant.front();
        }
        const Found found = find_number(scene, name);
        if (!found.value) fail(found.why_not + "; expected the name of a number of the scene, such as hull.draft");
        if (const std::string why = why_no_input(name, found.key); !why.empty())
            fail(why + "; expected a number of the hull, the water, the motion or another part of the case");
        if (std::ranges::find(numbers, name, &UncertainNumber::name) != numbers.end()) fail("it is named twice");
        const TextValue& v = *found.value;
        const double value = v.kind == TextValue::Kind::number ? v.number : quantity(v.text, found.unit);
        try {
            const double width = half_width_of(*written, value, found.unit);
            const bool plain = written->kind == TextValue::Kind::number && found.unit != "-";
            numbers.push_back({name, value, width, written->text + (plain ? " " + found.unit : "")});
        } catch (const UnitError& e) { fail(e.what()); }
    }
    return numbers;
}

std::vector<UncertainNumber> uncertain_numbers(const std::filesystem::path& scene, const SceneOverrides& overrides,
                                               const UncertainTable* more) {
    TextValue document = parse_document(read_text_within(scene, largest_document), scene);
    apply_overrides(overrides, document);
    std::vector<UncertainNumber> numbers;
    if (const TextValue* own = document.find("uncertain")) numbers = uncertain_numbers_of({scene, *own}, document);
    if (!more) return numbers;
    for (UncertainNumber& number : uncertain_numbers_of(*more, document)) {
        std::erase_if(numbers, [&](const UncertainNumber& own) { return own.name == number.name; });
        numbers.push_back(std::move(number));
    }
    return numbers;
}

}  // namespace tw
