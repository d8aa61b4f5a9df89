#include "app/completion.h"

#include <algorithm>
#include <CLI/CLI.hpp>

#include "app/arguments/output.h"
#include "meshes/generate.h"
#include "scene/effects/registry.h"

namespace tw::app {
namespace {

/// The words that an option or a place takes, as its type says: those between braces, or names that stand in a table.
std::vector<std::string> values_of(const std::string& type) {
    std::vector<std::string> values;
    if (type == "NAME") return effect_names();
    if (type == "NAME=on|off")
        for (const std::string& name : effect_names()) values.insert(values.end(), {name + "=on", name + "=off"});
    if (type == "SHAPE")
        for (const HullShape& shape : hull_shapes()) values.push_back(shape.name);
    const std::size_t open = type.find('{'), close = type.find('}');
    if (open != type.npos && close != type.npos)
        values = CLI::detail::split(type.substr(open + 1, close - open - 1), ',');
    return values;
}

/// A text that is not one of known words is the name of a file more often than anything else.
bool may_be_file(const std::string& type, const std::vector<std::string>& values) {
    return values.empty() && (type.starts_with("TEXT") || type == "FILE");
}

OfferedCommand offered(const CLI::App& app, const std::string& path) {
    OfferedCommand c;
    c.path = path;
    c.help = app.get_description();
    c.more = app.get_footer();  // of its own, and what all commands have
    if (const CLI::App* parent = app.get_parent(); parent && c.more.ends_with(parent->get_footer()))
        c.more.resize(c.more.size() - parent->get_footer().size());
    for (const CLI::Option* option : app.get_options()) {
        const std::string type = option->get_type_name();
        const std::vector<std::string> values = values_of(type);
        OfferedOption o;
        o.type = type;
        o.help = option->get_description();
        if (option->get_positional()) {
            c.words.insert(c.words.end(), values.begin(), values.end());
            c.takes_file = c.takes_file || may_be_file(type, values);
            o.names = {option->get_name(true)};
            c.places.push_back(std::move(o));
            continue;
        }
        o.takes_value = option->get_items_expected_max() > 0;
        if (o.takes_value) o.values = values, o.takes_file = may_be_file(type, values);
        for (const std::string& name : option->get_lnames()) o.names.push_back("--" + name);
        for (const std::string& name : option->get_snames()) o.names.push_back("-" + name);
        c.options.push_back(std::move(o));
    }
    for (const CLI::App* below : app.get_subcommands([](const CLI::App*) { return true; }))
        c.below.push_back(offered(*below, path + (path.empty() ? "" : " ") + below->get_name()));
    return c;
}

}  // namespace

int run_completion(const CompletionCommand& command, const Common& common) {
    const OfferedCommand program = offered(*command.program, "");
    say(common, command.shell == "man"    ? man_page(program)
                : command.shell == "fish" ? fish_completion(program)
                : command.shell == "zsh"  ? zsh_completion(program)
                                          : bash_completion(program));
    return done;
}

}  // namespace tw::app
