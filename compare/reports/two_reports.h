#pragma once
#include <string>
#include <vector>

#include "compare/report/report_table.h"
#include "compare/reports/read_report.h"

namespace tw {

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
