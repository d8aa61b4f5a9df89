#pragma once
#include <string>
#include <vector>

#include "app/arguments/commands.h"

namespace CLI {
class App;
}

namespace tw::app {

struct CompletionCommand {
    std::string shell;                  ///< bash, zsh, fish
    const CLI::App* program = nullptr;  ///< whose options and subcommands are offered
};
int run_completion(const CompletionCommand& command, const Common& common);

/// An option as it may be typed, or what may stand where no option does.
struct OfferedOption {
    std::vector<std::string> names;  ///< "--out", "-o"; of a place one: "scene"
    std::string type;                ///< "TEXT", "{sph,fvm,both}"
    std::string help;
    std::vector<std::string> values;  ///< that it takes; empty: it takes none, or others
    bool takes_value = false, takes_file = false;
};

/// What may be typed behind the program, a subcommand or an action of one.
struct OfferedCommand {
    std::string path;        ///< "", "run", "hull make"
    std::string help, more;  ///< one sentence; what stands below the options
    std::vector<OfferedOption> options, places;
    std::vector<std::string> words;  ///< that may stand where no option does
    bool takes_file = false;         ///< a file may stand there
    std::vector<OfferedCommand> below;
};

/// The manual page, for groff.
std::string man_page(const OfferedCommand& program);

// Scripts that complete the command in a shell; they know what they are given and nothing else.
std::string bash_completion(const OfferedCommand& program);
std::string zsh_completion(const OfferedCommand& program);
std::string fish_completion(const OfferedCommand& program);

}  // namespace tw::app
