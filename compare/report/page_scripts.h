#pragma once

namespace tw {

/// The scripts of the report's page (report/page/), each one text; empty in a build where npm could not bring their
/// libraries.
extern const char* const plots_script;
extern const char* const view3d_script;

}  // namespace tw
