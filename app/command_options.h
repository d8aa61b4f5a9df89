#pragma once
#include "app/arguments/commands.h"
#include "app/cluster/submit.h"
#include "app/commands/validate.h"
#include "app/completion.h"

namespace tw::app {

// The options of each subcommand, in the order of the table: they write into its command.
void new_options(CLI::App& c, NewCommand& create);
void check_options(CLI::App& c, CheckCommand& check);
void reference_options(CLI::App& c, ReferenceCommand& reference);
void run_options(CLI::App& c, RunCommand& run);
void compare_options(CLI::App& c, CompareCommand& compare);
void grid_study_options(CLI::App& c, LadderCommand& grid_study);
void sweep_options(CLI::App& c, SweepCommand& sweep);
void ablate_options(CLI::App& c, AblateCommand& ablate);
void validate_options(CLI::App& c, ValidateCommand& validate);
void member_options(CLI::App& c, MemberCommand& member);
void study_options(CLI::App& c, StudyCommand& study);
void watch_options(CLI::App& c, WatchCommand& watch);
void import_options(CLI::App& c, ImportCommand& imported);
void uncertainty_options(CLI::App& c, UncertaintyCommand& uncertainty);
void hull_info_options(CLI::App& c, HullCommand& hull);
void hull_repair_options(CLI::App& c, HullCommand& hull);
void hull_convert_options(CLI::App& c, HullCommand& hull);
void hull_make_options(CLI::App& c, HullCommand& hull);
void case_options(CLI::App& c, CaseCommand& foam_case);
void doctor_options(CLI::App& c, DoctorCommand& doctor);
void setup_openfoam_options(CLI::App& c, SetupOpenfoamCommand& setup);
void film_options(CLI::App& c, FilmCommand& film);
void stability_options(CLI::App& c, StabilityCommand& stability);
void spray_options(CLI::App& c, SprayCommand& spray);
void bench_options(CLI::App& c, BenchCommand& bench);
void completion_options(CLI::App& c, CompletionCommand& completion);

/// Of a surface file.
void add_unit_and_axes(CLI::App& c, std::string& unit, std::string& axes);
/// Of a study that is run on this machine, beside its own.
void add_jobs(CLI::App& c, Making& making);
/// Of one that is given to Slurm.
void add_site(CLI::App& c, SubmitOptions& submit);

}  // namespace tw::app
