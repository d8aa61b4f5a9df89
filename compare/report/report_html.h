#pragma once
#include <string>

#include "compare/compare.h"
#include "compare/report/figures.h"

namespace tw {

/// The whole report as one self-contained HTML page; its only script, the 3-D view, is allowed by its hash. Every text
/// from a record is escaped.
/// `details`: markup that stands below the table of verdicts, e.g. ladder_html.
std::string report_html(const Comparison& comparison, const Figures& figures, const std::string& details = {});

}  // namespace tw
