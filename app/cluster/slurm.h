#pragma once
#include <filesystem>
#include <map>
#include <string>
#include <vector>

namespace tw::app {

/// The answer of one of Slurm's programs.
struct SlurmAnswer {
    int status = 0;
    std::string text;  ///< standard output and standard error
    bool ok() const { return status == 0; }
};
/// Whether a program of Slurm is on the PATH.
bool slurm_has(const std::string& program);
/// Runs it without a shell and waits. Throws InputError: it is not there.
SlurmAnswer ask_slurm(const std::string& program, const std::vector<std::string>& arguments);

/// One submitted array, or the report.
struct SubmittedJob {
    std::string id;                         ///< as sbatch gave it
    std::vector<std::size_t> members = {};  ///< that it runs; none: the report
};
std::filesystem::path jobs_file(const std::filesystem::path& out);
void write_jobs(const std::filesystem::path& out, const std::vector<SubmittedJob>& jobs);
/// None where nothing was submitted. Throws InputError: its file cannot be read.
std::vector<SubmittedJob> read_jobs(const std::filesystem::path& out);
std::string ids_of(const std::vector<SubmittedJob>& jobs, char between);

/// State and reason of each job that the queue holds, by "12" or "12_3": "RUNNING node2". Nothing where Slurm says
/// nothing.
std::map<std::string, std::string> queued(const std::vector<SubmittedJob>& jobs);
/// The same of jobs that have ended, where Slurm keeps accounts.
std::map<std::string, std::string> accounted(const std::vector<SubmittedJob>& jobs);
/// Throws InputError: jobs of this study are in the queue.
void refuse_submitted(const std::filesystem::path& out);

}  // namespace tw::app
