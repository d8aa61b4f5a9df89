#include "app/cluster/slurm.h"

#include <fmt/format.h>
#include <unistd.h>

#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "app/arguments/output.h"
#include "app/study/study.h"
#include "app/terminal/environment_here.h"
#include "base/atomic_file.h"
#include "base/errors.h"
#include "foam_cases/run/child.h"
#include "foam_cases/run/environment.h"

namespace tw::app {
namespace {

namespace fs = std::filesystem;

/// Lines "12_3|RUNNING|node2" as a map.
std::map<std::string, std::string> states_in(const SlurmAnswer& answer) {
    std::map<std::string, std::string> states;
    if (!answer.ok()) return states;
    std::istringstream lines(answer.text);
    for (std::string line; std::getline(lines, line);) {
        const auto bar = line.find('|');
        if (bar == line.npos) continue;
        std::string state = line.substr(bar + 1);
        std::ranges::replace(state, '|', ' ');
        states[line.substr(0, bar)] = state;
    }
    return states;
}

}  // namespace

bool slurm_has(const std::string& program) { return !find_program(environment_here(), program).empty(); }

SlurmAnswer ask_slurm(const std::string& program, const std::vector<std::string>& arguments) {
    const fs::path found = find_program(environment_here(), program);
    if (found.empty())
        throw InputError(
            fmt::format("Slurm is not on this machine: there is no {} on the PATH. Expected a cluster's "
                        "login node; --dry-run only writes the scripts, and --jobs N of run, ladder, sweep "
                        "and ablate runs side by side here",
                        program));
    static int number = 0;
    const fs::path said =
        fs::temp_directory_path() / fmt::format("twinwake_{}_{}_{}", ::getuid(), ::getpid(), ++number);
    ChildProcess child({found, arguments}, environment_here(), fs::current_path(), said);
    const Ended ended = child.wait();
    SlurmAnswer answer{ended.status, read_text(said)};
    fs::remove(said);
    return answer;
}

void write_jobs(const fs::path& out, const std::vector<SubmittedJob>& jobs) {
    nlohmann::ordered_json json = nlohmann::ordered_json::array();
    for (const SubmittedJob& job : jobs) json.push_back({{"id", job.id}, {"members", job.members}});
    write_file(jobs_file(out), json.dump(1) + "\n");
}

std::string ids_of(const std::vector<SubmittedJob>& jobs, char between) {
    std::string ids;
    for (const SubmittedJob& job : jobs) ids += (ids.empty() ? "" : std::string(1, between)) + job.id;
    return ids;
}

std::map<std::string, std::string> queued(const std::vector<SubmittedJob>& jobs) {
    if (jobs.empty() || !slurm_has("squeue")) return {};
    return states_in(
        ask_slurm("squeue", {"--noheader", "--array", "--jobs=" + ids_of(jobs, ','), "--format=%i|%T|%R"}));
}

std::map<std::string, std::string> accounted(const std::vector<SubmittedJob>& jobs) {
    if (jobs.empty() || !slurm_has("sacct")) return {};
    return states_in(ask_slurm("sacct", {"--noheader", "--parsable2", "--allocations", "--jobs=" + ids_of(jobs, ','),
                                         "--format=JobID,State,ExitCode,NodeList"}));
}

void refuse_submitted(const fs::path& out) {
    const std::vector<SubmittedJob> jobs = read_jobs(out);
    const auto alive = queued(jobs);
    if (alive.empty()) return;
    throw InputError(
        fmt::format("{}: this study has been submitted, and {} of its jobs {} in the queue ({}); twinwake status shows "
                    "them, twinwake cancel removes them",
                    out.string(), alive.size(), alive.size() == 1 ? "is" : "are", ids_of(jobs, ' ')));
}

}  // namespace tw::app
