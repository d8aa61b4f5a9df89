#include <algorithm>
#include <CLI/CLI.hpp>
#include <cstdio>
#include <cstdlib>
#include <exception>
#include <filesystem>
#include <sstream>

#include <fmt/format.h>

#include "app/arguments/output.h"
#include "app/runs/ranks.h"
#include "app/subcommands.h"
#include "app/terminal/command_words.h"
#include "app/terminal/quiet_waits.h"
#include "base/errors.h"
#include "base/in_words.h"
#include "compare/report/escape.h"
#include "record/code_version.h"
#include "sph_solver/parallel/comm.h"
#include "text/did_you_mean.h"

// The command line. Its table is in subcommands.cpp; every subcommand lives in a file of its own name.

namespace tw::app {
namespace {

constexpr const char* about =
    "One hull, two methods, one verdict.\n\n"
    "A scene file describes a hull in water once. twinwake sets up a smoothed-particle run and an OpenFOAM\n"
    "interFoam run from it, runs both at three resolutions, and reports drag, lift and splash height\n"
    "side by side: how far the methods differ, how certain that difference is, and what the runs cost.\n\n"
    "  twinwake new planing my.toml      a scene to start from\n"
    "  twinwake check my.toml            what would be solved, and how long it takes\n"
    "  twinwake run my.toml              both methods at three sizes, then the report in runs/my/report.html\n"
    "  twinwake run my.toml --hull other.stl --out runs/other\n"
    "  twinwake ladder my.toml           grid-convergence study: more sizes, time step, sound speed\n";
constexpr const char* footer =
    "Exit status: 0 done, 2 bad input or usage, or output that cannot be written, 3 a run failed or was stopped (its "
    "state is saved), 4 --require agree not met, 5 a member of a study was stopped.";

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

/// Adds the rows of the table, and those below them; the one that is given becomes `chosen`.
void add(CLI::App& parent, const std::vector<Subcommand>& rows, Common& common, Call& chosen) {
    for (const Subcommand& row : rows) {
        CLI::App* command = parent.add_subcommand(row.name, row.help);
        if (!row.below.empty()) {
            command->require_subcommand(1);
            add(*command, row.below, common, chosen);
            continue;
        }
        command->add_flag("-q,--quiet", common.quiet, "only errors (and what --json writes)");
        if (row.json)
            command
                ->add_option("--json", common.json, "write the facts for programs to this file; - for standard output")
                ->type_name("FILE");
        if (!row.about.empty()) command->footer(row.about + footer);
        command->callback([&chosen, call = row.add(*command)] { chosen = call; });
    }
}

/// `member` is one run of a command that starts the processes of each of its runs.
bool shares_its_work(const std::string& command) { return command == "run" || command == "member"; }

int dispatch(int argc, char** argv) {
    CLI::App app(about, "twinwake");
    app.set_version_flag("--version", std::string("twinwake ") + TWINWAKE_CODE_VERSION);
    app.footer(footer);
    app.require_subcommand(1);
    app.get_formatter()->column_width(34);
    Common common;
    common.words.assign(argv + 1, argv + argc);
    common.command = command_text(common.words);
    Call chosen;
    add(app, subcommands(), common, chosen);

    if (argc > 1 && argv[1][0] != '-') refuse_unknown(app, argv[1]);
    if (const Comm& ranks = Comm::world(); ranks.many() && !shares_its_work(argc > 1 ? argv[1] : ""))
        throw InputError(fmt::format(
            "started as {} processes: only `twinwake run` shares its work among them; start the others once",
            ranks.size()));
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
    return chosen(common);
}

constexpr const char* no_memory =
    "out of memory: coarsen [resolution] near_hull; twinwake check shows how much is needed";

/// Of an exception that nobody could catch, such as that of a thread which finds no memory.
[[noreturn]] void end_at_once() {
    const char* what = "unexpected: the program ended itself";
    try {
        if (const std::exception_ptr now = std::current_exception()) std::rethrow_exception(now);
    } catch (const std::bad_alloc&) { what = no_memory; } catch (...) {
    }
    std::fprintf(stderr, "%s\n", what);
    std::_Exit(run_failed);
}

/// Set before the libraries' own beginnings, in which memory may already end.
[[gnu::section(".preinit_array"), gnu::used]] void (*const before_libraries)() = [] {
    std::set_terminate(end_at_once);
};

/// The exit status, and what went wrong.
int status_of(int argc, char** argv, std::string& failure) {
    try {
        return dispatch(argc, argv);
    } catch (const InputError& e) {
        failure = e.what();
        return bad_input;
    } catch (const RunError& e) { failure = e.what(); } catch (const std::bad_alloc&) {
        failure = no_memory;
    } catch (const std::filesystem::filesystem_error& e) {
        failure = in_words(e);
        return bad_input;
    } catch (const std::exception& e) { failure = "unexpected: " + in_words(e); }
    return run_failed;
}

/// Of the whole program. Where several processes share a run, the first one says what went wrong with all of them.
int run_program(int argc, char** argv) {
    std::string failure;
    const Comm* ranks = &Comm::alone();
    int status = bad_input;
    try {
        ranks = &Comm::world();
        status = status_of(argc, argv, failure);
    } catch (const InputError& e) { failure = e.what(); } catch (const std::bad_alloc&) {
        failure = no_memory, status = run_failed;
    }
    if (!failure.empty() && ranks->first()) complain(failure);
    // Lost output is no success; a status that says more than that is kept.
    if (!everything_was_printed() && status == done) status = bad_input;
    return leave_to_starter(ranks->end(status, failure), *ranks);
}

}  // namespace
}  // namespace tw::app

int main(int argc, char** argv) {
    tw::app::spin_briefly(argv);
    // OpenFOAM believes PWD rather than the folder it is started in, and refuses one with a blank: the shell's must not
    // reach it.
    unsetenv("PWD");
    return tw::app::run_program(argc, argv);
}
