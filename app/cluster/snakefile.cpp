#include "app/arguments/output.h"
#include "app/cluster/job_scripts.h"
#include "app/cluster/submit.h"
#include "app/terminal/command_words.h"
#include "base/errors.h"

namespace tw::app {
namespace {

/// The graph is read from study.json: no text of a scene or a command line stands in the Snakefile.
constexpr const char* snakefile =
    R"snake(# The runs of a twinwake study and its report, for Snakemake; the study is study.json beside this file.
#
#   snakemake --directory study --snakefile study/Snakefile --cores 8
#
import json

with open("study.json") as file:
    study = json.load(file)
members = study["members"]

rule report:
    input: expand("members/{number}.done", number=range(len(members)))
    params: where=study["where"], words=[study["program"]] + study["report"]
    shell: "cd {params.where:q} && exec {params.words:q} --collect"

# A run that fails (3) does not keep the report from being made, which names it.
rule member:
    output: touch("members/{number}.done")
    log: "members/{number}.log"
    threads: lambda wildcards: members[int(wildcards.number)]["cores"]
    resources:
        mem_mb=lambda wildcards: int(members[int(wildcards.number)]["predicted"]["bytes"] * 1.3 / 1048576 + 512),
        runtime=lambda wildcards: int(members[int(wildcards.number)]["predicted"]["seconds"] * 2 / 60 + 10)
    params: program=study["program"], ranks=lambda wildcards: members[int(wildcards.number)]["ranks"]
    shell: "{params.program:q} member .. {wildcards.number} --threads $(( ({threads} - 1) / {params.ranks} + 1 )) --quiet >>{log:q} 2>&1 || [ $? = 3 ]"
)snake";

}  // namespace

int write_snakefile(Study study, const Common& common) {
    if (study.members.empty())
        throw InputError(study.out.string() +
                         ": every run is finished; the same command with --collect makes the report");
    study.words = without_options(study.words, {{"--emit", 1}, {"--json", 1}});
    write_study(study);
    const std::filesystem::path file = study_folder(study.out) / "Snakefile";
    write_file(file, snakefile);
    say(common, file.string() + ": written; run it with snakemake --directory " + study_folder(study.out).string() +
                    " --snakefile " + file.string() + " --cores N\n");
    return done;
}

}  // namespace tw::app
