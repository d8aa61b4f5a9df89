#pragma once
#include <string>

#include "compare/report/escape.h"
#include "compare/report/style.h"

namespace tw {

/// Everything of a self-contained page before its body: it loads nothing from anywhere. `title`: plain text.
/// `style`: rules beside the report's own. `script_hash`: CSP source of the one script that may run, "'sha256-...'";
/// empty: none may.
inline std::string page_begin(const std::string& title, const std::string& style = {},
                              const std::string& script_hash = {}) {
    return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
           "content=\"width=device-width, initial-scale=1\">"
           "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; img-src data:; style-src "
           "'unsafe-inline'" +
           (script_hash.empty() ? "" : "; script-src " + script_hash) + "\"><title>" + escaped(title) +
           "</title><style>" + report_style + style + "</style></head><body><main>";
}
inline constexpr const char* page_end = "</main></body></html>\n";

}  // namespace tw
