#pragma once
#include <filesystem>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <vector>

#include "base/vec3.h"
#include "text/document.h"
#include "text/range.h"

namespace tw {

/// One [section] of a text file. Every getter remembers its key; finish() reports keys nobody asked for. All errors are
/// InputError in the form
///   file:line:column: [section] key = value: what was found; what is expected
/// Numbers take SI values or texts with a unit; `unit` is the SI unit ("m", "m/s", "rad", "-").
class Section {
public:
    /// `table` may be null: the section is absent and every key has its fallback. It has to outlive the section. The
    /// document itself is the section without a name.
    Section(std::filesystem::path file, std::string name, const TextValue* table);

    bool present() const { return table_ != nullptr; }
    bool has(const std::string& key) const { return table_ && table_->find(key); }
    /// Whether a number was written without a unit: as a number, or as a text that holds nothing else. False for one of
    /// the command line.
    bool without_unit(const std::string& key) const;
    /// True when the value came from the command line.
    bool from_option(const std::string& key) const { return has(key) && !table_->find(key)->option.empty(); }
    const std::string& name() const { return name_; }
    const std::filesystem::path& file() const { return file_; }

    /// The section [name] below this one, present or not.
    Section section(const std::string& name);
    /// The sections [[name]] below this one, any number of them.
    std::vector<Section> sections(const std::string& name);

    /// `hint`: what follows the message that a value is out of range.
    std::optional<double> number(const std::string& key, std::string_view unit, Range range = any_value,
                                 const std::string& hint = {});
    double number(const std::string& key, double fallback, std::string_view unit, Range range = any_value);
    /// `count`: how many are expected; 0: any number.
    std::optional<std::vector<double>> numbers(const std::string& key, std::string_view unit, std::size_t count);
    std::optional<Vec3> vector(const std::string& key, std::string_view unit);
    std::optional<std::pair<double, double>> range(const std::string& key, std::string_view unit);
    std::string choice(const std::string& key, const std::string& fallback, const std::vector<std::string>& known);
    /// A list of some of `known`, each once; of any names where there are none.
    std::optional<std::vector<std::string>> choices(const std::string& key, const std::vector<std::string>& known);
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
    const TextValue* ask(const std::string& key);
    double as_number(const std::string& key, const TextValue& value, std::string_view unit) const;

    std::filesystem::path file_;
    std::string name_;
    const TextValue* table_;
    std::set<std::string> asked_;
};

}  // namespace tw
