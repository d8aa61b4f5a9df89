#include "scene/section.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "base/errors.h"
#include "scene/units.h"

namespace tw {
namespace {

/// Number of single-letter insertions, deletions, replacements and swaps of neighbours from a to b.
std::size_t edits(const std::string& a, const std::string& b) {
    std::vector<std::vector<std::size_t>> d(a.size() + 1, std::vector<std::size_t>(b.size() + 1));
    for (std::size_t i = 0; i <= a.size(); ++i) d[i][0] = i;
    std::iota(d[0].begin(), d[0].end(), std::size_t{0});
    for (std::size_t i = 1; i <= a.size(); ++i) {
        for (std::size_t j = 1; j <= b.size(); ++j) {
            d[i][j] = std::min({d[i - 1][j] + 1, d[i][j - 1] + 1, d[i - 1][j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1)});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                d[i][j] = std::min(d[i][j], d[i - 2][j - 2] + 1);
        }
    }
    return d[a.size()][b.size()];
}

std::string joined(const std::vector<std::string>& words) {
    std::string out;
    for (const std::string& w : words) out += (out.empty() ? "" : ", ") + w;
    return out;
}

}  // namespace

std::string did_you_mean(const std::string& word, const std::vector<std::string>& known) {
    std::string best;
    std::size_t least = 1 + word.size() / 3;  // further away it is no misspelling but another word
    for (const std::string& k : known)
        if (edits(word, k) <= least && (best.empty() || edits(word, k) < edits(word, best))) best = k;
    return best.empty() ? "" : "; did you mean '" + best + "'?";
}

Section::Section(std::filesystem::path file, std::string name, const SceneValue* table)
    : file_(std::move(file)), name_(std::move(name)), table_(table) {}

std::string Section::where(const std::string& key) const {
    const SceneValue* value = table_ ? table_->find(key) : nullptr;
    const std::string section = name_.empty() ? "" : "[" + name_ + "] ";
    if (value && !value->option.empty()) return fmt::format("{}: {} {}", file_.string(), value->option, value->shown());
    if (value)
        return fmt::format("{}:{}:{}: {}{} = {}", file_.string(), value->place.line, value->place.column, section, key,
                           value->shown());
    if (table_ && table_->place.line > 0)
        return fmt::format("{}:{}:{}: {}{}", file_.string(), table_->place.line, table_->place.column, section, key);
    return fmt::format("{}:1:1: {}{}", file_.string(), section, key);
}

void Section::fail(const std::string& key, const std::string& message) const {
    throw InputError(where(key) + ": " + message);
}

const SceneValue* Section::ask(const std::string& key) {
    asked_.insert(key);
    return table_ ? table_->find(key) : nullptr;
}

double Section::as_number(const std::string& key, const SceneValue& value, std::string_view unit) const {
    double si = 0;
    if (value.kind == SceneValue::Kind::number) {
        si = value.number;
        if (!std::isfinite(si)) fail(key, "not a finite number");
    } else if (value.kind == SceneValue::Kind::text) {
        try {
            si = quantity(value.text, unit);
        } catch (const UnitError& e) { fail(key, e.what()); }
    } else {
        fail(key, unit == "-" ? std::string("expected a number")
                              : fmt::format("expected a number in {} or a text such as \"1.5 {}\"", unit, unit));
    }
    return si;
}

std::optional<double> Section::number(const std::string& key, std::string_view unit, Range range,
                                      const std::string& hint) {
    const SceneValue* value = ask(key);
    if (!value) return {};
    const double si = as_number(key, *value, unit);
    if (!(si >= range.min && si <= range.max) || (range.open_min && si == range.min)) {
        std::string message = "out of range; expected " + range_text(range, unit);
        if (!hint.empty()) message += " (" + hint + ")";
        if (unit == "rad" && value->kind == SceneValue::Kind::number)
            message += fmt::format(" (a plain number is in radians; write \"{} deg\" for degrees)", value->text);
        fail(key, message);
    }
    return si;
}

double Section::number(const std::string& key, double fallback, std::string_view unit, Range range) {
    return number(key, unit, range).value_or(fallback);
}

std::optional<std::string> Section::text(const std::string& key) {
    const SceneValue* value = ask(key);
    if (!value) return {};
    if (value->kind != SceneValue::Kind::text) fail(key, "expected a text in quotes");
    return value->text;
}

const SceneKey& Section::row(const std::string& key) const {
    return scene_key(name_.starts_with('[') ? name_.substr(1, name_.size() - 2) : name_, key);
}

std::string Section::written(const SceneKey& key) {
    if (key.older.empty() || !has(key.older)) return key.name;
    if (has(key.name)) fail(key.older, fmt::format("given twice: it is an older spelling of {}; keep one", key.name));
    know(key.name);
    return key.older;
}

std::optional<double> Section::number(const std::string& name) {
    const SceneKey& key = row(name);
    return number(written(key), key.unit, key.range, key.hint);
}

std::optional<int> Section::whole(const std::string& name) {
    const auto value = number(name);
    if (value && *value != std::floor(*value)) fail(name, "expected a whole number");
    return value ? std::optional(static_cast<int>(*value)) : std::nullopt;
}

std::optional<std::vector<double>> Section::numbers(const std::string& key, std::string_view unit, std::size_t count) {
    const SceneValue* value = ask(key);
    if (!value) return {};
    if (value->kind != SceneValue::Kind::list) fail(key, "expected a list such as [1, 2]");
    std::vector<double> all;
    for (const SceneValue& item : value->list) all.push_back(as_number(key, item, unit));
    if (count > 0 && all.size() != count) fail(key, fmt::format("has {} numbers; expected {}", all.size(), count));
    return all;
}

std::optional<std::vector<double>> Section::numbers(const std::string& name) {
    const SceneKey& key = row(name);
    return numbers(name, key.unit, key.kind == SceneKey::Kind::list ? 0 : key.kind == SceneKey::Kind::place3 ? 3 : 2);
}

std::optional<Vec3> Section::vector(const std::string& key, std::string_view unit) {
    const auto all = numbers(key, unit, 3);
    if (!all) return {};
    return Vec3((*all)[0], (*all)[1], (*all)[2]);
}

std::optional<Vec3> Section::vector(const std::string& name) { return vector(name, row(name).unit); }

std::optional<std::pair<double, double>> Section::range(const std::string& key) {
    const auto all = numbers(key);
    if (!all) return {};
    if (!((*all)[0] < (*all)[1])) fail(key, "expected [low, high] with low < high");
    return std::pair{(*all)[0], (*all)[1]};
}

std::string Section::choice(const std::string& key, const std::string& fallback,
                            const std::vector<std::string>& known) {
    const std::string word = text(key, fallback);
    if (std::ranges::find(known, word) == known.end())
        fail(key, "not known; expected one of: " + joined(known) + did_you_mean(word, known));
    return word;
}

std::optional<std::string> Section::choice(const std::string& name) {
    const SceneKey& key = row(name);
    return ask(name) ? std::optional(choice(name, "", key.choices)) : std::nullopt;
}

std::optional<std::vector<std::string>> Section::choices(const std::string& key) {
    const std::vector<std::string>& known = row(key).choices;
    const SceneValue* value = ask(key);
    if (!value) return {};
    std::vector<std::string> words;
    const std::string expected = "expected a list of" + (known.empty() ? " names in quotes" : ": " + joined(known));
    if (value->kind != SceneValue::Kind::list || value->list.empty()) fail(key, expected);
    for (const SceneValue& item : value->list) {
        if (item.kind != SceneValue::Kind::text ||
            (!known.empty() && std::ranges::find(known, item.text) == known.end()))
            fail(key, item.shown() + " is not known; " + expected);
        if (std::ranges::find(words, item.text) == words.end()) words.push_back(item.text);
    }
    return words;
}

void Section::read_into(Scene& scene) {
    const auto take = [](auto& into, auto value) {
        if (value) into = std::move(*value);
    };
    for (const SceneKey& key : scene_keys()) {
        if (key.section != name_) continue;
        with_value(key, scene, [&](auto& value) {
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
}

bool Section::flag(const std::string& key, bool fallback) {
    const SceneValue* value = ask(key);
    if (!value) return fallback;
    if (value->kind != SceneValue::Kind::flag) fail(key, "expected true or false");
    return value->flag;
}

std::string Section::identifier(const std::string& key, const std::string& fallback) {
    const std::string name = text(key, fallback);
    const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    const auto allowed = [&](char c) { return letter(c) || (c >= '0' && c <= '9') || c == '_'; };
    if (name.empty() || name.size() > 40 || !letter(name[0]) || !std::all_of(name.begin(), name.end(), allowed))
        fail(key, "expected a name of letters, digits and '_' that begins with a letter, at most 40 long");
    return name;
}

std::optional<bool> Section::on_off(const std::string& key) {
    const SceneValue* value = ask(key);
    if (!value) return {};
    if (value->kind == SceneValue::Kind::flag) return value->flag;
    const std::string word = choice(key, "auto", {"auto", "on", "off"});
    return word == "auto" ? std::optional<bool>{} : word == "on";
}

void Section::finish() const {
    if (!table_) return;
    const std::vector<std::string> known(asked_.begin(), asked_.end());
    for (const auto& [key, value] : table_->members) {
        if (asked_.contains(key)) continue;
        const std::string what =
            name_.empty() ? "unknown section or key; the file knows: " : "unknown key; this section knows: ";
        const std::string place = fmt::format("{}:{}:{}", file_.string(), value.key_place.line, value.key_place.column);
        if (name_.empty() && value.kind == SceneValue::Kind::table)
            throw InputError(
                fmt::format("{}: [{}]: {}{}{}", place, key, what, joined(known), did_you_mean(key, known)));
        throw InputError(fmt::format("{}: {}{} = {}: {}{}{}", place, name_.empty() ? "" : "[" + name_ + "] ", key,
                                     value.shown(), what, joined(known), did_you_mean(key, known)));
    }
}

}  // namespace tw
