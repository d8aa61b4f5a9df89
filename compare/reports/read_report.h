#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace tw {

/// A value of a report with the half width of its interval; nan: not known, or it has none.
struct ReportedValue {
    double value = 0, half_width = 0;
};

/// What a report.json says of one of its runs.
struct ReportedRun {
    std::string name;                               ///< "sph", "fvm", "fvm 2", ...
    std::map<std::string, double> numbers;          ///< of the record; nan where the report has null
    std::map<std::string, std::string> attributes;  ///< of the record
};

struct ReportedQuantity {
    std::string name, label, unit, definition;
    std::vector<ReportedValue> values;  ///< one per run
};

/// What two reports are compared by.
struct ReportFacts {
    std::filesystem::path file;
    std::vector<ReportedRun> runs;
    std::vector<ReportedQuantity> quantities;
};

/// Reads the report.json that `run`, `compare`, `ladder` and `sweep` leave. Throws InputError naming the file: it cannot
/// be read, is no such report, or has no run in it.
ReportFacts read_report(const std::filesystem::path& file);

}  // namespace tw
