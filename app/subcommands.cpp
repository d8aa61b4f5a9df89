#include "app/subcommands.h"

#include <CLI/CLI.hpp>
#include <memory>

#include "app/about.h"
#include "app/arguments/output.h"
#include "app/cluster/site.h"
#include "app/cluster/submit.h"
#include "app/command_options.h"
#include "app/study/study.h"
#include "scene/effects/registry.h"
#include "spray/read_study.h"
#include "suite/suite.h"

namespace tw::app {
namespace {

/// A row of the table: the options write into a command of their own, which `run` is then called with.
template <class Command>
Subcommand row(const char* name, const char* help, void (*options)(CLI::App&, Command&),
               int (*run)(const Command&, const Common&)) {
    return {name, help, [options, run](CLI::App& app) -> Call {
                const auto command = std::make_shared<Command>();
                options(app, *command);
                return [command, run](const Common& common) { return run(*command, common); };
            }};
}
Subcommand without_json(Subcommand row) {
    row.json = false;
    return row;
}
Subcommand with_about(Subcommand row, std::string about) {
    row.about = std::move(about);
    return row;
}

/// The options of a study that is run on this machine.
template <class Command, void (*options)(CLI::App&, Command&)>
void here(CLI::App& c, Command& command) {
    options(c, command);
    add_jobs(c, command.making);
}

/// A study's command that is given to Slurm.
template <class Command>
Subcommand submit_row(const char* name, const char* help, void (*options)(CLI::App&, Command&),
                      int (*run)(const Command&, const Common&)) {
    Subcommand row{name, help, [options, run](CLI::App& app) -> Call {
                       const auto command = std::make_shared<Command>();
                       const auto submit = std::make_shared<SubmitOptions>();
                       options(app, *command);
                       add_site(app, *submit);
                       command->making.hand_over = [submit](Study study, const Common& common) {
                           return submit_study(std::move(study), *submit, common);
                       };
                       return [command, submit, run](const Common& common) {
                           return run(*command, common_of_study(*submit, common));
                       };
                   }};
    row.about = about_site;
    return row;
}

int run_hull_action(const HullCommand& hull, const Common& common) {
    const int status = leaving_files([&] { return run_hull(hull, common); });
    if (status != done && common.quiet) complain(hull.in.string() + ": not usable; hull info without -q shows why");
    return status;
}

}  // namespace

std::vector<Subcommand> subcommands() {
    Subcommand hull{"hull", "inspect, repair, make and convert hull surfaces", {}};
    hull.below = {
        row("info", "size, volume and health findings of a surface", hull_info_options, run_hull_action),
        row("repair", "repair what is safe and write the result as STL", hull_repair_options, run_hull_action),
        row("convert", "other unit, axes or format: writes STL in metres, x to the stern, z up", hull_convert_options,
            run_hull_action),
        row("make", "a parametric hull; without a shape: the list of shapes and parameters", hull_make_options,
            run_hull_action),
    };
    Subcommand submit{"submit", "submit a study to Slurm: its runs as job arrays, and a last job for the report", {}};
    submit.below = {
        submit_row("run", "a scene with both methods, at its own size and two coarser ones", run_options, run_run),
        submit_row("ladder", "grid-convergence study: a scene at several sizes", grid_study_options, run_grid_study),
        submit_row("sweep", "a scene with every hull, speed, trim and wave length of lists", sweep_options, run_sweep),
        submit_row("ablate", "effects switched one at a time", ablate_options, run_ablate),
        submit_row("validate", "a suite of cases with known truths", validate_options, run_validate),
    };
    return {
        without_json(row("new", "write a scene file to start from", new_options, run_new)),
        row("check", "hull health, effects with reasons, size, memory and time; runs nothing", check_options,
            run_check),
        without_json(row("reference", "every section, key, effect and shape of a scene file, as Markdown",
                         reference_options, run_reference)),
        row("run",
            "run a scene with both methods at three sizes (--no-twins: at one) and compare them: verdicts that include "
            "the discretisation error",
            here<RunCommand, run_options>, run_run),
        row("compare", "compare run records: verdict and report; or two reports with each other", compare_options,
            run_compare),
        with_about(row("import", "a run record from CSV histories, DualSPHysics or another OpenFOAM case, for compare",
                       import_options, run_import),
                   about_import),
        row("ladder",
            "grid-convergence study: a scene at several sizes with both methods, verdicts that include the "
            "discretisation error",
            here<LadderCommand, grid_study_options>, run_grid_study),
        row("sweep", "a scene with every hull, speed, trim and wave length of lists: bias and scatter of the methods",
            here<SweepCommand, sweep_options>, run_sweep),
        with_about(row("ablate", "effects switched one at a time: what each changes, and what it costs",
                       here<AblateCommand, ablate_options>, run_ablate),
                   about_ablate + effects_text() + "\n"),
        with_about(row("validate", "a suite of cases with known truths: both methods judged, and what became worse",
                       here<ValidateCommand, validate_options>, run_validate),
                   suite_help),
        submit,
        row("status", "how far the runs in a folder are: time left, forces and checks so far", study_options,
            run_status),
        without_json(row("watch",
                         "progress, time left, forces and checks of the runs in a folder, until all have ended",
                         watch_options, run_watch)),
        without_json(row("cancel", "remove the jobs of a study from Slurm's queue; finished runs are kept",
                         study_options, run_cancel)),
        without_json(row("member", "one run of a study, as --jobs and the jobs of a cluster make it", member_options,
                         run_member)),
        with_about(row("uncertainty", "discretisation error of the finest value, from any table of a refinement study",
                       uncertainty_options, run_uncertainty),
                   about_uncertainty),
        hull,
        without_json(row("case", "write the OpenFOAM case of a scene, to inspect, change and run by hand", case_options,
                         run_case)),
        with_about(row("doctor", "checks the installation; tests OpenFOAM on a flow with an exact solution",
                       doctor_options, run_doctor),
                   about_openfoam),
        with_about(without_json(row("setup-openfoam",
                                    "build a sound interFoam and twinwake's libraries for it, from OpenFOAM's sources",
                                    setup_openfoam_options, run_setup_openfoam)),
                   about_setup_openfoam),
        without_json(row("film", "a film of both methods side by side, from the frames that the records have",
                         film_options, run_film)),
        row("stability",
            "where the particle solver is stable: maps over speed, deadrise, h/dp, time step and sound speed",
            stability_options, run_stability),
        with_about(
            row("spray", "water that left a run, flown as droplets through air, and the load it puts on a surface",
                spray_options, run_spray_command),
            spray::spray_study_help),
        row("bench", "throughput of the particle solver on this machine", bench_options, run_bench_command),
        without_json(row("completion", "completion of this command for a shell: source <(twinwake completion bash)",
                         completion_options, run_completion)),
    };
}

}  // namespace tw::app
