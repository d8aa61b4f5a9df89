#pragma once
#include <string>

#include "compare/report/escape.h"
#include "compare/report/style.h"

namespace tw {

/// Everything of a self-contained page before its body: it loads nothing from anywhere. `title`: plain text.
/// `style`: rules beside the report's own. `scripts`: CSP sources of those that may run
/// (page_scripts.h); empty: none may.
inline std::string page_begin(const std::string& title, const std::string& style = {},
                              const std::string& scripts = {}) {
    return "<!DOCTYPE html>\n<html lang=\"en\"><head><meta charset=\"utf-8\"><meta name=\"viewport\" "
           "content=\"width=device-width, initial-scale=1\">"
           "<meta http-equiv=\"Content-Security-Policy\" content=\"default-src 'none'; base-uri 'none'; form-action "
           "'none'; img-src data:; style-src "
           "'unsafe-inline'" +
           (scripts.empty() ? "" : "; script-src " + scripts) + "\"><title>" + escaped(title) + "</title><style>" +
           report_style + style + "</style></head><body><main>";
}
inline constexpr const char* page_end = "</main></body></html>\n";

}  // namespace tw
