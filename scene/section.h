#pragma once
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/vec3.h"
#include "scene/document.h"
#include "scene/keys.h"

namespace tw {

/// One [section] of a scene file. Every getter remembers its key; finish() reports keys nobody asked for. All errors
/// are InputError in the form
///   file:line:column: [section] key = value: what was found; what is expected
/// Getters that take a key alone find its kind, unit, range and choices in the table (keys.h); the others serve what is
/// in no table: parameters of shapes, and mapping files.
class Section {
public:
    /// `table` may be null: the section is absent and every key has its fallback. `place`: of the header.
    Section(std::filesystem::path file, std::string name, const SceneValue* table);

    bool present() const { return table_ != nullptr; }
    bool has(const std::string& key) const { return table_ && table_->find(key); }
    /// True when the value came from the command line.
    bool from_option(const std::string& key) const { return has(key) && !table_->find(key)->option.empty(); }
    const std::string& name() const { return name_; }
    const std::filesystem::path& file() const { return file_; }

    /// Reads every key of the table's section that has a slot in the scene; what is not written is left as it is.
    void read_into(Scene& scene);
    std::optional<double> number(const std::string& key);
    double number(const std::string& key, double fallback) { return number(key).value_or(fallback); }
    std::optional<int> whole(const std::string& key);
    std::optional<std::vector<double>> numbers(const std::string& key);
    std::optional<Vec3> vector(const std::string& key);
    std::optional<std::pair<double, double>> range(const std::string& key);
    std::optional<std::string> choice(const std::string& key);
    std::optional<std::vector<std::string>> choices(const std::string& key);

    /// Numbers take SI values or strings with a unit; `unit` is the SI unit ("m", "m/s", "rad", "-").
    /// `hint`: what follows the message that a value is out of range.
    std::optional<double> number(const std::string& key, std::string_view unit, Range range = any_value,
                                 const std::string& hint = {});
    double number(const std::string& key, double fallback, std::string_view unit, Range range = any_value);
    /// `count`: how many are expected; 0: any number.
    std::optional<std::vector<double>> numbers(const std::string& key, std::string_view unit, std::size_t count);
    std::optional<Vec3> vector(const std::string& key, std::string_view unit);
    std::string choice(const std::string& key, const std::string& fallback, const std::vector<std::string>& known);
    std::optional<std::string> text(const std::string& key);
    std::string text(const std::string& key, const std::string& fallback) { return text(key).value_or(fallback); }
    bool flag(const std::string& key, bool fallback);
    /// A name that later becomes part of file, patch or column names: a letter, then letters, digits, '_'.
    std::string identifier(const std::string& key, const std::string& fallback);
    /// "auto", "on" or "off" (also true and false): nothing for auto.
    std::optional<bool> on_off(const std::string& key);

    /// Throws InputError at the key (or at the section, or the file, when it is absent).
    [[noreturn]] void fail(const std::string& key, const std::string& message) const;
    /// `file:line:column: [section] key = value` for messages.
    std::string where(const std::string& key) const;
    /// Throws for the first key that was never asked for, with the known keys and the nearest one.
    void finish() const;
    /// Takes a key as known without reading it.
    void know(const std::string& key) { asked_.insert(key); }

private:
    /// The row of the table: list sections stand there without their brackets.
    const SceneKey& row(const std::string& key) const;
    const SceneValue* ask(const std::string& key);
    /// The spelling in which a key was written: an older one where the file has that. Throws when it has both.
    std::string written(const SceneKey& key);
    double as_number(const std::string& key, const SceneValue& value, std::string_view unit) const;

    std::filesystem::path file_;
    std::string name_;
    const SceneValue* table_;
    std::set<std::string> asked_;
};

/// "; did you mean 'draft'?" when one of `known` is near `word`, else empty.
std::string did_you_mean(const std::string& word, const std::vector<std::string>& known);

}  // namespace tw
