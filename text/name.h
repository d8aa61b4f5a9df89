#pragma once
#include <algorithm>
#include <string_view>

namespace tw {

/// Whether a text is a name: letters, digits, '_' and what `also` holds, a letter first, at most `longest` characters.
inline bool is_name(std::string_view text, std::size_t longest, std::string_view also = {}) {
    const auto letter = [](char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z'); };
    const auto allowed = [&](char c) {
        return letter(c) || (c >= '0' && c <= '9') || c == '_' || also.find(c) != std::string_view::npos;
    };
    return !text.empty() && text.size() <= longest && letter(text[0]) && std::all_of(text.begin(), text.end(), allowed);
}

}  // namespace tw
