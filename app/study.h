#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "app/campaign.h"

namespace tw::app {

/// One run of a study, as it can be made by itself: `twinwake member FOLDER NUMBER`.
struct Member {
    std::string name, method;
    std::filesystem::path folder;
    RunRequest request;
    double seconds = 0, bytes = 0, elements = 0;  ///< predicted, on the cores that are asked for; of this machine
};
Member member_of(const CampaignRun& run);

/// A study as a graph: runs, none of which needs another, and a report that is made from what they left. What runs it
/// reads it from here: this machine (--jobs), Slurm (submit), Snakemake (--emit snakemake).
struct Study {
    std::filesystem::path out;       ///< folder of the results
    std::vector<std::string> words;  ///< the command that makes the report when --collect stands behind it
    bool overwrite = false, take_finished = true;  ///< see CampaignRules
    std::vector<Member> members = {};
    std::filesystem::path where = {};  ///< folder in which the command was given
};

/// The rules that follow from how the study is made.
CampaignRules rules_of(const Making& making, const std::filesystem::path& out);
/// Gives the study with those of its runs that are still to be made to `making.hand_over`. Returns the exit status.
int hand_over(const Making& making, Study study, Campaign& campaign, const std::vector<CampaignRun>& runs,
              const Common& common);

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
