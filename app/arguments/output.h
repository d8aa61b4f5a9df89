#pragma once
#include <filesystem>
#include <string>

#include "app/arguments/commands.h"
#include "base/errors.h"
#include "base/in_words.h"

namespace tw::app {

/// Prints `text` unless quiet, or unless standard output is taken by --json -. Control characters that a scene or a
/// record brought along do not reach the terminal.
void say(const Common& common, const std::string& text);
/// An error or a result that was asked for: one line on standard error, quiet or not, as safe as say().
void complain(const std::string& line);
/// Writes the facts where --json asks for them; nothing without --json. Throws InputError: it cannot be written.
void write_json(const Common& common, const std::string& json);
/// Refuses, before any work, a --json file whose folder is not there or not writable. Throws InputError.
void refuse_unwritable_json(const Common& common);
/// Writes a whole file, into a device or a pipe too. Throws InputError: what a command leaves beside its runs is the
/// user's choice of a place, not a run that failed.
void write_file(const std::filesystem::path& file, const std::string& text);
/// Makes a folder for results and those above it. Throws InputError: it cannot be made.
void make_folder(const std::filesystem::path& folder);
/// Standard output, flushed. False, with the reason on standard error: something of it was lost.
bool everything_was_printed();

/// Calls `write`, which leaves files other than a run's own; what cannot be written is the user's to mend (InputError).
template <class Write>
auto leaving_files(Write write) {
    try {
        return write();
    } catch (const RunError& e) { throw InputError(e.what()); } catch (const std::filesystem::filesystem_error& e) {
        throw InputError(in_words(e));
    }
}

}  // namespace tw::app
