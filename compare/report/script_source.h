#pragma once
#include <string>

namespace tw {

/// By which a page's content-security policy names one script that may run: 'sha256-...' with its quotes.
std::string script_source(const std::string& script);

}  // namespace tw
