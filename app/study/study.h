#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "app/runs/run_method.h"

namespace tw::app {

/// One run of a study, as it can be made by itself: `twinwake member FOLDER NUMBER`.
struct Member {
    std::string name, method;
    std::filesystem::path folder;
    RunRequest request;
    double seconds = 0, bytes = 0,
           elements = 0;  ///< predicted, on the cores that are asked for; of this machine [s], [bytes], [-]
};

/// Elements that are worth a core.
inline constexpr double elements_per_job_core = 20000;
/// Cores that a run of so many elements is given: a power of two, so that there are few arrays.
int job_cores(double elements, int most = 32);
/// Of a rank of a member of a study, or of all of it: its own threads, else by its elements.
int cores_of_rank(const Member& member, int most = 32);

/// A study as a graph: runs, none of which needs another, and a report that is made from what they left. What runs it
/// reads it from here: this machine (--jobs), Slurm (submit), Snakemake (--emit snakemake).
struct Study {
    std::filesystem::path out;       ///< folder of the results
    std::vector<std::string> words;  ///< the command that makes the report when --collect stands behind it
    bool overwrite = false, take_finished = true;  ///< see CampaignRules (campaign.h)
    std::vector<Member> members = {};
    std::filesystem::path where = {};  ///< folder in which the command was given
};

/// out/study: what is known of the study beside its results.
std::filesystem::path study_folder(const std::filesystem::path& out);
std::filesystem::path state_file(const std::filesystem::path& out, std::size_t number);
std::filesystem::path log_file(const std::filesystem::path& out, std::size_t number);

/// Writes study/study.json, and takes away what members of an earlier one have told. Throws InputError.
void write_study(const Study& study);
/// Throws InputError: there is none in this folder of results, or it cannot be read.
Study read_study(const std::filesystem::path& out);
/// Why the run in this folder is not finished, as far as its study knows.
std::string why_unfinished(const std::filesystem::path& out, const std::filesystem::path& folder);

}  // namespace tw::app
