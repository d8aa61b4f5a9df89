#pragma once
#include <functional>
#include <string>
#include <vector>

#include "app/arguments/commands.h"

namespace CLI {
class App;
}

namespace tw::app {

/// What a subcommand does once its options have been read; returns the exit status.
using Call = std::function<int(const Common&)>;

/// One subcommand of the program.
struct Subcommand {
    std::string name, help;
    std::function<Call(CLI::App&)> add;  ///< gives it its options; empty: it only has subcommands below
    bool json = true;                    ///< takes --json
    std::string about = {};              ///< below the options in its help
    std::vector<Subcommand> below = {};  ///< of which one has to be given
};

/// The table: all that the program can do.
std::vector<Subcommand> subcommands();

}  // namespace tw::app
