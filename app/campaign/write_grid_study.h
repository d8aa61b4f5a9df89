#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "app/arguments/commands.h"
#include "compare/grid_study/grid_study.h"

namespace tw::app {

/// What finished runs leave for a grid study; their records are not kept.
struct GridStudyHarvest {
    std::vector<GridStudyRun> runs;
    std::vector<GridStudyVariation> variations;
    std::vector<std::string> left_out;         ///< runs that are missing, and why
    bool any_failed = false;                   ///< among those
    std::vector<std::string> unfinished = {};  ///< names of the runs that somebody else still makes

    /// A level; `file`: where its record lies.
    void take(RunRecord record, const std::filesystem::path& file);
    /// A variation counts only beside the run that it varies; a budget may have left that out.
    void drop_lone_variations();
};

/// The grid study of what was harvested; what was left out is in it.
GridStudy grid_study_of(const GridStudyHarvest& harvest, const std::vector<RunRecord>& measured = {});
/// grid study.md, grid study.json and a CSV for each method.
void write_tables(const GridStudy& grid_study, const std::filesystem::path& out);
/// These and report.html with the finest pair; the verdicts for the terminal.
GridStudy report_grid_study(const GridStudyHarvest& harvest, const std::vector<RunRecord>& measured,
                            const std::filesystem::path& out, const Common& common);
/// The quantities that do not agree, with their verdicts: why --require agree is not met. Empty: it is.
std::string not_agreeing(const GridStudy& grid_study);
/// What was measured, from records or their folders.
std::vector<RunRecord> measured_records(const std::vector<std::filesystem::path>& sources);

}  // namespace tw::app
