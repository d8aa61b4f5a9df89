#include "text/section.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/errors.h"
#include "text/did_you_mean.h"
#include "text/name.h"
#include "text/units.h"

namespace tw {
namespace {

std::string joined(const std::vector<std::string>& words) {
    std::string out;
    for (const std::string& w : words) out += (out.empty() ? "" : ", ") + w;
    return out;
}

/// Refuses a number beyond the largest and smallest of text/range.h.
void check_size(const Section& section, const std::string& key, double si, std::string_view unit) {
    if (std::abs(si) > largest_number)
        section.fail(key, fmt::format("too large; expected at most {} in size", value_text(largest_number, unit)));
    if (si != 0 && std::abs(si) < smallest_number)
        section.fail(key, fmt::format("too small; expected at least {} in size, or 0 where the key takes it",
                                      value_text(smallest_number, unit)));
}

}  // namespace

Section::Section(std::filesystem::path file, std::string name, const TextValue* table)
    : file_(std::move(file)), name_(std::move(name)), table_(table) {}

Section Section::section(const std::string& name) {
    const TextValue* table = ask(name);
    if (table && table->kind != TextValue::Kind::table) fail(name, "expected a section [" + name + "]");
    return {file_, name, table};
}

std::vector<Section> Section::sections(const std::string& name) {
    std::vector<Section> all;
    const TextValue* list = ask(name);
    if (!list) return all;
    const auto is_table = [](const TextValue& item) { return item.kind == TextValue::Kind::table; };
    if (list->kind != TextValue::Kind::list || !std::ranges::all_of(list->list, is_table))
        fail(name, "expected sections [[" + name + "]]");
    for (const TextValue& item : list->list) all.emplace_back(file_, "[" + name + "]", &item);
    return all;
}

std::string Section::where(const std::string& key) const {
    const TextValue* value = table_ ? table_->find(key) : nullptr;
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

const TextValue* Section::ask(const std::string& key) {
    asked_.insert(key);
    return table_ ? table_->find(key) : nullptr;
}

double Section::as_number(const std::string& key, const TextValue& value, std::string_view unit) const {
    double si = 0;
    if (value.kind == TextValue::Kind::number) {
        si = value.number;
        if (!std::isfinite(si)) fail(key, "not a finite number");
    } else if (value.kind == TextValue::Kind::text) {
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
    const TextValue* value = ask(key);
    if (!value) return {};
    const double si = as_number(key, *value, unit);
    if (!(si >= range.min && si <= range.max) || (range.open_min && si == range.min)) {
        std::string message = "out of range; expected " + range_text(range, unit);
        if (!hint.empty()) message += " (" + hint + ")";
        if (unit == "rad" && value->kind == TextValue::Kind::number)
            message += fmt::format(" (a plain number is in radians; write \"{} deg\" for degrees)", value->text);
        fail(key, message);
    }
    check_size(*this, key, si, unit);
    return si;
}

bool Section::without_unit(const std::string& key) const {
    if (!has(key) || from_option(key)) return false;
    const TextValue& value = *table_->find(key);
    return value.kind == TextValue::Kind::number || (value.kind == TextValue::Kind::text && !tw::has_unit(value.text));
}

double Section::number(const std::string& key, double fallback, std::string_view unit, Range range) {
    return number(key, unit, range).value_or(fallback);
}

std::optional<std::string> Section::text(const std::string& key) {
    const TextValue* value = ask(key);
    if (!value) return {};
    if (value->kind != TextValue::Kind::text) fail(key, "expected a text in quotes");
    return value->text;
}

std::optional<std::vector<double>> Section::numbers(const std::string& key, std::string_view unit, std::size_t count) {
    const TextValue* value = ask(key);
    if (!value) return {};
    if (value->kind != TextValue::Kind::list) fail(key, "expected a list such as [1, 2]");
    std::vector<double> all;
    for (const TextValue& item : value->list) {
        all.push_back(as_number(key, item, unit));
        check_size(*this, key, all.back(), unit);
    }
    if (count > 0 && all.size() != count) fail(key, fmt::format("has {} numbers; expected {}", all.size(), count));
    return all;
}

std::optional<Vec3> Section::vector(const std::string& key, std::string_view unit) {
    const auto all = numbers(key, unit, 3);
    if (!all) return {};
    return Vec3((*all)[0], (*all)[1], (*all)[2]);
}

std::optional<std::pair<double, double>> Section::range(const std::string& key, std::string_view unit) {
    const auto all = numbers(key, unit, 2);
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

std::optional<std::vector<std::string>> Section::choices(const std::string& key,
                                                         const std::vector<std::string>& known) {
    const TextValue* value = ask(key);
    if (!value) return {};
    std::vector<std::string> words;
    const std::string expected = "expected a list of" + (known.empty() ? " names in quotes" : ": " + joined(known));
    if (value->kind != TextValue::Kind::list || value->list.empty()) fail(key, expected);
    for (const TextValue& item : value->list) {
        if (item.kind != TextValue::Kind::text ||
            (!known.empty() && std::ranges::find(known, item.text) == known.end()))
            fail(key, item.shown() + " is not known; " + expected);
        if (std::ranges::find(words, item.text) == words.end()) words.push_back(item.text);
    }
    return words;
}

bool Section::flag(const std::string& key, bool fallback) {
    const TextValue* value = ask(key);
    if (!value) return fallback;
    if (value->kind != TextValue::Kind::flag) fail(key, "expected true or false");
    return value->flag;
}

std::string Section::identifier(const std::string& key, const std::string& fallback) {
    const std::string name = text(key, fallback);
    if (!is_name(name, 40))
        fail(key, "expected a name of letters, digits and '_' that begins with a letter, at most 40 long");
    return name;
}

std::optional<bool> Section::on_off(const std::string& key) {
    const TextValue* value = ask(key);
    if (!value) return {};
    if (value->kind == TextValue::Kind::flag) return value->flag;
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
        if (name_.empty() && value.kind == TextValue::Kind::table)
            throw InputError(
                fmt::format("{}: [{}]: {}{}{}", place, key, what, joined(known), did_you_mean(key, known)));
        throw InputError(fmt::format("{}: {}{} = {}: {}{}{}", place, name_.empty() ? "" : "[" + name_ + "] ", key,
                                     value.shown(), what, joined(known), did_you_mean(key, known)));
    }
}

}  // namespace tw
