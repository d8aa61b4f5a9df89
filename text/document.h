#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace tw {

/// Where something stands in a text file; line 0: on the command line.
struct Place {
    int line = 0, column = 0;
};

/// One value of a scene file with its place; tables keep their members in the order of the file.
struct TextValue {
    enum class Kind { text, number, flag, list, table, other } kind = Kind::other;
    std::string text;   ///< of a text; of a number as written in canonical form
    double number = 0;  ///< of a number [unit of its key]
    bool flag = false;
    std::vector<TextValue> list;
    struct Member;
    std::vector<Member> members;
    Place place;         ///< of the value
    Place key_place;     ///< of its key, when it has one
    std::string option;  ///< the command line option it came from, empty for the file

    const TextValue* find(const std::string& key) const;
    TextValue* find(const std::string& key);
    /// As it may stand in a message: strings quoted, control characters escaped, long ones cut.
    std::string shown() const;
};
struct TextValue::Member {
    std::string first;  ///< its key
    TextValue second;
};

/// The scene file as a tree. The only place that knows TOML. Throws InputError `file:line:column: ...`.
TextValue parse_document(const std::string& text, const std::filesystem::path& file);

}  // namespace tw
