#pragma once
#include <filesystem>
#include <functional>
#include <string>
#include <vector>

#include "compare/report/report_table.h"
#include "compare/truth/validation.h"

namespace tw {

/// The report as data; everything else that is written follows from it.
std::string validation_json(const ValidationReport& report);
/// Throws InputError: cannot be read, is no such report.
ValidationReport read_validation(const std::filesystem::path& file);

std::string validation_text(const ValidationReport& report,
                            const std::vector<ValidationChange>& changes);  ///< for a terminal
/// A page of its own. `changes`: since an earlier report, whose name is `since`; empty: it was not asked for.
std::string validation_html(const ValidationReport& report, const std::vector<ValidationChange>& changes,
                            const std::string& since);
std::string validation_csv(const ValidationReport& report);  ///< one row per case, quantity and method
/// JUnit's XML: a suite per case, a test per quantity and method. What falls short is a failure, or skipped where the
/// suite knows of it; a case that could not be run, or that left no value, is an error; what was not asked for is skipped.
std::string validation_junit(const ValidationReport& report);

/// One page of documentation, its name without folder and its Markdown.
struct MadePage {
    std::string name, text;
};
/// README.md with the tables of the whole suite, and one page a case.
std::vector<MadePage> validation_pages(const ValidationReport& report);

/// A Markdown page whose other text is written by hand. What stands between the lines `<!-- validate: families -->` (how
/// often the intervals hold the truth), `<!-- validate: values -->` (every value that was run) or
/// `<!-- validate: shortfalls -->` (those that miss, or have no value or interval) and the next `<!-- /validate -->` is made from the report, after a line that says from which. `name`: of the page, for messages.
/// Throws InputError: no such place, one without an end, a table of another name.
std::string with_tables(const std::string& page, const std::string& name, const ValidationReport& report);

// The tables of a validation report, the same on the terminal, the page and in the documentation.

/// A row per case, quantity and method: truth, value, E, U_val, goal, what became of it.
ReportTable validation_table(const ValidationReport& report);
/// A row per case and quantity, and in it each method's value, E, U_val and verdict. `name`: what stands for a case.
using CaseName = std::function<std::string(const ValidatedCase& one)>;
ReportTable short_table(const ValidationReport& report, const CaseName& name);
/// The same of one case, without its name, and with why a value is missing or odd.
ReportTable short_table(const ValidatedCase& one);
/// How many intervals hold the truth, by family and method.
ReportTable family_table(const ValidationReport& report);
/// The parts of U_val, the discretisation error by each method, and the values of all sizes. A part that is zero or
/// unknown in every row has no column.
ReportTable parts_table(const ValidatedCase& one);
/// How often the intervals of each method hold the truth.
ReportTable estimators_table(const ValidationReport& report);
ReportTable cost_table(const ValidatedCase& one);
/// `since`: the earlier report's name; empty: it is not said.
ReportTable change_table(const std::vector<ValidationChange>& changes, const std::string& since);

}  // namespace tw
