#pragma once
#include <string>

#include "compare/compare.h"
#include "compare/report/figures.h"

namespace tw {

/// The whole report as one self-contained HTML page without scripts; every text from a record is escaped.
std::string report_html(const Comparison& comparison, const Figures& figures);

}  // namespace tw
