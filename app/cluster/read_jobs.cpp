#include <algorithm>
#include <cctype>

#include "app/cluster/slurm.h"
#include "app/study/study.h"
#include "base/errors.h"
#include "base/own_json.h"

namespace tw::app {

std::filesystem::path jobs_file(const std::filesystem::path& out) { return study_folder(out) / "jobs.json"; }

std::vector<SubmittedJob> read_jobs(const std::filesystem::path& out) {
    const std::filesystem::path file = jobs_file(out);
    if (!std::filesystem::exists(file)) return {};
    std::vector<SubmittedJob> jobs;
    read_own_json(file, [&](const nlohmann::json& json) {
        for (const auto& job : json) {
            SubmittedJob& read = jobs.emplace_back(job.at("id"));
            // It becomes a word of Slurm's programs.
            if (read.id.empty() || !std::ranges::all_of(read.id, [](unsigned char c) { return std::isdigit(c); }))
                throw InputError(file.string() + ": an id is no number of a job of Slurm's: " + read.id);
            for (const auto& member : job.at("members")) {
                if (!member.is_number_unsigned()) throw InputError(file.string() + ": a member is no whole number");
                read.members.push_back(member);
            }
        }
    });
    return jobs;
}

}  // namespace tw::app
