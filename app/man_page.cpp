#include <fmt/format.h>

#include "app/completion.h"
#include "record/code_version.h"

namespace tw::app {
namespace {

/// Text as groff has it: no hyphen is broken, and no line is a request.
std::string groff(const std::string& text) {
    std::string out;
    for (std::size_t k = 0; k < text.size(); ++k) {
        if ((k == 0 || text[k - 1] == '\n') && (text[k] == '.' || text[k] == '\'')) out += "\\&";
        out += text[k] == '\\' ? "\\e" : text[k] == '-' ? "\\-" : std::string(1, text[k]);
    }
    return out;
}

/// Lines that stay as they are.
std::string as_written(const std::string& text) { return text.empty() ? "" : ".nf\n" + groff(text) + "\n.fi\n"; }

std::string entry(const OfferedOption& option) {
    std::string names;
    for (const std::string& name : option.names) names += (names.empty() ? "" : ", ") + ("\\fB" + groff(name) + "\\fR");
    if (option.takes_value) names += " \\fI" + groff(option.type) + "\\fR";
    return ".TP\n" + names + "\n" + groff(option.help) + "\n";
}

void add_command(const OfferedCommand& command, std::string& page) {
    std::string places;
    for (const OfferedOption& place : command.places) places += " \\fI" + groff(place.names.front()) + "\\fR";
    page +=
        fmt::format(".SS \"twinwake {}\"\n\\fBtwinwake {}\\fR{} [\\fIoptions\\fR]{}\n.PP\n{}.\n", groff(command.path),
                    groff(command.path), command.below.empty() ? "" : " \\fIaction\\fR", places, groff(command.help));
    for (const OfferedOption& place : command.places) page += entry(place);
    for (const OfferedOption& option : command.options) page += entry(option);
    if (!command.more.empty()) page += ".PP\n" + as_written(command.more);
    for (const OfferedCommand& below : command.below) add_command(below, page);
}

}  // namespace

std::string man_page(const OfferedCommand& program) {
    std::string page = fmt::format(".TH TWINWAKE 1 \"\" \"twinwake {}\" \"User commands\"\n", TWINWAKE_CODE_VERSION);
    page += ".SH NAME\ntwinwake \\- drag, lift and splash of a hull in water, by two methods side by side\n";
    page += ".SH SYNOPSIS\n\\fBtwinwake\\fR \\fIcommand\\fR [\\fIoptions\\fR] [\\fIfiles\\fR]\n";
    page += ".SH DESCRIPTION\n" + as_written(program.help);
    page += ".SH OPTIONS\n";
    for (const OfferedOption& option : program.options) page += entry(option);
    page += ".SH COMMANDS\n";
    for (const OfferedCommand& command : program.below) add_command(command, page);
    return page + ".SH NOTES\n" + groff(program.more) + "\n";
}

}  // namespace tw::app
