#include "foam_cases/dictionary.h"

#include <charconv>
#include <cmath>

#include "base/errors.h"

namespace tw {
namespace {

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); }  // whatever the locale says
bool is_letter_or_digit(char c) { return is_letter(c) || (c >= '0' && c <= '9'); }

void check_characters(std::string_view text, std::string_view allowed, const char* what) {
    const auto refuse = [&](const std::string& why) {
        std::string shown;
        for (const char c : text.substr(0, 60)) shown += c >= ' ' && c <= '~' ? c : '?';
        throw InputError(std::string("'") + shown + "' cannot be " + what + " of an OpenFOAM dictionary: " + why +
                         "; use letters, digits and " + std::string(allowed));
    };
    if (text.empty()) refuse("it is empty");
    for (const char c : text)
        if (!is_letter_or_digit(c) && allowed.find(c) == std::string_view::npos)
            refuse("it holds a character with a meaning of its own");
    if (text.find("//") != std::string_view::npos || text.find("/*") != std::string_view::npos)
        refuse("it would open a comment");
    int depth = 0;
    for (const char c : text) {
        depth += c == '(' ? 1 : c == ')' ? -1 : 0;
        if (depth < 0) break;
    }
    if (depth != 0) refuse("its parentheses do not match");
}

std::string spelled(double number) {
    if (!std::isfinite(number))
        throw InputError("a number of the case is not finite; check the scene's sizes, speed and spacings");
    char buffer[32];
    const auto end = std::to_chars(buffer, buffer + sizeof buffer, number == 0 ? 0.0 : number).ptr;  // no "-0"
    return {buffer, end};
}

std::string indented(const std::string& text) {
    std::string out;
    bool line_start = true;
    for (const char c : text) {
        if (line_start && c != '\n') out += "    ";
        out += c;
        line_start = c == '\n';
    }
    return out;
}

}  // namespace

Word::Word(std::string_view tokens) : text(tokens) { check_characters(tokens, "_.:+-(), ", "a word"); }
Quoted::Quoted(std::string_view content) : text(content) {
    constexpr std::string_view case_folder = "$FOAM_CASE";
    if (content == case_folder) return;
    if (content.starts_with(std::string(case_folder) + "/")) content.remove_prefix(case_folder.size());
    check_characters(content, "_.:+-/(),<> ", "a string");
}

Value::Value(const Word& word) : text_(word.text) {}
Value::Value(const Quoted& quoted) : text_('"' + quoted.text + '"') {}
Value::Value(double number) : text_(spelled(number)) {}
Value::Value(bool yes_or_no) : text_(yes_or_no ? "yes" : "no") {}
Value::Value(const Vec3& v) : text_('(' + spelled(v.x()) + ' ' + spelled(v.y()) + ' ' + spelled(v.z()) + ')') {}
Value Value::whole_number(long long whole) {
    Value value;
    value.text_ = std::to_string(whole);
    return value;
}
Value::Value(const Dimensions& dimensions) {
    for (const int e : dimensions.exponents) text_ += (text_.empty() ? "[" : " ") + std::to_string(e);
    text_ += ']';
}
Value::Value(const std::vector<Value>& list) {
    std::size_t length = 0;
    bool lines = false;
    for (const Value& v : list) {
        length += v.text().size() + 1;
        lines = lines || v.is_block() || v.text().find('\n') != std::string::npos;
    }
    text_ = "(";
    if (lines || length > 90) {
        for (const Value& v : list) text_ += '\n' + indented(v.text());
        text_ += '\n';
    } else {
        for (const Value& v : list) text_ += (text_.size() > 1 ? " " : "") + v.text();
    }
    text_ += ')';
}
Value::Value(const Dictionary& dictionary)
    : text_(dictionary.empty() ? "{\n}" : "{\n" + indented(dictionary.text()) + '}'), block_(true) {}
Value Value::named(const Word& name, const Dictionary& dictionary) {
    Value value{dictionary};
    value.text_ = name.text + '\n' + value.text_;
    return value;
}
Value Value::sequence(const std::vector<Value>& parts) {
    Value value;
    for (const Value& p : parts) value.text_ += (value.text_.empty() ? "" : " ") + p.text();
    return value;
}

Value Value::nonuniform(const std::vector<Vec3>& cells) {
    Value value;
    value.text_ = "nonuniform List<vector> " + std::to_string(cells.size()) + "\n(\n";
    for (const Vec3& v : cells) value.text_ += Value(v).text() + '\n';
    value.text_ += ')';
    return value;
}

Value Value::nonuniform(const std::vector<double>& cells) {
    Value value;
    value.text_ = "nonuniform List<scalar> " + std::to_string(cells.size()) + "\n(\n";
    for (const double v : cells) value.text_ += Value(v).text() + '\n';
    value.text_ += ')';
    return value;
}

Key::Key(std::string_view word) : text(word) {
    check_characters(word, "_.:+-*(),", "a key");
    // OpenFOAM reads `div(phi,U)` as one word, but not a word that begins with a digit, a sign or a bracket.
    if (!is_letter(word[0]))
        throw InputError("'" + text + "' cannot be a key of an OpenFOAM dictionary: it must begin with a letter");
}
Key Key::pattern(std::string_view expression) {
    check_characters(expression, "_.*|()", "a key pattern");
    Key key;
    key.text = '"' + std::string(expression) + '"';
    return key;
}

Dictionary::Dictionary(std::initializer_list<Entry> entries) {
    for (const Entry& e : entries) add(e.first, e.second);
}
Dictionary& Dictionary::add(const Key& key, const Value& value) {
    for (const Entry& e : entries_)
        if (e.first.text == key.text)
            throw InputError("the key '" + key.text + "' would stand twice in one OpenFOAM dictionary");
    entries_.emplace_back(key, value);
    return *this;
}
Dictionary& Dictionary::add(const Dictionary& other) {
    for (const Entry& e : other.entries_) add(e.first, e.second);
    return *this;
}
std::string Dictionary::text() const {
    std::string out;
    for (const auto& [key, value] : entries_) {
        out += key.text;
        if (value.is_block()) {
            out += '\n' + value.text() + '\n';
            continue;
        }
        if (value.text().find('\n') != std::string::npos)
            out += '\n' + value.text();
        else
            out += std::string(key.text.size() < 16 ? 16 - key.text.size() : 1, ' ') + value.text();
        out += ";\n";
    }
    return out;
}

namespace {
std::string header_of(std::string_view foam_class, std::string_view object) {
    const Dictionary header{
        {"version", Word("2.0")}, {"format", Word("ascii")}, {"class", Word(foam_class)}, {"object", Word(object)}};
    return "FoamFile\n" + Value(header).text() + "\n\n";
}
}  // namespace

std::string foam_file(std::string_view foam_class, std::string_view object, const Dictionary& entries) {
    return header_of(foam_class, object) + entries.text();
}

std::string foam_list_file(std::string_view foam_class, std::string_view object, const List& elements) {
    std::string text = header_of(foam_class, object) + std::to_string(elements.size()) + "\n(\n";
    for (const Value& e : elements) text += e.text() + '\n';
    return text + ")\n";
}

std::string word_from(std::string_view text, std::string_view fallback) {
    std::string word;
    for (const char c : text) word += is_letter_or_digit(c) ? c : '_';
    if (word.empty()) return std::string(fallback);
    if (!is_letter(word[0])) word.insert(0, "part_");
    return word;
}

}  // namespace tw
