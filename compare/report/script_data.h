#pragma once
#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <string>

namespace tw {

/// A block of JSON for a script of the page. Within markup: no character of it can end the block or begin an element.
/// `attributes`: by which the script finds it.
inline std::string script_data(const std::string& attributes, const nlohmann::ordered_json& data) {
    std::string text;
    for (const char c : data.dump(-1, ' ', true, nlohmann::ordered_json::error_handler_t::replace))
        if (c == '<' || c == '>' || c == '&')
            text += fmt::format("\\u{:04x}", static_cast<int>(c));
        else
            text += c;
    return "<script type=\"application/json\" " + attributes + ">" + text + "</script>";
}

}  // namespace tw
