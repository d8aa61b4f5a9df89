#include <fmt/format.h>

#include "app/arguments/output.h"
#include "app/commands/scene_of_bodies.h"
#include "app/commands/scene_of_hull.h"
#include "app/commands/templates.h"
#include "base/errors.h"

namespace tw::app {

namespace {

/// The template with what the file of --from gives.
std::string scene_from_file(const NewCommand& command, const Template& from) {
    if (command.kind == "body") return scene_of_bodies(command.from, command.unit, command.axes, command.file);
    if (command.kind == "hull")
        return scene_of_hull(std::string(from.text), command.from, command.unit, command.axes, command.file);
    throw InputError(
        fmt::format("--from makes a scene of a hull or of bodies; expected: twinwake new hull {} --from {}, or "
                    "twinwake new body {} --from {}",
                    command.file.string(), command.from.string(), command.file.string(), command.from.string()));
}

}  // namespace

std::vector<std::string> template_names() {
    std::vector<std::string> names;
    for (const Template& t : templates()) names.emplace_back(t.name);
    return names;
}

std::string templates_in_words() {
    std::string list;
    for (const Template& t : templates()) list += fmt::format("{}{}: {}", list.empty() ? "" : "; ", t.name, t.about);
    return list;
}

int run_new(const NewCommand& command, const Common& common) {
    if (std::filesystem::exists(command.file) && !command.overwrite)
        throw InputError(command.file.string() + ": exists already; choose another name, or --overwrite");
    if (command.from.empty() && (command.unit != "m" || command.axes != "xyz"))
        throw InputError("--unit and --axes are those of the file of --from, which is not given");
    for (const Template& t : templates()) {
        if (t.name != command.kind) continue;
        write_file(command.file, command.from.empty() ? std::string(t.text) : scene_from_file(command, t));
        say(common,
            fmt::format("{}: written. Next: twinwake check {}\n", command.file.string(), command.file.string()));
    }
    return done;
}

}  // namespace tw::app
