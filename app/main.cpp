#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <sstream>

#include "app/commands.h"
#include "app/output.h"
#include "app/quiet_waits.h"
#include "base/errors.h"
#include "compare/report/escape.h"
#include "record/code_version.h"
#include "scene/effects/registry.h"
#include "spray/read_study.h"
#include "text/did_you_mean.h"

// The command line: the only file that knows CLI11. Every subcommand lives in a file of its own name.

namespace tw::app {
namespace {

constexpr const char* about =
    "One hull, two methods, one verdict.\n\n"
    "A scene file describes a hull in water once. twinwake sets up a smoothed-particle run and an OpenFOAM\n"
    "interFoam run from it, runs them and two coarser twins of each, and reports drag, lift and splash height\n"
    "side by side: how far the methods are apart, how sure that is, and what it cost.\n\n"
    "  twinwake new planing my.toml      a scene to start from\n"
    "  twinwake check my.toml            what would be solved, and how long it takes\n"
    "  twinwake run my.toml              both methods at three sizes, then the report in runs/my/report.html\n"
    "  twinwake run my.toml --hull other.stl --out runs/other\n"
    "  twinwake ladder my.toml           more sizes, time step and sound speed: what accuracy costs\n";
constexpr const char* footer =
    "Exit status: 0 done, 2 bad input or usage, or output that cannot be written, 3 a run failed or was stopped (its "
    "state "
    "is saved), 4 --require agree not met.";

constexpr const char* about_uncertainty =
    "The first column is the spacing (cell or particle size), every further column one quantity:\n\n"
    "  h [m], drag [N], lift [N]\n"
    "  0.05,  412.1,    2722\n"
    "  0.07,  418.0,    2711\n"
    "  0.10,  431.0,    2690\n"
    "  0.14,  449.5,    2655\n\n"
    "Commas, semicolons or tabs; lines that begin with # and empty lines are skipped; rows in any order.\n"
    "From three levels on U comes from a fit of trend and noise. Beside it stand the least squares of Eca & Hoekstra\n"
    "(2014; four levels), and of the three finest levels the grid convergence index of Celik et al. (2008) and the\n"
    "factor of safety of Xing & Stern (2010). Two levels: the order is assumed (--order), the factor is 3. One: no U.\n"
    "U is meant as half the width of a 95 % interval about the finest value. That a table does not converge is\n"
    "a result, not an error: the exit status is 0.\n\n";

constexpr const char* about_import =
    "The mapping names the source, the scene it belongs to, and its columns:\n\n"
    "  kind = \"csv\"                   # or dualsphysics (ComputeForces CSV), openfoam (a case folder)\n"
    "  name = \"towing tank\"\n"
    "  source = \"forces.csv\"          # relative to the mapping file\n"
    "  scene = \"planing_prism.toml\"   # or the record.h5 of a run of it\n"
    "  half_model = false             # true: loads of half a hull, to be doubled\n"
    "  time = { column = \"t\", unit = \"ms\" }\n"
    "  [forces]                       # fx fy fz my; further [height] [pressure] [samples]\n"
    "  fx = { column = \"Drag\", unit = \"kN\" }\n"
    "  fz = { column = 3, unit = \"N\", scale = -1 }\n\n"
    "x runs with the stream to the stern, z up; forces are those of the water on the hull, my is bow up.\n\n";

constexpr const char* about_ablate =
    "Runs the scene as it is, then once for each effect with that one effect switched: what is on goes off, what is\n"
    "off goes on. The table shows, for each, the change of every measured quantity in per cent with its 95 % "
    "interval,\n"
    "beside what the effect plan had estimated, and the change of the processor time.\n\n"
    "  twinwake ablate my.toml                                      every effect that can be switched\n"
    "  twinwake ablate my.toml --effects surface_tension shifting --method sph\n"
    "  twinwake ablate my.toml --effect viscosity=on --effects no_slip turbulence\n\n"
    "For effects of the particle method alone no mesh run is made. An effect that needs another one which is off is\n"
    "switched in the run that has the other one on, and compared with that run.\n\n"
    "A finished run is reused; after a stop (Ctrl-C) the same command continues. A run that fails is listed with its\n"
    "reason and does not stop the others.\n\n";

void add_effect(CLI::App* command, SceneArguments& scene) {
    command
        ->add_option("--effect", scene.effects,
                     fmt::format("switch an effect on or off instead of the scene's choice, e.g. viscosity=on; can be "
                                 "given again. Effects: {}",
                                 fmt::join(effect_names(), ", ")))
        ->type_name("NAME=on|off")
        ->allow_extra_args(false);
}

void add_scene(CLI::App* command, SceneArguments& scene) {
    command->add_option("scene", scene.file, "scene file (TOML)")->required();
    command->add_option("--hull", scene.hull,
                        "swap the hull: this surface file instead of the scene's, in the same attitude and unit");
    command->add_option("--speed", scene.speed,
                        "speed of the stream instead of the scene's, e.g. \"30 m/s\" or \"60 kn\"");
    command->add_option("--trim", scene.trim, "bow up, instead of the scene's, e.g. \"5 deg\"");
    command->add_option("--near-hull", scene.near_hull, "finest size instead of the scene's, e.g. \"25 mm\"");
    command->add_option("--spacing", scene.spacing, "largest size instead of the scene's");
    command->add_option(
        "--scale", scene.scale,
        "all sizes times this number, levels kept: 2, 1.4142 and 1 make similar meshes, for convergence");
    command->add_option("--duration", scene.duration, "simulated time instead of the scene's, e.g. \"2 s\"");
    add_effect(command, scene);
}

/// A misspelt subcommand, with the nearest known one.
void refuse_unknown(const CLI::App& app, const std::string& word) {
    std::vector<std::string> names;
    std::string list;
    for (const CLI::App* command : app.get_subcommands([](const CLI::App*) { return true; })) {
        names.push_back(command->get_name());
        list += (list.empty() ? "" : ", ") + names.back();
    }
    if (std::find(names.begin(), names.end(), word) == names.end())
        throw InputError("twinwake " + word + ": no such subcommand; expected one of: " + list +
                         did_you_mean(word, names));
}

/// What was called, for the records: a word a line, without where results went and how many cores made them. Of a path
/// from the root the name is left.
std::string command_words(int argc, char** argv) {
    std::string text;
    for (int k = 1; k < argc; ++k) {
        const std::string word = argv[k];
        const std::string option = word.substr(0, word.find('='));
        if (option == "--out" || option == "--json" || option == "--threads") {
            if (option == word) ++k;
            continue;
        }
        if (word == "--resume" || word == "--overwrite" || word == "-q" || word == "--quiet") continue;
        text += (word.starts_with('/') ? std::filesystem::path(word).filename().string() : word) + "\n";
    }
    return text;
}

int dispatch(int argc, char** argv) {
    CLI::App app(about, "twinwake");
    app.set_version_flag("--version", std::string("twinwake ") + TWINWAKE_CODE_VERSION);
    app.footer(footer);
    app.require_subcommand(1);
    app.get_formatter()->column_width(34);

    Common common;
    common.command = command_words(argc, argv);
    std::function<int()> chosen;
    const auto subcommand = [&](CLI::App* parent, const std::string& name, const std::string& description,
                                std::function<int()> run, bool json = true) {
        CLI::App* command = parent->add_subcommand(name, description);
        command->add_flag("-q,--quiet", common.quiet, "only errors (and what --json writes)");
        if (json)
            command
                ->add_option("--json", common.json, "write the facts for programs to this file; - for standard output")
                ->type_name("FILE");
        command->callback([&chosen, run = std::move(run)] { chosen = run; });
        return command;
    };

    NewCommand create;
    CLI::App* c = subcommand(
        &app, "new", "write a scene file to start from", [&] { return run_new(create, common); }, false);
    c->add_option("template", create.kind, "planing, seaplane, tank, own")
        ->required()
        ->check(CLI::IsMember(template_names()));
    c->add_option("file", create.file, "scene file to write")->required();
    c->add_flag("--overwrite", create.overwrite, "replace the file if it is there");

    CheckCommand check;
    c = subcommand(&app, "check", "hull health, effects with reasons, size, memory and time; runs nothing",
                   [&] { return run_check(check, common); });
    add_scene(c, check.scene);
    c->add_option("--threads", check.threads,
                  "predict for this many threads (particles) and ranks (mesh); all cores unless given")
        ->check(CLI::Range(1, 4096));

    c->add_option("--picture", check.picture,
                  "SVG file to write: side and plan view of the sizes of particles and cells round the hull");

    ReferenceCommand reference;
    c = subcommand(
        &app, "reference", "every section, key, effect and shape of a scene file, as Markdown",
        [&] { return run_reference(reference, common); }, false);
    c->add_option("--out", reference.out, "file to write instead of standard output");
    c->add_option("--names", reference.names, "only the names, one on each line: effects or shapes")
        ->check(CLI::IsMember({"effects", "shapes"}));

    RunCommand run;
    run.method.clear();
    std::string run_requires;
    c = subcommand(&app, "run",
                   "run a scene with both methods, coarser twins first, and compare them: verdicts that include the "
                   "discretisation error",
                   [&] {
                       run.require_agree = run_requires == "agree";
                       return run_run(run, common);
                   });
    add_scene(c, run.scene);
    c->add_option("--method", run.method, "sph, fvm or both instead of the scene's")
        ->check(CLI::IsMember({"sph", "fvm", "both"}));
    c->add_option("--out", run.out, "folder of the results (runs/<name of the scene file>)");
    CLI::Option* resume =
        c->add_flag("--resume", run.resume, "continue from the last saved state; only if scene and numerics match");
    c->add_flag("--overwrite", run.overwrite, "run anew in a folder that has a run")->excludes(resume);
    c->add_flag("!--no-twins", run.twins,
                "leave out the coarser runs (1.4142 and 2 times the sizes, and one in a wider box): then nothing is "
                "known of the discretisation error, and there is no verdict");
    c->add_option("--require", run_requires, "agree: exit status 4 unless every quantity agrees; needs the twins")
        ->check(CLI::IsMember({"agree"}));
    c->add_option("--threads", run.threads, "threads (particles) and ranks (mesh); all cores unless given")
        ->check(CLI::Range(1, 4096));

    CompareCommand compare;
    std::string require;
    c = subcommand(&app, "compare", "compare run records: verdict and report", [&] {
        compare.require_agree = require == "agree";
        return run_compare(compare, common);
    });
    c->add_option("sources", compare.sources, "run records, or folders of runs")->required()->expected(1, 64);
    c->add_option("--out", compare.out, "folder for report.html, report.json, CSV and figures");
    c->add_flag("--ladder", compare.ladder,
                "the records are runs of one scene at several sizes: verdicts that include the discretisation error");
    c->add_option("--measured", compare.measured,
                  "with --ladder: a measurement, as written by twinwake import; can be given again")
        ->allow_extra_args(false);
    c->add_flag("--force", compare.force, "compare records of different scenes, with a banner");
    c->add_option(
         "--require", require,
         "agree: exit status 4 unless every quantity agrees; needs --ladder, since runs of one size have no verdict")
        ->check(CLI::IsMember({"agree"}));

    ImportCommand imported;
    c = subcommand(&app, "import",
                   "a run record from CSV histories, DualSPHysics or another OpenFOAM case, for compare",
                   [&] { return run_import(imported, common); });
    c->add_option("mapping", imported.mapping, "TOML file that says which columns mean what")->required();
    c->add_option("--out", imported.out, "folder for record.h5")->required();
    c->add_flag("--overwrite", imported.overwrite, "replace the record if it is there");
    c->footer(about_import + std::string(footer));

    LadderCommand ladder;
    c = subcommand(&app, "ladder",
                   "a scene at several sizes with both methods: verdicts that include the discretisation error",
                   [&] { return run_ladder(ladder, common); });
    add_scene(c, ladder.scene);
    c->add_option("--method", ladder.method, "sph, fvm or both instead of the scene's")
        ->check(CLI::IsMember({"sph", "fvm", "both"}));
    c->add_option("--levels", ladder.levels, "number of sizes (4): the scene's own and coarser ones")
        ->check(CLI::Range(1, 8));
    c->add_option("--ratio", ladder.ratio, "of neighbouring spacings (1.4142)")->check(CLI::Range(1.05, 4.0));
    c->add_flag(
        "!--no-variations", ladder.variations,
        "leave out the runs with sound speed x 1.5, half the time step, half the Courant number and a wider box");
    c->add_flag("!--no-fill", ladder.fill,
                "leave out the sizes between the coarse ones, which tell scatter from a trend and narrow the interval");
    c->add_option(
         "--measured", ladder.measured,
         "a measurement, as written by twinwake import: each method's finest value is compared with it; can be given "
         "again")
        ->allow_extra_args(false);
    c->add_option("--budget", ladder.budget,
                  "predicted time of all runs, e.g. 2h: runs that do not fit are left out and listed")
        ->type_name("TIME");
    c->add_flag("--plan", ladder.plan, "list the runs and their predicted time, and run nothing");
    c->add_flag("--overwrite", ladder.overwrite, "run anew whatever is not a finished run of this scene");
    c->add_option("--out", ladder.out, "folder of the results (runs/<name of the scene file>_ladder)");
    c->add_option("--threads", ladder.threads, "threads (particles) and ranks (mesh); all cores unless given")
        ->check(CLI::Range(1, 4096));

    SweepCommand sweep;
    c = subcommand(&app, "sweep", "a scene with every hull, speed and trim of lists: bias and scatter of the methods",
                   [&] { return run_sweep(sweep, common); });
    c->add_option("scene", sweep.scene.file, "scene file (TOML)")->required();
    c->add_option("--hulls", sweep.hulls, "surface files, in the attitude and unit of the scene's");
    c->add_option("--speeds", sweep.speeds, "e.g. \"6 m/s\" \"8 m/s\"");
    c->add_option("--trims", sweep.trims, "e.g. \"3 deg\" \"5 deg\"");
    c->add_option("--near-hull", sweep.scene.near_hull, "finest size instead of the scene's, e.g. \"25 mm\"");
    c->add_option("--scale", sweep.scene.scale, "all sizes times this number, levels kept");
    c->add_option("--duration", sweep.scene.duration, "simulated time instead of the scene's, e.g. \"2 s\"");
    add_effect(c, sweep.scene);
    c->add_option(
         "--twins", sweep.twins,
         "which scenes run coarser twins for their discretisation error: first (its relative error is taken for "
         "all others), all, none")
        ->check(CLI::IsMember({"first", "all", "none"}));
    c->add_flag("--overwrite", sweep.overwrite, "run anew whatever is not a finished run of this scene");
    c->add_option("--out", sweep.out, "folder of the results (runs/<name of the scene file>_sweep)");
    c->add_option("--threads", sweep.threads, "threads (particles) and ranks (mesh); all cores unless given")
        ->check(CLI::Range(1, 4096));

    AblateCommand ablate;
    c = subcommand(&app, "ablate", "effects switched one at a time: what each changes, and what it costs",
                   [&] { return run_ablate(ablate, common); });
    add_scene(c, ablate.scene);
    c->add_option("--effects", ablate.effects, "the effects to switch (all that can be)")->type_name("NAME");
    c->add_option("--method", ablate.method, "sph, fvm or both instead of the scene's")
        ->check(CLI::IsMember({"sph", "fvm", "both"}));
    c->add_flag("--overwrite", ablate.overwrite, "run anew whatever is not a finished run of this scene");
    c->add_option("--out", ablate.out, "folder of the results (runs/<name of the scene file>_ablation)");
    c->add_option("--threads", ablate.threads, "threads (particles) and ranks (mesh); all cores unless given")
        ->check(CLI::Range(1, 4096));
    c->footer(about_ablate + effects_text() + "\n" + footer);

    UncertaintyCommand uncertainty;
    c = subcommand(&app, "uncertainty",
                   "discretisation error of the finest value, from any table of a refinement study",
                   [&] { return run_uncertainty(uncertainty, common); });
    c->add_option("table", uncertainty.table, "CSV file: a header line, then a row for every level")->required();
    c->add_option("--order", uncertainty.order,
                  "order of the scheme (2), for the factor of safety and for tables of two levels")
        ->check(CLI::Range(0.1, 10.0));
    c->footer(about_uncertainty + std::string(footer));

    HullCommand hull;
    CLI::App* hulls = app.add_subcommand("hull", "inspect, repair, make and convert hull surfaces");
    hulls->require_subcommand(1);
    const auto hull_action = [&](const std::string& action, const std::string& description) {
        return subcommand(hulls, action, description, [&hull, &common, action] {
            hull.action = action;
            const int status = leaving_files([&] { return run_hull(hull, common); });
            if (status != done && common.quiet)
                complain(hull.in.string() + ": not usable; hull info without -q shows why");
            return status;
        });
    };
    const auto add_input = [&](CLI::App* command) {
        command->add_option("in", hull.in, "STL, OBJ, PLY or VTP, also compressed (.gz)")->required();
        command->add_option("--unit", hull.unit, "unit of the file: m, mm, cm, ft, in");
        command->add_option("--axes", hull.axes, "file axes that become x (stern), y, z (up), e.g. -xyz");
    };
    c = hull_action("info", "size, volume and health findings of a surface");
    add_input(c);
    c->add_option("--particle-spacing", hull.particle_spacing,
                  "also find walls too thin for particles of this spacing [m]");
    c = hull_action("repair", "repair what is safe and write the result as STL");
    add_input(c);
    c->add_option("out", hull.out, "STL to write")->required();
    c = hull_action("convert", "other unit, axes or format: writes STL in metres, x to the stern, z up");
    add_input(c);
    c->add_option("out", hull.out, "STL to write")->required();
    c = hull_action("make", "a parametric hull; without a shape: the list of shapes and parameters");
    CLI::Option* shape = c->add_option("shape", hull.shape, "one of the shapes that the list without a shape names");
    c->add_option("-o,--out", hull.out, "STL to write")->needs(shape);
    c->add_option("parameters", hull.parameters, "name=value, e.g. length=4 \"beam=100 cm\" deadrise=20deg");

    CaseCommand foam_case;
    c = subcommand(
        &app, "case", "write the OpenFOAM case of a scene, to inspect, change and run by hand",
        [&] { return run_case(foam_case, common); }, false);
    add_scene(c, foam_case.scene);
    c->add_option("folder", foam_case.folder, "new folder for the case")->required();

    DoctorCommand doctor;
    c = subcommand(&app, "doctor", "checks the installation; tests OpenFOAM on a flow with an exact solution",
                   [&] { return run_doctor(doctor, common); });
    c->add_option("--openfoam", doctor.openfoam, "folder of an OpenFOAM installation to examine first");

    StabilityCommand stability;
    c = subcommand(&app, "stability",
                   "where the particle solver is stable: maps over speed, deadrise, h/dp, time step and sound speed",
                   [&] { return run_stability(stability, common); });
    c->add_flag("--quick", stability.quick, "half as fine: about a minute instead of several");
    c->add_option("--out", stability.out, "folder for stability.html, .svg, .json and .txt (runs/stability)");
    c->add_option("--threads", stability.threads, "cases at a time; all cores unless given")
        ->check(CLI::Range(1, 4096));

    SprayCommand spray;
    c = subcommand(&app, "spray",
                   "water that left a run, flown as droplets through air, and the load it puts on a surface",
                   [&] { return run_spray_command(spray, common); });
    c->add_option("study", spray.study, "study file (TOML): source, extraction, air, targets, sensor")->required();
    c->add_option("--out", spray.out, "folder of the results (runs/<name of the study>_spray)");
    c->add_option("--openfoam-cloud", spray.cloud,
                  "also write the droplets as an OpenFOAM cloud into this new folder, run it and compare its paths");
    c->add_option("--against", spray.against,
                  "results of another spray, e.g. of the other method: statistics of both sprays' droplets");
    c->footer(tw::spray::spray_study_help + std::string(footer));

    BenchCommand bench;
    c = subcommand(&app, "bench", "throughput of the particle solver on this machine",
                   [&] { return run_bench_command(bench, common); });
    c->add_option("--particles", bench.particles, "number of particles")->check(CLI::Range(1000L, 1000000000L));
    c->add_option("--h-over-dp", bench.h_over_dp, "smoothing length over spacing")->check(CLI::Range(1.1, 3.0));
    c->add_option("--threads", bench.threads, "threads; all cores unless given")->check(CLI::Range(0, 4096));
    c->add_option("--seconds", bench.seconds, "how long to measure")->check(CLI::Range(0.1, 3600.0));

    if (argc > 1 && argv[1][0] != '-') refuse_unknown(app, argv[1]);
    try {
        app.parse(argc, argv);
    } catch (const CLI::ParseError& e) {
        std::ostringstream help, wrong;
        const int status = app.exit(e, help, wrong);
        say({}, help.str());
        std::fputs(for_terminal(wrong.str()).c_str(), stderr);
        return status == 0 ? done : bad_input;
    }
    refuse_unwritable_json(common);
    return chosen();
}

/// The exit status; what went wrong is on standard error.
int status_of(int argc, char** argv) {
    try {
        return dispatch(argc, argv);
    } catch (const InputError& e) {
        complain(e.what());
        return bad_input;
    } catch (const RunError& e) { complain(e.what()); } catch (const std::bad_alloc&) {
        complain("out of memory: coarsen [resolution] near_hull; twinwake check shows how much is needed");
    } catch (const std::exception& e) { complain(std::string("unexpected: ") + e.what()); }
    return run_failed;
}

}  // namespace
}  // namespace tw::app

int main(int argc, char** argv) {
    tw::app::spin_briefly(argv);
    // OpenFOAM believes PWD rather than the folder it is started in, and refuses one with a blank: the shell's must not
    // reach it.
    unsetenv("PWD");
    const int status = tw::app::status_of(argc, argv);
    // Lost output is no success; a status that says more than that is kept.
    return tw::app::everything_was_printed() || status != tw::app::done ? status : tw::app::bad_input;
}
