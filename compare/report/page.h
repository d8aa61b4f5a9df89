#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

#include "compare/report/escape.h"

namespace tw {

/// Style sheet of the report: light and dark, print; curves take their colours from here.
extern const char* const report_style;

/// Everything of a self-contained page before its body: it loads nothing from anywhere. `title`: plain text.
/// `style`: rules beside the report's own. `scripts`: CSP sources of those that may run (script_source);
/// empty: none may.
std::string page_begin(const std::string& title, const std::string& style = {}, const std::string& scripts = {});
/// The same with the title as its heading and a line of facts below; plain text both.
std::string page_begin_with(const std::string& title, const std::string& facts);
inline constexpr const char* page_end = "</main></body></html>\n";

/// The scripts of the report's page (report/page/), each one text; empty in a build where npm could not bring their
/// libraries.
extern const char* const plots_script;
extern const char* const view3d_script;

/// By which a page's content-security policy names one script that may run: 'sha256-...' with its quotes.
std::string script_source(const std::string& script);

/// A block of JSON for a script of the page. Within markup: no character of it can end the block or begin an element.
/// `attributes`: by which the script finds it.
std::string script_data(const std::string& attributes, const nlohmann::ordered_json& data);

}  // namespace tw
