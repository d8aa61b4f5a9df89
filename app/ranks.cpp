#include "app/ranks.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <iterator>

#include "app/command_words.h"
#include "base/errors.h"
#include "sph_solver/parallel/comm.h"
#include "sph_solver/ranks_refused.h"

namespace tw::app {
namespace {

/// The words of this command.
std::vector<std::string> own_words() {
    std::ifstream file("/proc/self/cmdline", std::ios::binary);
    const std::string all{std::istreambuf_iterator<char>(file), {}};
    std::vector<std::string> words;
    for (std::size_t at = 0; at < all.size(); at = all.find('\0', at) + 1) words.emplace_back(all.c_str() + at);
    return words;
}

}  // namespace

void refuse_unshared(const Scene& scene, const RunCommand& command, int ranks) {
    const int started = Comm::world().size();
    if (started > 1 && command.ranks > 0 && command.ranks != started)
        throw InputError(fmt::format("--ranks {}: mpirun has started {} processes; leave the option out, or mpirun",
                                     command.ranks, started));
    if (scene.run.methods != std::vector<std::string>{"sph"})
        throw InputError(fmt::format(
            "{} ranks share a run of the particles alone: give --method sph; the mesh method starts its own ranks, "
            "--threads",
            ranks));
    if (command.twins)
        throw InputError(fmt::format(
            "{} ranks make one run: give --no-twins; the coarser runs for the discretisation error fit one process",
            ranks));
    refuse_ranks(scene, ranks);
}

void start_on_ranks(int ranks) {
    if (!Comm::built_with_mpi())
        throw InputError(fmt::format(
            "--ranks {}: this twinwake was built without MPI; install libopenmpi-dev and build anew, or use --threads",
            ranks));
    std::vector<std::string> words{"mpirun", "-n", std::to_string(ranks), "--oversubscribe", "--bind-to", "none"};
    if (geteuid() == 0) words.emplace_back("--allow-run-as-root");
    words.emplace_back("--quiet");  // of mpirun's own remarks on an exit status that is ours
    std::vector<std::string> own = without_options(own_words(), {{"--ranks", 1}});
    std::error_code none;
    if (const std::filesystem::path self = std::filesystem::read_symlink("/proc/self/exe", none); !self.empty())
        own.front() = self;
    words.insert(words.end(), own.begin(), own.end());
    // a run that is told to stop saves its state first; one of which a rank is dead waits for it in vain
    setenv("OMPI_MCA_odls_base_sigkill_timeout", "10", 0);  // mpirun waits twice as long
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    execvp("mpirun", argv.data());
    throw InputError(fmt::format("--ranks {}: mpirun is not on the PATH; install openmpi-bin", ranks));
}

}  // namespace tw::app
