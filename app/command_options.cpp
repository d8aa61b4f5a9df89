#include "app/command_options.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <CLI/CLI.hpp>

#include "app/arguments/output.h"
#include "app/cluster/submit.h"
#include "app/runs/solvers.h"
#include "compare/uncertainty/convergence.h"
#include "scene/effects/registry.h"
#include "suite/suite.h"

namespace tw::app {
namespace {

// ---- options that several subcommands have

void add_effect(CLI::App& c, SceneArguments& scene) {
    c.add_option("--effect", scene.effects,
                 fmt::format("switch an effect on or off instead of the scene's choice, e.g. viscosity=on; can be "
                             "given again. Effects: {}",
                             fmt::join(effect_names(), ", ")))
        ->type_name("NAME=on|off")
        ->allow_extra_args(false);
}

void add_scene(CLI::App& c, SceneArguments& scene) {
    c.add_option("scene", scene.file, "scene file (TOML)")->required();
    c.add_option("--hull", scene.hull,
                 "swap the hull: this surface file instead of the scene's, in the same attitude and unit");
    c.add_option("--speed", scene.speed, "speed of the stream instead of the scene's, e.g. \"30 m/s\" or \"60 kn\"");
    c.add_option("--trim", scene.trim, "bow up, instead of the scene's, e.g. \"5 deg\"");
    c.add_option("--wave-length", scene.wave_length, "of the regular wave, instead of the scene's, e.g. \"2.5 m\"");
    c.add_option("--near-hull", scene.near_hull, "finest size instead of the scene's, e.g. \"25 mm\"");
    c.add_option("--spacing", scene.spacing, "largest size instead of the scene's");
    c.add_option(
        "--scale", scene.scale,
        "all sizes times this number, refinement levels kept: 2, 1.4142 and 1 make similar meshes, for convergence");
    c.add_option("--duration", scene.duration, "simulated time instead of the scene's, e.g. \"2 s\"");
    c.add_option("--device", scene.device,
                 "what makes the particles' steps: cpu, gpu, or auto for a GPU where one can, instead of the scene's")
        ->check(CLI::IsMember({"cpu", "gpu", "auto"}));
    add_effect(c, scene);
}

void add_method(CLI::App& c, std::string& method) {
    c.add_option("--method", method, fmt::format("{} instead of the scene's", fmt::join(method_choices(), ", ")))
        ->check(CLI::IsMember(method_choices()));
}

void add_threads(CLI::App& c, int& threads,
                 const char* help = "threads (particles) and ranks (mesh); all cores unless given") {
    c.add_option("--threads", threads, help)->check(CLI::Range(1, 4096));
}

CLI::Option* add_ranks(CLI::App& c, int& ranks, const char* help) {
    return c.add_option("--ranks", ranks, help)->check(CLI::Range(1, 65535));
}

void add_rerun(CLI::App& c, bool& overwrite) {
    c.add_flag("--overwrite", overwrite, "run anew whatever is not a finished run of this scene");
}

/// The one thing that --require knows.
void add_require_agree(CLI::App& c, bool& agree, const char* help) {
    c.add_option_function<std::string>(
         "--require", [&agree](const std::string&) { agree = true; }, help)
        ->check(CLI::IsMember({"agree"}));
}

}  // namespace

void add_unit_and_axes(CLI::App& c, std::string& unit, std::string& axes) {
    c.add_option("--unit", unit, "unit of the file: m, mm, cm, ft, in")->type_name("{m,mm,cm,ft,in}");
    c.add_option("--axes", axes, "file axes that become x (stern), y, z (up), e.g. -xyz");
}

void add_jobs(CLI::App& c, Making& making) {
    CLI::Option* jobs = c.add_option("--jobs", making.jobs,
                                     "runs side by side (where it is faster as many as there are cores, each on one, "
                                     "unless --threads is given; "
                                     "else 1), each a process of its own; of N they share the cores by predicted time, "
                                     "but for --threads, which "
                                     "each then has, and begin as cores and memory allow")
                            ->check(CLI::Range(1, 1024));
    CLI::Option* collect =
        c.add_flag("--collect", making.collect,
                   "run nothing: make the report from the runs that are finished, and name the others")
            ->excludes(jobs);
    c.add_option_function<std::string>(
         "--emit", [&making](const std::string&) { making.hand_over = write_snakefile; },
         "run nothing: write study/Snakefile of the same runs and report into the folder of the results")
        ->check(CLI::IsMember({"snakemake"}))
        ->excludes(jobs)
        ->excludes(collect);
}

/// Of the commands whose page has a part for runs that are not there yet.
void add_report_every(CLI::App& c, Making& making) {
    c.add_option("--report-every", making.report_every,
                 "make the report so often while the runs are made, from what is finished by then, e.g. 10min; it says "
                 "that it is provisional")
        ->type_name("TIME");
}

void add_site(CLI::App& c, SubmitOptions& submit) {
    Site& site = submit.site;
    const std::vector<CLI::Option*> own{
        c.add_option("--account", site.account, "account that is charged"),
        c.add_option("--partition", site.partition, "partition of the jobs"),
        c.add_option("--qos", site.qos, "quality of service"),
        c.add_option("--time", site.time,
                     "the longest a job may ask for, e.g. 12h; a run that needs longer continues in the next job")
            ->type_name("TIME"),
        c.add_option("--cores", site.cores, "at most for one run (32)")->check(CLI::Range(1, 4096)),
        c.add_option("--gpus", site.gpus, "as sbatch --gpus has it; not for interFoam"),
        c.add_option("--limit", site.limit, "runs of one array at a time")->check(CLI::Range(1, 100000)),
        c.add_option("--modules", site.modules, "module to load; can be given again")->allow_extra_args(false),
        c.add_option("--container", site.container, "words in front of the program, e.g. \"apptainer exec tw.sif\""),
        c.add_option("--site", submit.site_file, "site file with these and `program` (TOML), see below")
            ->type_name("FILE"),
        c.add_flag("--dry-run", submit.dry_run, "write the scripts, print what would be submitted, and submit nothing"),
    };
    for (CLI::Option* option : own) {
        option->group("Cluster");
        submit.own["--" + option->get_lnames().front()] = option->get_items_expected_max() > 0 ? 1 : 0;
    }
}

// ---- one function a subcommand, in the order of the table

void new_options(CLI::App& c, NewCommand& create) {
    c.add_option("template", create.kind, templates_in_words())
        ->type_name("TEMPLATE")
        ->required()
        ->check(CLI::IsMember(template_names()));
    c.add_option("file", create.file, "scene file to write")->required();
    c.add_option(
         "--from", create.from,
         "with the template hull: the hull's file, from whose size draft, speed and resolution are taken; with the "
         "template body: STEP, OBJ or STL file, each named solid of which becomes a body of the scene")
        ->type_name("FILE");
    add_unit_and_axes(c, create.unit, create.axes);
    c.add_flag("--overwrite", create.overwrite, "replace the file if it is there");
}

void check_options(CLI::App& c, CheckCommand& check) {
    add_scene(c, check.scene);
    add_threads(c, check.threads, "predict for this many threads (particles) and ranks (mesh); all cores unless given");
    add_ranks(c, check.ranks,
              "predict the memory and time of each of so many processes that share the particles (MPI), instead of the "
              "scene's number");
    c.add_option("--picture", check.picture,
                 "SVG file to write: side and plan view of the sizes of particles and cells round the hull");
    c.add_option("--html", check.html,
                 "page to write: what to look at first, that picture, the effects, and all that is printed");
}

void reference_options(CLI::App& c, ReferenceCommand& reference) {
    c.add_option("--out", reference.out, "file to write instead of standard output");
    c.add_option("--names", reference.names, "only the names, one on each line: effects or shapes")
        ->check(CLI::IsMember({"effects", "shapes"}));
}

void run_options(CLI::App& c, RunCommand& run) {
    add_scene(c, run.scene);
    run.method.clear();
    add_method(c, run.method);
    c.add_option("--out", run.out, "folder of the results (runs/<name of the scene file>)");
    CLI::Option* resume =
        c.add_flag("--resume", run.resume, "continue from the last saved state; only if scene and numerics match");
    c.add_flag("--overwrite", run.overwrite, "run anew in a folder that has a run")->excludes(resume);
    c.add_flag("!--no-twins", run.coarser_members,
               "leave out the coarser members of the grid triplet (1.4142 and 2 times the sizes, and one run in a "
               "wider box): then the discretisation error is not known, and there is no verdict");
    add_require_agree(c, run.require_agree,
                      "agree: exit status 4 unless every quantity agrees; needs the coarser runs");
    add_threads(c, run.threads);
    CLI::Option* ranks =
        add_ranks(c, run.ranks,
                  "share the particles among so many processes (MPI), each with its threads, instead of the scene's "
                  "[run] ranks; the same bits as one");
    CLI::Option* budget = c.add_option("--budget", run.budget,
                                       "choose the sizes: the finest, or the coarser ones, whose runs all together are "
                                       "predicted to take at most this time, e.g. 5min; coarser ones where the coarsest "
                                       "runs take longer than predicted (the scene's own sizes, however long they "
                                       "take)")
                              ->type_name("TIME")
                              ->excludes(ranks);
    for (const char* size : {"--scale", "--near-hull", "--spacing"}) budget->excludes(c.get_option(size));
    add_report_every(c, run.making);
}

void compare_options(CLI::App& c, CompareCommand& compare) {
    c.add_option("sources", compare.sources, "run records, or folders of runs or ladders; or two report.json files")
        ->required()
        ->expected(1, 64);
    c.add_option("--out", compare.out, "folder for report.html, report.json, CSV and figures");
    c.add_flag("--ladder", compare.grid_study,
               "the records are runs of one scene at several sizes: verdicts that include the discretisation error");
    c.add_option("--measured", compare.measured,
                 "with --ladder: a measurement, as written by twinwake import; can be given again")
        ->allow_extra_args(false);
    c.add_flag("--force", compare.force, "compare records of different scenes, with a banner");
    add_require_agree(
        c, compare.require_agree,
        "agree: exit status 4 unless every quantity agrees; needs --ladder, since runs of one size have no verdict");
}

void grid_study_options(CLI::App& c, LadderCommand& grid_study) {
    add_scene(c, grid_study.scene);
    add_method(c, grid_study.method);
    c.add_option("--levels", grid_study.levels, "number of sizes (4): the scene's own and coarser ones")
        ->check(CLI::Range(1, 8));
    c.add_option("--ratio", grid_study.ratio, "of neighbouring spacings (1.4142)")->check(CLI::Range(1.05, 4.0));
    c.add_flag(
        "!--no-variations", grid_study.variations,
        "leave out the runs with sound speed x 1.5, half the time step, half the Courant number and a wider box");
    c.add_flag("--surface", grid_study.surface,
               "one more run with interIsoFoam's geometric surface, where no body moves: the whole change enters the "
               "interval");
    c.add_flag(
        "!--no-fill", grid_study.fill,
        "leave out the sizes between the coarse ones, which distinguish scatter from a trend and narrow the interval");
    c.add_option("--measured", grid_study.measured,
                 "a measurement, as written by twinwake import: each method's finest value is compared with it; can be "
                 "given again")
        ->allow_extra_args(false);
    c.add_option("--budget", grid_study.budget,
                 "predicted time of all runs, e.g. 2h: runs that do not fit are left out and listed")
        ->type_name("TIME");
    c.add_flag("--plan", grid_study.plan, "list the runs and their predicted time, and run nothing");
    add_report_every(c, grid_study.making);
    add_rerun(c, grid_study.overwrite);
    c.add_option("--out", grid_study.out, "folder of the results (runs/<name of the scene file>_ladder)");
    add_threads(c, grid_study.threads);
}

void sweep_options(CLI::App& c, SweepCommand& sweep) {
    c.add_option("scene", sweep.scene.file, "scene file (TOML)")->required();
    c.add_option("--hulls", sweep.hulls, "surface files, in the attitude and unit of the scene's");
    c.add_option("--speeds", sweep.speeds, "e.g. \"6 m/s\" \"8 m/s\"");
    c.add_option("--trims", sweep.trims, "e.g. \"3 deg\" \"5 deg\"");
    c.add_option("--wave-lengths", sweep.wave_lengths,
                 "of the regular wave, e.g. \"2 m\" \"3 m\" \"4 m\": curves of the responses over them");
    c.add_option("--near-hull", sweep.scene.near_hull, "finest size instead of the scene's, e.g. \"25 mm\"");
    c.add_option("--scale", sweep.scene.scale, "all sizes times this number, refinement levels kept");
    c.add_option("--duration", sweep.scene.duration, "simulated time instead of the scene's, e.g. \"2 s\"");
    add_effect(c, sweep.scene);
    add_method(c, sweep.method);
    c.add_option("--twins", sweep.coarser_members,
                 "which scenes are also run at two coarser sizes for their discretisation error: first (its relative "
                 "error is taken "
                 "for all others), all, none")
        ->check(CLI::IsMember({"first", "all", "none"}));
    add_rerun(c, sweep.overwrite);
    c.add_option("--out", sweep.out, "folder of the results (runs/<name of the scene file>_sweep)");
    add_threads(c, sweep.threads);
}

void ablate_options(CLI::App& c, AblateCommand& ablate) {
    add_scene(c, ablate.scene);
    c.add_option("--effects", ablate.effects, "the effects to switch (all that can be)")->type_name("NAME");
    add_method(c, ablate.method);
    add_rerun(c, ablate.overwrite);
    c.add_option("--out", ablate.out, "folder of the results (runs/<name of the scene file>_ablation)");
    add_threads(c, ablate.threads);
}

void validate_options(CLI::App& c, ValidateCommand& validate) {
    c.add_option("suite", validate.suite,
                 "folder of a suite; or validation.json of an earlier report, of which the "
                 "files and pages are made anew, without a run");
    c.add_option("--tier", validate.tier,
                 fmt::format("the most expensive tier of cases to run ({}): {}; the tiers before it are run too",
                             suite_tiers().front(), fmt::join(suite_tiers(), ", ")))
        ->check(CLI::IsMember(suite_tiers()));
    c.add_option("--case", validate.cases, "only the case of this name; can be given again")
        ->type_name("NAME")
        ->allow_extra_args(false);
    c.add_option("--method", validate.method,
                 fmt::format("{}: only these of a case's methods", fmt::join(method_choices(), ", ")))
        ->check(CLI::IsMember(method_choices()));
    c.add_option("--against", validate.against,
                 "validation.json of an earlier report: what became worse or better, by name");
    c.add_option(
        "--keep", validate.keep,
        "validation.json of an earlier report: what is not run now is taken from it, with its version and day");
    c.add_option("--require", validate.require,
                 "exit status 4 unless: goals, every value meets its goal or is a known miss; no-worse, none is worse "
                 "than in --against")
        ->check(CLI::IsMember({"goals", "no-worse"}));
    c.add_option(
         "--discretisation", validate.estimator,
         fmt::format("method for the discretisation error by which the values are judged ({}); the report shows "
                     "all: {}",
                     uncertainty_methods().front(), fmt::join(uncertainty_methods(), ", ")))
        ->check(CLI::IsMember(uncertainty_methods()));
    c.add_option("--pages", validate.pages, "folder for Markdown pages made from the report: README.md and one a case");
    c.add_option("--into", validate.into,
                 "Markdown page, written by hand, whose tables are made anew: between a line <!-- validate: families "
                 "-->, <!-- validate: values --> or <!-- validate: shortfalls --> and <!-- /validate -->; can be given "
                 "again")
        ->type_name("FILE ...");
    c.add_flag("--formulas", validate.formulas, "list the formulas that a truth may name, and run nothing");
    add_rerun(c, validate.overwrite);
    c.add_option(
        "--out", validate.out,
        "folder of the results (runs/<name of the suite>_validation): validation.html, .json, .csv, junit.xml");
    add_threads(c, validate.threads);
}

void member_options(CLI::App& c, MemberCommand& member) {
    c.add_option("study", member.study, "folder of the study's results")->required();
    c.add_option("number", member.number, "which of its runs, from 0")->required();
    add_threads(c, member.threads);
}

void study_options(CLI::App& c, StudyCommand& study) {
    c.add_option("folder", study.folder, "folder of results of a run or a study")->required();
}

void watch_options(CLI::App& c, WatchCommand& watch) {
    c.add_option("folder", watch.folder, "folder of results of a run or a study")->required();
    c.add_option("--every", watch.every, "how often to look, in seconds (2)")->check(CLI::Range(0.1, 3600.0));
}

void import_options(CLI::App& c, ImportCommand& imported) {
    c.add_option("mapping", imported.mapping, "TOML file that says which columns mean what")->required();
    c.add_option("--out", imported.out, "folder for record.h5")->required();
    c.add_flag("--overwrite", imported.overwrite, "replace the record if it is there");
}

void uncertainty_options(CLI::App& c, UncertaintyCommand& uncertainty) {
    c.add_option("table", uncertainty.table, "CSV file: a header line, then a row for every level")->required();
    c.add_option("--order", uncertainty.order,
                 "order of the scheme (2), for the factor of safety and for tables of two levels")
        ->check(CLI::Range(0.1, 10.0));
    c.add_option(
         "--dimensions", uncertainty.dimensions,
         "2 or 3: in how many dimensions the runs are refined, where the first column counts cells or particles")
        ->check(CLI::IsMember({2, 3}));
}

void case_options(CLI::App& c, CaseCommand& foam_case) {
    add_scene(c, foam_case.scene);
    c.add_option("folder", foam_case.folder, "new folder for the case")->required();
}

void doctor_options(CLI::App& c, DoctorCommand& doctor) {
    c.add_option("--openfoam", doctor.openfoam, "folder of an OpenFOAM installation to examine first");
}

void setup_openfoam_options(CLI::App& c, SetupOpenfoamCommand& setup) {
    c.add_option("solvers", setup.solvers, "solvers beside interFoam: interIsoFoam, potentialFoam")
        ->check(CLI::IsMember({"interFoam", "interIsoFoam", "potentialFoam"}))
        ->type_name("SOLVER");
    CLI::Option* folder =
        c.add_option("--folder", setup.folder, "build here instead; TWINWAKE_OPENFOAM_BIN=FOLDER/bin then names it")
            ->type_name("FOLDER");
    c.add_flag("--for-all-users", setup.for_all_users, "build in /usr/local/lib/twinwake/openfoam, as root")
        ->excludes(folder);
    c.add_option("--jobs", setup.jobs, "compilers at a time; 2 unless given")->check(CLI::Range(1, 4096));
}

void film_options(CLI::App& c, FilmCommand& film) {
    c.add_option("run", film.run, "folder of a run, or of one method's")->required();
    c.add_option("-o,--out", film.out,
                 "file: .mp4 or .webm (need ffmpeg), or .gif (needs no other program). Unless given: RUN/film.mp4, or "
                 "RUN/film.gif where there is no ffmpeg");
    c.add_option("--seconds", film.seconds, "how long the film lasts; 10 unless given")->check(CLI::Range(0.1, 600.0));
    c.add_flag("--overwrite", film.overwrite, "replace a film that is there");
}

void stability_options(CLI::App& c, StabilityCommand& stability) {
    c.add_flag("--quick", stability.quick, "half as fine: about a minute instead of several");
    c.add_option("--out", stability.out, "folder for stability.html, .svg, .json and .txt (runs/stability)");
    add_threads(c, stability.threads, "cases at a time; all cores unless given");
}

void spray_options(CLI::App& c, SprayCommand& spray) {
    c.add_option("study", spray.study, "study file (TOML): source, extraction, air, targets, sensor")->required();
    c.add_option("--out", spray.out, "folder of the results (runs/<name of the study>_spray)");
    c.add_option("--openfoam-cloud", spray.cloud,
                 "also write the droplets as an OpenFOAM cloud into this new folder, run it and compare its paths");
    c.add_option("--against", spray.against,
                 "results of another spray, e.g. of the other method: statistics of both sprays' droplets");
}

void bench_options(CLI::App& c, BenchCommand& bench) {
    c.add_option("--particles", bench.particles, "number of particles")->check(CLI::Range(1000L, 1000000000L));
    c.add_option("--h-over-dp", bench.h_over_dp, "smoothing length over spacing")->check(CLI::Range(1.1, 3.0));
    c.add_option("--threads", bench.threads, "threads; all cores unless given")->check(CLI::Range(0, 4096));
    c.add_option("--device", bench.device, "what makes the steps: cpu or gpu")->check(CLI::IsMember({"cpu", "gpu"}));
    c.add_option("--seconds", bench.seconds, "how long to measure")->check(CLI::Range(0.1, 3600.0));
}

void completion_options(CLI::App& c, CompletionCommand& completion) {
    completion.program = c.get_parent();
    c.add_option("shell", completion.shell, "bash, zsh or fish; man: the manual page instead")
        ->required()
        ->check(CLI::IsMember({"bash", "zsh", "fish", "man"}));
}

}  // namespace tw::app
