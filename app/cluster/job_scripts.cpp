#include "app/cluster/job_scripts.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <sstream>

#include "app/runs/solvers.h"
#include "compare/report/escape.h"
#include "text/units.h"

namespace tw::app {
namespace {

std::string memory_text(double bytes) { return fmt::format("{:.0f}M", 64 * std::ceil(bytes / 1048576 / 64)); }

std::string asked_by_site(const Site& site, bool with_gpus) {
    std::string text;
    for (const auto& [option, value] : {std::pair("account", site.account),
                                        {"partition", site.partition},
                                        {"qos", site.qos},
                                        {"gpus", with_gpus ? site.gpus : ""}})
        if (!value.empty()) text += fmt::format("#SBATCH --{}={}\n", option, value);
    return text;
}

/// The modules, and the program behind what the site puts before it.
std::string loaded(const Site& site) {
    std::string text;
    for (const std::string& module : site.modules) text += "module load " + shell_word(module) + "\n";
    return text;
}
std::string call(const Site& site, const std::string& program) {
    std::istringstream prefix(site.container);
    std::string text;
    for (std::string word; prefix >> word;) text += shell_word(word) + " ";
    return text + shell_word(site.program.empty() ? program : site.program);
}

double longest(const Site& site) { return site.time.empty() ? INFINITY : quantity(site.time, "s"); }

}  // namespace

std::string JobArray::name() const {
    return ranks > 1 ? fmt::format("{}_{}x{}", method, ranks, cores) : fmt::format("{}_{}", method, cores);
}

std::vector<JobArray> arrays_of(const Study& study, const Site& site) {
    std::vector<JobArray> arrays;
    for (std::size_t k = 0; k < study.members.size(); ++k) {
        const Member& m = study.members[k];
        const int cores = cores_of_rank(m, site.cores), ranks = m.request.ranks;
        auto found = std::ranges::find_if(
            arrays, [&](const JobArray& a) { return a.method == m.method && a.cores == cores && a.ranks == ranks; });
        if (found == arrays.end()) found = arrays.insert(arrays.end(), JobArray{m.method, cores, ranks});
        found->members.push_back(k);
        found->seconds = std::max(found->seconds, margin_of_time * m.seconds + least_time);
        found->bytes = std::max(found->bytes, margin_of_memory * m.bytes + least_memory);
    }
    for (JobArray& a : arrays) a.seconds = std::min(a.seconds, longest(site));
    return arrays;
}

std::string slurm_time(double seconds) {
    const long minutes = std::lround(std::ceil(std::min(seconds, 1e9) / 60));
    return fmt::format("{}-{:02}:{:02}:00", minutes / 1440, minutes / 60 % 24, minutes % 60);
}

std::string array_script(const JobArray& array, const Site& site, const std::string& program,
                         const std::string& probe) {
    const std::string limit = site.limit > 0 ? fmt::format("%{}", site.limit) : "";
    // Ranks are tasks, which mpirun finds; threads are cores of one task. interFoam starts its own mpirun, on one node.
    const bool cells = solver_of(array.method).elements_per_rank > 0, shared = array.ranks > 1;
    const std::string mpirun =
        shared ? fmt::format("mpirun -n {} --bind-to none --quiet ", array.ranks) : std::string();
    return fmt::format(
        R"script(#!/bin/bash
# Runs of a twinwake study, {method}, {each}: {cores}. What they are stands in study.json beside this file.
#SBATCH --job-name=twinwake-{name}
#SBATCH --array={members}{limit}
{place}#SBATCH --ntasks={tasks}
#SBATCH --cpus-per-task={per_task}
#SBATCH --{memory}
#SBATCH --time={time}
#SBATCH --requeue
#SBATCH --signal=B:TERM@120
#SBATCH --open-mode=append
#SBATCH --output=members/%a.log
{site}set -u
if [ "$(cat probe 2>/dev/null)" != {probe} ]; then
    echo "$PWD/probe is not seen on $(hostname): the folder of a study has to lie on a disk that all nodes share" >&2
    exit 2
fi
{modules}{mpirun}{call} member .. "$SLURM_ARRAY_TASK_ID" --threads {cores} --quiet &
run=$!
told=
trap 'told=1; kill -{signal} "$run" 2>/dev/null' TERM
while :; do
    wait "$run"
    status=$?
    [ -n "$told" ] || break
    told=   # the signal ended the wait, not the run
done
# Stopped by the clock with its state saved: back into the queue, and on from there.
job=${{SLURM_ARRAY_JOB_ID}}_$SLURM_ARRAY_TASK_ID
if [ "$status" = 5 ] && [ ! -e cancelled ] && [ "$(squeue -h -j "$job" -o %T)" = RUNNING ]; then
    scontrol requeue "$job"
fi
exit "$status"
)script",
        fmt::arg("method", array.method), fmt::arg("cores", array.cores),
        fmt::arg("members", fmt::join(array.members, ",")), fmt::arg("limit", limit),
        fmt::arg("name", fmt::format("{}-{}", array.method, array.name().substr(array.method.size() + 1))),
        fmt::arg("each", shared ? fmt::format("ranks each: {}, cores of a rank", array.ranks) : "cores each"),
        fmt::arg("place", shared ? "" : "#SBATCH --nodes=1\n"), fmt::arg("tasks", cells ? array.cores : array.ranks),
        fmt::arg("per_task", cells ? 1 : array.cores),
        fmt::arg("memory",
                 shared ? "mem-per-cpu=" + memory_text(array.bytes / array.cores) : "mem=" + memory_text(array.bytes)),
        fmt::arg("time", slurm_time(array.seconds)), fmt::arg("mpirun", mpirun),
        fmt::arg("signal", shared ? "USR1" : "TERM"),  // which mpirun hands on
        fmt::arg("site", asked_by_site(site, !cells)), fmt::arg("probe", shell_word(probe)),
        fmt::arg("modules", loaded(site)), fmt::arg("call", call(site, program)));
}

std::string report_script(const Study& study, const Site& site, const std::string& program, double bytes) {
    std::string words;
    for (const std::string& word : study.words) words += " " + shell_word(word);
    return fmt::format(R"script(#!/bin/bash
# The report of a twinwake study, from the runs that are finished; begun when all jobs of its runs have ended.
#SBATCH --job-name=twinwake-report
#SBATCH --nodes=1
#SBATCH --ntasks=1
#SBATCH --cpus-per-task=1
#SBATCH --mem={}
#SBATCH --time={}
#SBATCH --output=report.log
{}set -u
cd {} || exit 2
{}exec {}{} --collect
)script",
                       memory_text(bytes), slurm_time(std::min(3600.0, longest(site))), asked_by_site(site, false),
                       shell_word(study.where.string()), loaded(site), call(site, program), words);
}

}  // namespace tw::app
