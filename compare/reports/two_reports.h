#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace tw {

/// A value of a report with the half width of its interval; nan: not known, or it has none.
struct ReportedValue {
    double value = 0, half_width = 0;  ///< [unit of the quantity]
};

/// One run in a report.json.
struct ReportedRun {
    std::string name;                               ///< "sph", "fvm", "fvm 2", ...
    std::map<std::string, double> numbers;          ///< of the record; nan where the report has null
    std::map<std::string, std::string> attributes;  ///< of the record
};

struct ReportedQuantity {
    std::string name, label, unit, definition;
    std::vector<ReportedValue> values;  ///< one per run
};

/// The values by which two reports are compared.
struct ReportFacts {
    std::filesystem::path file;
    std::vector<ReportedRun> runs;
    std::vector<ReportedQuantity> quantities;
};

/// Reads the report.json that `run`, `compare`, `ladder` and `sweep` leave. Throws InputError naming the file: it cannot
/// be read, is no such report, or has no run in it.
ReportFacts read_report(const std::filesystem::path& file);

/// How a value of a run in the second report is from the same run's in the first.
struct ReportChange {
    std::string quantity, label, unit;
    std::string run;  ///< name of the run, which both reports have
    ReportedValue first, second;
    double difference = 0;  ///< second - first [unit]; nan: one is not known
    /// Half width of its interval: root of both squares, as of independent values. nan: one of them has none.
    double interval = 0;       ///< [unit]
    std::string why_not = {};  ///< no difference is taken: the reason

    bool beyond_interval() const;
};

/// Something that one run says otherwise in the second report.
struct ReportOtherwise {
    std::string name, run;  ///< run: "all" where every run that both have differs in the same way
    std::string first, second;
    bool provenance = false;  ///< it says by whom and where the run was made, not what was solved
};

struct TwoReports {
    ReportFacts first, second;
    std::vector<ReportChange> headline;       ///< of the main quantities
    std::vector<ReportOtherwise> otherwise;   ///< what was solved before provenance
    std::vector<std::string> in_one_of_them;  ///< runs and main quantities that only one of the reports has
};

/// Runs are matched by their names. Throws InputError: no run of one report is in the other.
TwoReports compare_reports(ReportFacts first, ReportFacts second);

/// The tables for the terminal.
std::string text_of(const TwoReports& reports);
/// The same as JSON.
std::string json_of(const TwoReports& reports);

}  // namespace tw
