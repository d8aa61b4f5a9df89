#pragma once
#include <cmath>
#include <filesystem>
#include <limits>
#include <span>
#include <string>
#include <vector>

#include "record/run_record.h"
#include "statistics/settled_mean.h"

namespace tw {

/// 95 % interval of a settled mean, or why there is none, and what else is known of it.
struct MeanValue : SettledMean {
    MeanValue() = default;
    MeanValue(const SettledMean& mean) : SettledMean(mean) {}
    /// Half widths from runs of other sizes (ladder/judge_by_sizes.h); nan: not estimated, or there is none.
    double discretisation = std::numeric_limits<double>::quiet_NaN();  ///< [unit]
    double choices = std::numeric_limits<double>::quiet_NaN();  ///< box, sound speed, time step, uncertain input [unit]
    double uncertainty = std::numeric_limits<double>::quiet_NaN();  ///< of all of it [unit]
    std::string no_uncertainty;                                     ///< why the other sizes gave none
    /// What reading the value off its history leaves open below and above it (threshold, spacing, sampling), which no run
    /// of another size shows [unit]; in the outer interval alone (verdict/left_out.h). `reading_of`: what that is.
    double reading_below = 0, reading_above = 0;  ///< [unit]
    std::string reading_of = {};
    std::string not_resolved = {};  ///< why this source's value is not judged: "sound of the impact: ..."; empty: it is

    /// The widest interval that is known; nan: none, because the sizes do not converge or it is not judged.
    double bar() const {
        if (!not_resolved.empty()) return std::numeric_limits<double>::quiet_NaN();
        return no_uncertainty.empty() && !std::isfinite(uncertainty) ? half_width : uncertainty;
    }
};

/// agree and differ need runs of several sizes: without them nothing is known of the discretisation error, and two
/// values may only be said to be apart (not_estimated). no_answer: the interval is so wide that nothing is judged.
enum class Verdict { agree, differ, undecided, no_answer, not_converged, not_comparable, not_estimated };
std::string to_string(Verdict verdict);

/// How far one source of a quantity is from another, and what that says.
struct Difference {
    std::size_t a = 0, b = 1;                                      ///< places of the two among the sources
    double difference = std::numeric_limits<double>::quiet_NaN();  ///< source b - source a [unit]
    /// Half width of its 95 % interval: of statistics only where the verdict is not_estimated.
    double interval = std::numeric_limits<double>::quiet_NaN();  ///< [unit]
    double size = 0;  ///< what per cent refer to: mean of the two, at least the quantity's `scale` [unit]
    double per_cent = std::numeric_limits<double>::quiet_NaN();  ///< difference over the size, in per cent [%]
    Verdict verdict = Verdict::not_comparable;
    std::string remark = {};
    std::string sentence = {};  ///< the verdict to be forwarded, where runs of several sizes gave one
    std::string finding = {};   ///< the same without the quantity and the verdict, to stand beside them
    double seconds_to_target =
        std::numeric_limits<double>::quiet_NaN();  ///< of further runs, see grid_study/grid_study.h [s]
};

/// One compared number. Its own difference is that of the only two sources, or of the pair that lies farthest apart in
/// units of its interval. `name` is a stable key: drag, lift, trim_moment, splash_raised, splash_sheet_height,
/// splash_p95, splash_p99, splash_p99_9, airborne_volume, airborne_energy, splash_envelope, wake_width, wetted_length,
/// crest_y_0.75, trough_y_0.75, ...
struct Quantity : Difference {
    std::string name, unit, definition;
    std::string label;              ///< for people, e.g. "Lift"
    std::vector<MeanValue> values;  ///< one per source
    std::vector<Difference> pairs;  ///< of more than two sources: every pair of them, in their order
    std::string caveat;             ///< what the difference contains besides that of the methods
    bool judged = true;             ///< raw maxima are shown beside, and no grid study judges them
    /// Not judged, since what makes it is smaller than the runs resolve: "not resolved: the jet is 0.4 of ..."; empty:
    /// it is resolved.
    std::string not_resolved = {};
    /// Judged by a grid study all the same: a history's mean has no interval of its own, but its resolution gives it
    /// one.
    bool judged_in_grid_study = false;
    double scale = 0;  ///< |values| the target refers to are at least this [unit]

    /// Every pair, or the only difference there is.
    std::span<const Difference> differences() const {
        return pairs.empty() ? std::span<const Difference>(static_cast<const Difference*>(this), 1) : pairs;
    }
    std::span<Difference> differences() {
        return pairs.empty() ? std::span<Difference>(static_cast<Difference*>(this), 1) : pairs;
    }
};

/// The value of a quantity by an empirical formula or another reference; shown beside, never part of a verdict.
struct Reference {
    std::string quantity, unit;        ///< name of the quantity it stands beside
    std::string source;                ///< "Savitsky 1964"
    double value = 0, half_width = 0;  ///< [unit]
    std::string remark;
    bool in_range = true;     ///< of the formula; outside it is a hint at most
    bool of_one_run = false;  ///< it takes something from a run, as its wetted length: shown in the table alone
    bool measured = false;    ///< as the scene says, at the scene's own speed and attitude
    std::string bias = {};    ///< how far measurements lie from it, for the end of a sentence; empty: not known
};

/// One validity check of one run, of its record or made while it ran (certificate): value against limit.
struct ValidityCheck {
    std::string name, source, unit;  ///< source: the run's name
    double value = 0, limit = 0;     ///< [unit]
    bool pass = false;
    std::string remark;
    bool warns = false;  ///< what is not met is a warning
};

/// Free-surface elevation over a straight cut, mean over the settled frames.
struct Cut {
    bool along_x = true;  ///< along x at y = place, or along y at x = place
    double place = 0;     ///< [m]
    std::vector<double> position, elevation,
        deviation;  ///< [m]; elevation NaN under the hull; deviation: standard, over time
};

/// The results that follow from one record alone, before anything is compared.
struct Analysis {
    Table splash;                ///< splash measures per raster frame, see metrics/splash.h
    std::vector<Table> entries;  ///< cavity and crown of each body that moves, per raster frame, see metrics/entry.h
    std::vector<Cut> cuts;
    std::vector<float> mean_elevation;  ///< per raster column, x fastest; NaN under the hull [m]
    std::vector<float> envelope;        ///< highest connected water per raster column over the settled frames [m]
    double still_level = 0;             ///< [m]
    double settled_from = 0;            ///< first time that counts for the frames [s]
    double surface_from = 0;            ///< first time of the mean surface; in a tank the last frame's [s]
};

struct Comparison {
    std::vector<RunRecord> sources;
    std::vector<std::string> names;  ///< one per source: "sph", "fvm", "sph 2", ...
    std::vector<Analysis> analyses;  ///< one per source
    std::vector<Quantity> quantities;
    std::vector<Reference> references;
    std::vector<ValidityCheck> checks;
    std::vector<std::string>
        banners;                 ///< warnings that stand on top of the report, see all_banners in metrics/box_walls.h
    std::string walls;           ///< what those of its box do to the loads (metrics/box_walls.h); empty: little
    std::vector<std::string>
        tuned;                   ///< what was chosen by looking at results, a sentence each; the last of the banners
    double agree_within = 0.05;  ///< [-]
    double study_seconds = 0;    ///< wall time of all runs of the study [s]; 0: not known
    std::string discretisation_from;  ///< "runs of 3 sizes", "the coarser runs of prism, 6 m/s"; empty: not estimated

    const Quantity* find(const std::string& name) const;
    /// A source that failed: its values stand in the tables, and no difference is taken from them.
    bool failed(std::size_t source) const { return sources[source].state == "failed"; }
};

struct CompareOptions {
    bool force = false;          ///< compare records of different scenes, with a banner
    double agree_within = 0.05;  ///< target of AGREE, as a fraction [-]
    double fewest_flow_throughs =
        SettledRules{}.fewest_flow_throughs;  ///< a mean is not given from less settled time than this [length / speed]
    double fewest_independent = SettledRules{}.fewest_independent;  ///< nor from fewer independent samples [-]
    double largest_error =
        SettledRules{}.largest_error;  ///< nor with a larger standard error, as a fraction of the mean
};

/// Differences are taken between every two sources. One source alone is accepted: its values stand without a verdict. Throws InputError when the records
/// cannot be compared (different scene or hull without `force`, ...).
Comparison compare_records(std::vector<RunRecord> sources, const CompareOptions& options = {});

/// report.html (self-contained), report.json, quantities.csv, series.csv, figures/.
struct ReportFiles {
    std::filesystem::path html, json, csv;
};
/// `details`: markup that stands below the verdicts, e.g. ladder_html.
ReportFiles write_report(const Comparison& comparison, const std::filesystem::path& folder,
                         const std::string& details = {});
std::string comparison_json(const Comparison& comparison);
/// The table and verdict for the terminal.
std::string summary_text(const Comparison& comparison);

}  // namespace tw
