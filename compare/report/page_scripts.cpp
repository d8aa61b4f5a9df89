#include "compare/report/page_scripts.h"

#include <fmt/format.h>

#include <nlohmann/json.hpp>

#include "base/sha256.h"
#include "compare/report/base64.h"

namespace tw {

std::string script_source(const std::string& script) {
    const std::string hex = sha256_hex(script);
    std::string digest;
    for (std::size_t k = 0; k < hex.size(); k += 2)
        digest += static_cast<char>(std::stoi(hex.substr(k, 2), nullptr, 16));
    return "'sha256-" + base64(digest) + "'";
}

std::string script_data(const std::string& attributes, const nlohmann::ordered_json& data) {
    std::string text;
    for (const char c : data.dump(-1, ' ', true, nlohmann::ordered_json::error_handler_t::replace))
        if (c == '<' || c == '>' || c == '&')
            text += fmt::format("\\u{:04x}", static_cast<int>(c));
        else
            text += c;
    return "<script type=\"application/json\" " + attributes + ">" + text + "</script>";
}

}  // namespace tw
