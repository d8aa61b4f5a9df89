#pragma once
#include <map>
#include <string>

#include "app/cluster/site.h"
#include "app/study/study.h"

namespace tw::app {

struct SubmitOptions {
    Site site;
    std::filesystem::path site_file;  ///< empty: the usual one, if it is there
    bool dry_run = false;
    std::map<std::string, int> own;  ///< options of submit, not of the study's command, see without_options
};
/// Writes the batch scripts into the study's folder and submits them. Throws InputError, with Slurm's own words where
/// it refuses.
int submit_study(Study study, const SubmitOptions& options, const Common& common);
/// The study's command without `submit` and the options of it.
Common common_of_study(const SubmitOptions& options, const Common& common);

struct StudyCommand {
    std::filesystem::path folder;  ///< of the study's results
};
int run_status(const StudyCommand& command, const Common& common);
struct WatchCommand {
    std::filesystem::path folder;  ///< of a run or a study
    double every = 2;              ///< how often it looks [s]
};
/// Shows the status until nothing runs any longer; `done` if all runs are.
int run_watch(const WatchCommand& command, const Common& common);
int run_cancel(const StudyCommand& command, const Common& common);

/// Writes study/Snakefile, and runs nothing.
int write_snakefile(Study study, const Common& common);

}  // namespace tw::app
