#pragma once
#include <string>

#include "compare/compare.h"
#include "compare/report/figures.h"

namespace tw {

// What stands in the files of a report, beside report.json (comparison_json in compare.h).

/// The whole report as one self-contained HTML page; its only script, the 3-D view, is allowed by its hash. Every text
/// from a record is escaped.
/// `details`: markup that stands below the table of verdicts, e.g. ladder_html.
std::string report_html(const Comparison& comparison, const Figures& figures, const std::string& details = {});

/// One row per quantity: name, unit, value and interval per source, difference, interval, per cent, verdict.
std::string quantities_csv(const Comparison& comparison);
/// Long form: source, table, column, unit, time, value; forces thinned to at most 5000 rows per column.
std::string series_csv(const Comparison& comparison);

}  // namespace tw
