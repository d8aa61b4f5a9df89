#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "app/arguments/commands.h"
#include "compare/ladder/ladder.h"

namespace tw::app {

/// What finished runs leave for a ladder; their records are not kept.
struct LadderHarvest {
    std::vector<LadderRun> runs;
    std::vector<LadderVariation> variations;
    std::vector<std::string> left_out;         ///< runs that are missing, and why
    bool any_failed = false;                   ///< among those
    std::vector<std::string> unfinished = {};  ///< names of the runs that somebody else still makes

    /// A level; `file`: where its record lies.
    void take(RunRecord record, const std::filesystem::path& file);
    /// A variation counts only beside the run that it varies; a budget may have left that out.
    void drop_lone_variations();
};

/// The ladder of what was harvested; what was left out is in it.
Ladder ladder_of(const LadderHarvest& harvest, const std::vector<RunRecord>& measured = {});
/// ladder.md, ladder.json and a CSV for each method.
void write_tables(const Ladder& ladder, const std::filesystem::path& out);
/// These and report.html with the finest pair; the verdicts for the terminal.
Ladder report_ladder(const LadderHarvest& harvest, const std::vector<RunRecord>& measured,
                     const std::filesystem::path& out, const Common& common);
/// The quantities that do not agree, with their verdicts: why --require agree is not met. Empty: it is.
std::string not_agreeing(const Ladder& ladder);
/// What was measured, from records or their folders.
std::vector<RunRecord> measured_records(const std::vector<std::filesystem::path>& sources);

}  // namespace tw::app
