#pragma once
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "record/run_record.h"

namespace tw {

/// 95 % interval of a settled mean, or why there is none.
struct MeanValue {
    bool known = false;
    double value = std::numeric_limits<double>::quiet_NaN();
    double half_width = std::numeric_limits<double>::quiet_NaN();  ///< of the 95 % interval
    double from = 0, to = 0;       ///< the window used [s]
    double n_effective = 0;
    std::string why_not;           ///< "record too short: about 0.8 s more is needed"
};

enum class Verdict { agree, differ, undecided, not_comparable };
std::string to_string(Verdict verdict);

struct Quantity {
    std::string name, unit, definition;
    std::vector<MeanValue> values;       ///< one per source
    double difference = std::numeric_limits<double>::quiet_NaN();        ///< source B - source A
    double interval = std::numeric_limits<double>::quiet_NaN();          ///< half width of its 95 % interval
    double per_cent = std::numeric_limits<double>::quiet_NaN();          ///< difference over the mean of the two, in per cent
    Verdict verdict = Verdict::not_comparable;
    std::string remark;
    bool judged = true;                  ///< raw maxima are shown, not judged
};

struct Comparison {
    std::vector<RunRecord> sources;
    std::vector<Quantity> quantities;
    std::vector<std::string> banners;    ///< warnings that stand on top of the report
};

struct CompareOptions {
    bool force = false;             ///< compare records of different scenes, with a banner
    double agree_within = 0.05;     ///< target of AGREE, as a fraction
};

/// Throws InputError when the records cannot be compared (different scene or hull without `force`, ...).
Comparison compare_records(std::vector<RunRecord> sources, const CompareOptions& options = {});

/// report.html (self-contained), report.json, quantities.csv, series.csv, figures/.
struct ReportFiles {
    std::filesystem::path html, json, csv;
};
ReportFiles write_report(const Comparison& comparison, const std::filesystem::path& folder);
std::string comparison_json(const Comparison& comparison);
/// The table and verdict for the terminal.
std::string summary_text(const Comparison& comparison);

}  // namespace tw
