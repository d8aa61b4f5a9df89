#pragma once
#include <filesystem>
#include <functional>
#include <map>
#include <optional>
#include <string>
#include <vector>

#include "scene/run/run_options.h"
#include "scene/scene.h"

namespace tw::app {

// One struct and one function per subcommand. Functions return the exit status and throw InputError or RunError.
enum ExitStatus { done = 0, bad_input = 2, run_failed = 3, not_agreed = 4, ended_early = 5 };

/// What every subcommand takes.
struct Common {
    bool quiet = false;   ///< only results and errors
    std::string json;     ///< file for the same facts for programs; "-": standard output instead of text; empty: none
    std::string command;  ///< what was called, a word a line, for the records
    std::vector<std::string> words = {};  ///< the same as it was typed, behind the program's name
};

struct Study;
/// How the runs of a study are made.
struct Making {
    int jobs = 0;                   ///< side by side; 0: not said (jobs_by_default.h)
    bool collect = false;           ///< none is: the report is made from those that are finished
    std::string report_every = {};  ///< a text with unit: the report is made so often while they run; empty: at the end
    /// Takes the study in place of running it; null: it is run. Returns the exit status.
    std::function<int(Study study, const Common& common)> hand_over = {};

    /// Whether the runs are, or were, made by somebody else, who may have other machines.
    bool elsewhere() const { return collect || hand_over; }
};

struct NewCommand {
    std::string kind;  ///< of template_names()
    std::filesystem::path file;
    std::filesystem::path from;  ///< the hull's file, or one whose bodies the scene has; of these templates alone
    std::string unit = "m", axes = "xyz";  ///< of that file
    bool overwrite = false;
};
int run_new(const NewCommand& command, const Common& common);
std::vector<std::string> template_names();
/// "hull: your own hull, ...; planing: ...".
std::string templates_in_words();

/// Scene file and what the command line changes about it; values as texts with units.
struct SceneArguments {
    std::filesystem::path file;
    std::filesystem::path hull;
    std::string speed, trim, wave_length, spacing, near_hull, duration, scale, device;
    std::vector<std::string> effects;  ///< "NAME=on" or "NAME=off"
    SceneOverrides overrides() const;  ///< throws InputError naming the option
};

/// Throws InputError that begins with `option` and names the known effects.
void refuse_unknown_effect(const std::string& option, const std::string& name);

struct CheckCommand {
    SceneArguments scene;
    int threads = 0, ranks = 0;     ///< 0: the scene's
    std::filesystem::path picture;  ///< SVG file of the sizes of particles and cells; empty: none
    std::filesystem::path html;     ///< page of all that is checked, with that picture; empty: none
};
int run_check(const CheckCommand& command, const Common& common);

struct ReferenceCommand {
    std::filesystem::path out;  ///< empty: standard output
    std::string names;          ///< effects or shapes: only their names; empty: the whole reference
};
int run_reference(const ReferenceCommand& command, const Common& common);

struct RunCommand {
    SceneArguments scene;
    std::string method = "both";  ///< sph, fvm, both; empty: what the scene says
    std::filesystem::path out;    ///< empty: runs/<name of the scene file>
    bool resume = false, overwrite = false;
    bool coarser_members = true;  ///< also coarser runs, for the discretisation error
    std::string budget;          ///< predicted time that chooses the sizes, a text with unit; empty: the scene's sizes
    bool require_agree = false;  ///< not_agreed unless every quantity agrees
    int threads = 0;
    Making making;
    int ranks = 0;  ///< processes that share the particles; 0: the scene's
};
int run_run(const RunCommand& command, const Common& common);

struct CompareCommand {
    std::vector<std::filesystem::path> sources;
    std::filesystem::path out;
    bool force = false, require_agree = false;
    bool grid_study = false;                      ///< the records are sizes of one scene
    std::vector<std::filesystem::path> measured;  ///< with grid study: imported records, or their folders
};
int run_compare(const CompareCommand& command, const Common& common);

struct ImportCommand {
    std::filesystem::path mapping;  ///< TOML file: what is where in the source, see import/README.md
    std::filesystem::path out;      ///< folder of the record
    bool overwrite = false;
};
int run_import(const ImportCommand& command, const Common& common);

struct LadderCommand {
    SceneArguments scene;
    std::string method;         ///< sph, fvm, both; empty: what the scene says
    std::filesystem::path out;  ///< empty: runs/<name of the scene file>_ladder
    int levels = 4;
    double ratio = 1.4142135623730951;            ///< of neighbouring spacings [-]
    std::vector<std::filesystem::path> measured;  ///< imported records, or their folders
    std::string budget;                           ///< predicted time of all runs, a text with unit; empty: no limit
    bool plan = false;                            ///< list the runs and their predicted time, and run nothing
    bool variations = true;                       ///< also runs with another sound speed, time step and Courant number
    bool surface = false;                         ///< also one with the surface captured geometrically
    bool fill = true;                             ///< also sizes between the coarse ones
    bool overwrite = false;                       ///< run anew what another scene left in the folder
    int threads = 0;
    Making making;
};
int run_grid_study(const LadderCommand& command, const Common& common);

struct SweepCommand {
    SceneArguments scene;
    std::vector<std::filesystem::path> hulls;
    std::vector<std::string> speeds, trims, wave_lengths;  ///< texts with units
    std::string method;                      ///< sph, fvm, both; empty: what the scene says
    std::string coarser_members = "first";   ///< first, all, none: which scenes run their own
    std::filesystem::path out;               ///< empty: runs/<name of the scene file>_sweep
    bool overwrite = false;
    int threads = 0;
    Making making;
};
int run_sweep(const SweepCommand& command, const Common& common);

struct AblateCommand {
    SceneArguments scene;
    std::vector<std::string> effects;  ///< names; empty: every effect that can be switched
    std::string method;                ///< sph, fvm, both; empty: what the scene says
    std::filesystem::path out;         ///< empty: runs/<name of the scene file>_ablation
    bool overwrite = false;
    int threads = 0;
    Making making;
};
int run_ablate(const AblateCommand& command, const Common& common);

struct MemberCommand {
    std::filesystem::path study;  ///< folder of its results
    std::size_t number = 0;
    int threads = 0;
};
int run_member(const MemberCommand& command, const Common& common);

struct UncertaintyCommand {
    std::filesystem::path table;  ///< CSV: spacing, then one column per quantity
    double order = 2;             ///< of the scheme [-]
    int dimensions = 0;           ///< in which a count of cells is refined, 2 or 3; 0: as the table's header says
};
int run_uncertainty(const UncertaintyCommand& command, const Common& common);

struct HullCommand {
    std::string action;  ///< info, repair, make, convert
    std::filesystem::path in, out;
    std::string shape, unit = "m", axes = "xyz";
    std::vector<std::string> parameters;  ///< "length=4 m"
    double particle_spacing = 0;          ///< [m]
};
int run_hull(const HullCommand& command, const Common& common);

struct CaseCommand {
    SceneArguments scene;
    std::filesystem::path folder;
};
int run_case(const CaseCommand& command, const Common& common);

struct DoctorCommand {
    std::string openfoam;
};
int run_doctor(const DoctorCommand& command, const Common& common);

struct FilmCommand {
    std::filesystem::path run, out;  ///< out empty: RUN/film.mp4, or film.gif without ffmpeg
    double seconds = 0;              ///< how long the film lasts [s]; 0: ten
    bool overwrite = false;
};
int run_film(const FilmCommand& command, const Common& common);

struct SetupOpenfoamCommand {
    std::vector<std::string> solvers;  ///< beside interFoam
    std::filesystem::path folder;      ///< empty: where twinwake looks by itself
    bool for_all_users = false;
    int jobs = 0;  ///< of the compiler; 0: the script's
};
int run_setup_openfoam(const SetupOpenfoamCommand& command, const Common& common);

struct StabilityCommand {
    bool quick = false;
    std::filesystem::path out;  ///< empty: runs/stability
    int threads = 0;            ///< cases at a time; 0: all cores
};
int run_stability(const StabilityCommand& command, const Common& common);

struct SprayCommand {
    std::filesystem::path study;    ///< TOML file: source, air, surfaces, sensor
    std::filesystem::path out;      ///< empty: runs/<name of the study>_spray
    std::filesystem::path cloud;    ///< folder of the same droplets as an OpenFOAM case; empty: none
    std::filesystem::path against;  ///< results of another spray to compare droplets with; empty: none
};
int run_spray_command(const SprayCommand& command, const Common& common);

struct BenchCommand {
    long particles = 100000;
    double h_over_dp = 1.5, seconds = 5;  ///< [-], [s]
    int threads = 0;
    std::string device = "cpu";  ///< cpu, gpu
};
int run_bench_command(const BenchCommand& command, const Common& common);

}  // namespace tw::app
