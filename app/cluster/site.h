#pragma once
#include <filesystem>
#include <string>
#include <vector>

namespace tw::app {

/// What jobs on a cluster ask for: from a site file and, before it, from the command line. Empty: not said.
struct Site {
    std::string account, partition, qos;
    std::string gpus;                  ///< as --gpus of sbatch has it
    std::string time;                  ///< the longest a job may ask for, a text with unit
    std::vector<std::string> modules;  ///< loaded in this order
    std::string container;             ///< words in front of the program, e.g. "apptainer exec twinwake.sif"
    std::string program;               ///< of the nodes; empty: this one
    int cores = 0;                     ///< at most for one run; 0: 32
    int limit = 0;                     ///< runs of one array at a time; 0: any number
};

/// What is missing in `first` taken from the file. An empty name: $XDG_CONFIG_HOME/twinwake/site.toml (~/.config) if it
/// is there. Throws InputError with the line: an unknown key, or a value that is no word of Slurm's.
Site completed(Site first, const std::filesystem::path& file);

inline constexpr const char* about_site =
    "\nA site file says once what a cluster asks for (TOML; --site FILE, else ~/.config/twinwake/site.toml):\n"
    "  account = \"hydro\"\n  partition = \"compute\"\n  qos = \"normal\"\n"
    "  time = \"12 h\"                    the longest a job may ask for\n"
    "  cores = 32                       at most for one run\n"
    "  limit = 8                        runs of one array at a time\n"
    "  gpus = \"1\"                       as sbatch --gpus has it\n"
    "  modules = [\"openmpi/4.1\"]\n"
    "  container = \"apptainer exec /sw/twinwake.sif\"\n  program = \"twinwake\"             of the nodes, where it is "
    "another\n\n";

}  // namespace tw::app
