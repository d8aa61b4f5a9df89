#include "text/document_limits.h"

#include <fmt/format.h>

#include <string_view>

#include "base/errors.h"

namespace tw {
namespace {

constexpr int most_parts = 8;  // of a key; with 256 values within each other, which the parser allows, some 2000 tables
constexpr int most_tables = 10'000;

/// Where a comment or a string that begins at `at` ends: the place behind it. Of nothing of the kind: `at`.
std::size_t behind_text(std::string_view text, std::size_t at) {
    if (text[at] == '#') return std::min(text.find('\n', at), text.size());
    if (text[at] != '"' && text[at] != '\'') return at;
    const char mark = text[at];
    const std::string three(3, mark);
    const bool many_lines = text.substr(at, 3) == three;
    std::size_t k = at + (many_lines ? 3 : 1);
    while (k < text.size()) {
        if (mark == '"' && text[k] == '\\') {
            k += 2;
        } else if (many_lines ? text.substr(k, 3) == three : text[k] == mark) {
            k += many_lines ? 3 : 1;
            while (many_lines && k < text.size() && text[k] == mark) ++k;  // up to two may stand before the end
            return k;
        } else if (!many_lines && text[k] == '\n') {
            return k;
        } else {
            ++k;
        }
    }
    return text.size();
}

}  // namespace

void refuse_senseless_document(const std::string& text, const std::filesystem::path& file) {
    int line = 1, dots = 0, tables = 0;
    for (std::size_t at = 0; at < text.size();) {
        if (const std::size_t behind = behind_text(text, at); behind != at) {
            for (; at < behind && at < text.size(); ++at) line += text[at] == '\n';
            continue;
        }
        switch (const char c = text[at++]) {
            case '.':
                if (++dots >= most_parts)
                    throw InputError(
                        fmt::format("{}:{}: a key of more than {} parts with dots between them; expected "
                                    "few, such as run.duration",
                                    file.string(), line, most_parts));
                break;
            case '[':
            case '{':
                dots = 0;
                if (c == '{' || (at >= 2 && text[at - 2] == '\n') || at == 1) ++tables;
                if (tables > most_tables)
                    throw InputError(
                        fmt::format("{}:{}: more than {} tables; expected fewer. What has so many parts "
                                    "belongs into a file of its own",
                                    file.string(), line, most_tables));
                break;
            case '\n': ++line; [[fallthrough]];
            case '=':
            case ',':
            case ']':
            case '}': dots = 0; break;
            default: break;
        }
    }
}

}  // namespace tw
