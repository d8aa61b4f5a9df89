#pragma once
#include <nlohmann/json_fwd.hpp>
#include <string>

namespace tw {

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
