#include "text/document.h"

#define TOML_HEADER_ONLY 0
#define TOML_SHARED_LIB 1
#include <fmt/format.h>
#include <toml++/toml.h>

#include <algorithm>

#include "base/errors.h"
#include "text/document_limits.h"

namespace tw {
namespace {

Place place_of(const toml::source_region& region) {
    return {static_cast<int>(region.begin.line), static_cast<int>(region.begin.column)};
}

TextValue converted(const toml::node& node);

TextValue converted_table(const toml::table& table) {
    TextValue v;
    v.kind = TextValue::Kind::table;
    for (const auto& [key, node] : table) {
        TextValue member = converted(node);
        member.key_place = place_of(key.source());
        v.members.push_back({std::string(key.str()), std::move(member)});
    }
    // toml++ sorts by name; people expect the order of their file.
    std::stable_sort(v.members.begin(), v.members.end(), [](const auto& a, const auto& b) {
        return std::pair(a.second.key_place.line, a.second.key_place.column) <
               std::pair(b.second.key_place.line, b.second.key_place.column);
    });
    return v;
}

TextValue converted(const toml::node& node) {
    TextValue v;
    if (const auto* table = node.as_table()) {
        v = converted_table(*table);
    } else if (const auto* array = node.as_array()) {
        v.kind = TextValue::Kind::list;
        for (const toml::node& item : *array) v.list.push_back(converted(item));
    } else if (const auto* text = node.as_string()) {
        v.kind = TextValue::Kind::text;
        v.text = text->get();
    } else if (const auto* integer = node.as_integer()) {
        v.kind = TextValue::Kind::number;
        v.number = static_cast<double>(integer->get());
        v.text = fmt::format("{}", integer->get());
    } else if (const auto* real = node.as_floating_point()) {
        v.kind = TextValue::Kind::number;
        v.number = real->get();
        v.text = fmt::format("{}", real->get());
    } else if (const auto* flag = node.as_boolean()) {
        v.kind = TextValue::Kind::flag;
        v.flag = flag->get();
    }
    v.place = place_of(node.source());
    return v;
}

std::string quoted(const std::string& text) {
    std::string out = "\"";
    for (const char c : text.substr(0, 60)) {
        if (c == '"' || c == '\\')
            out += std::string("\\") + c;
        else if (static_cast<unsigned char>(c) < 0x20 || c == 0x7f)
            out += fmt::format("\\x{:02x}", static_cast<unsigned char>(c));
        else
            out += c;
    }
    return out + (text.size() > 60 ? "...\"" : "\"");
}

}  // namespace

const TextValue* TextValue::find(const std::string& key) const {
    const auto it = std::find_if(members.begin(), members.end(), [&](const auto& m) { return m.first == key; });
    return it == members.end() ? nullptr : &it->second;
}
TextValue* TextValue::find(const std::string& key) { return const_cast<TextValue*>(std::as_const(*this).find(key)); }

std::string TextValue::shown() const {
    switch (kind) {
        case Kind::text: return quoted(text);
        case Kind::number: return text;
        case Kind::flag: return flag ? "true" : "false";
        case Kind::table: return "{...}";
        case Kind::other: return "a date or time";
        case Kind::list: break;
    }
    std::string out = "[";
    for (std::size_t i = 0; i < list.size() && out.size() < 80; ++i) out += (i > 0 ? ", " : "") + list[i].shown();
    return out + "]";
}

TextValue parse_document(const std::string& text, const std::filesystem::path& file) {
    refuse_senseless_document(text, file);
    try {
        return converted_table(toml::parse(std::string_view(text), std::string_view("scene")));
    } catch (const toml::parse_error& e) {
        const Place at = place_of(e.source());
        throw InputError(
            fmt::format("{}:{}:{}: not valid TOML: {}", file.string(), at.line, at.column, e.description()));
    }
}

}  // namespace tw
