#include "app/runs/ranks.h"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/prctl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <cerrno>
#include <csignal>
#include <cstdlib>
#include <cstring>
#include <fstream>
#include <iterator>

#include "app/arguments/output.h"
#include "app/terminal/command_words.h"
#include "base/atomic_file.h"
#include "base/errors.h"
#include "compare/report/numbers.h"
#include "methods/names.h"
#include "sph_solver/parallel/comm.h"
#include "sph_solver/rank_model.h"
#include "sph_solver/scene_setup.h"
#include "text/plain_number.h"

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

/// What asks for the ranks, for messages.
std::string asked_by(const Scene& scene, int option) {
    return option > 0 ? fmt::format("--ranks {}", option) : scene.place_of("run.ranks");
}

/// Runs `part`, whose InputError then begins with what asks for the ranks.
template <class Part>
auto placed(const Scene& scene, int option, const Part& part) {
    try {
        return part();
    } catch (const InputError& e) { throw InputError(asked_by(scene, option) + ": " + e.what()); }
}

constexpr int no_program = 127;  ///< an exit status of none of ours
volatile std::sig_atomic_t passes_to = 0;

/// Runs a program of the PATH in a process group of its own, so that each signal reaches it once, and to which those
/// that end this process are passed on; it ends with this one. Its exit status, 128 + signal where one ended it;
/// no_program: it is not there.
int status_of(std::vector<std::string>& words) {
    std::vector<char*> argv;
    for (std::string& word : words) argv.push_back(word.data());
    argv.push_back(nullptr);
    const pid_t parent = getpid(), child = fork();
    if (child < 0) throw RunError(std::string("no process can be started: ") + std::strerror(errno));
    if (child == 0) {
        setpgid(0, 0);
        prctl(PR_SET_PDEATHSIG, SIGTERM);
        const int nothing = open("/dev/null", O_RDONLY);  // behind the terminal's group nobody reads from it
        if (getppid() == parent && dup2(nothing, STDIN_FILENO) >= 0) execvp(argv.front(), argv.data());
        _exit(no_program);
    }
    setpgid(child, child);  // whichever of the two comes first
    passes_to = child;
    struct sigaction pass {};
    pass.sa_handler = [](int signal) { kill(static_cast<pid_t>(passes_to), signal); };
    for (const int signal : {SIGINT, SIGTERM, SIGHUP, SIGUSR1}) sigaction(signal, &pass, nullptr);
    int status = 0;
    while (waitpid(child, &status, 0) < 0 && errno == EINTR) {}
    return WIFEXITED(status) ? WEXITSTATUS(status) : 128 + WTERMSIG(status);
}

constexpr const char* status_file = "TWINWAKE_RANKS_STATUS";  ///< environment: where the first rank leaves the status

}  // namespace

void refuse_unshared(const PlannedRun& plan, int option) {
    const Scene& scene = plan.scene;
    const int ranks = scene.run.ranks;
    if (ranks <= 1) return;
    const auto refuse = [&](const std::string& why) {
        throw InputError(fmt::format("{}: {}", asked_by(scene, option), why));
    };
    if (std::ranges::find(scene.run.methods, sph_method) == scene.run.methods.end())
        refuse(fmt::format(
            "{} ranks share a run of the particles, and there is none: the mesh method starts its own ranks, --threads",
            ranks));
    if (!Comm::built_with_mpi())
        refuse(
            "this twinwake was built without MPI; install libopenmpi-dev and build anew, or use --threads with one "
            "rank");
}

void refuse_unshared(const PlannedRun& plan, const RunCommand& command) {
    const int started = Comm::world().size(), ranks = plan.scene.run.ranks;
    if (started > 1 && command.ranks > 0 && command.ranks != started)
        throw InputError(fmt::format("--ranks {}: mpirun has started {} processes; leave the option out, or mpirun",
                                     command.ranks, started));
    if (ranks <= 1) return;
    const std::string asked = started > 1 ? fmt::format("mpirun -n {}", started) : asked_by(plan.scene, command.ranks);
    if (started > 1 && (command.coarser_members || plan.scene.run.methods.size() > 1))
        throw InputError(
            fmt::format("{}: {} processes make one run: give --method sph --no-twins, or leave mpirun out and give "
                        "--ranks {}, which "
                        "starts the processes of each run",
                        asked, ranks, ranks));
    refuse_unshared(plan, started > 1 ? started : command.ranks);
}

RanksTake ranks_take(const PlannedRun& plan, int option) {
    const Scene& scene = plan.scene;
    RanksTake take;
    take.ranks = scene.run.ranks;
    if (take.ranks <= 1) {
        if (Comm::built_with_mpi()) take.line = "ranks: one; several processes can share the particles (run --ranks)\n";
        return take;
    }
    refuse_unshared(plan, option);
    SphSetup setup = sph_setup(scene, scene.run.threads);
    const Simulation simulation(setup.simulation, setup.fluid);
    placed(scene, option, [&] { simulation.level(0).share().refuse_idle(take.ranks); });
    take.bytes_at_start = simulation.bytes();
    for (const Fluid& fluid : setup.fluid)
        take.bytes_at_start += double(fluid.places.size()) * double(sizeof(fluid.places[0]) + sizeof(fluid.depth[0]));

    double all = 0, work = 0, talk = 0, largest_work = 0;
    for (const PencilsOfSize& size : pencils_of_water(simulation)) {
        const Division d = divide(size, setup.simulation.mirrors, take.ranks);
        take.particles += d.own_particles, take.copies += d.copies, all += size.all_particles;
        work += size.steps * size.all_work, largest_work += size.steps * d.imbalance * size.all_work;
        talk += size.steps * seconds_of_talk(d, take.ranks);
    }
    const MethodCost& cost = plan.prediction.of(sph_method);
    const double raster = plan.prediction.raster_bytes;
    take.bytes = raster + (cost.bytes - raster) * (take.particles + take.copies) / all;
    take.seconds = cost.seconds * largest_work / work + talk * cost.steps;
    take.line = fmt::format(
        "ranks: {}; the largest has {} particles of its own and {} copies, {:.3g} MB; the first has all particles "
        "while it starts, {:.3g} MB; {}\n",
        take.ranks, plain_number(take.particles), plain_number(take.copies), take.bytes / 1e6,
        take.bytes_at_start / 1e6, about_text(take.seconds));
    return take;
}

std::string unused_ranks(const Scene& scene) {
    if (!scene.places.contains("run.ranks")) return {};
    return scene.place_of("run.ranks") + ": not used here; each run of a study is one process\n";
}

int run_on_ranks(int ranks, const std::function<bool()>& made) {
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
    std::string folder = std::filesystem::temp_directory_path() / "twinwake_ranks_XXXXXX";
    if (!mkdtemp(folder.data())) throw RunError(folder + ": no folder can be made there: " + std::strerror(errno));
    const std::filesystem::path file = std::filesystem::path(folder) / "status";
    setenv(status_file, file.c_str(), 1);
    int status = status_of(words);
    if (status == done && std::filesystem::exists(file)) status = std::stoi(read_text(file));
    std::filesystem::remove_all(folder, none);
    if (status == no_program)
        throw InputError(fmt::format("--ranks {}: mpirun is not on the PATH; install openmpi-bin", ranks));
    if (status == done && !made())
        throw RunError(
            fmt::format("--ranks {}: mpirun ended with exit status 0, and the run was not made. Is the mpirun on the "
                        "PATH that of Open MPI, with which this twinwake was built?",
                        ranks));
    return status;
}

int leave_to_starter(int status, const Comm& ranks) {
    const char* file = std::getenv(status_file);
    if (!ranks.many() || !file) return status;
    if (!ranks.first()) return done;
    try {
        write_text_atomically(file, std::to_string(status));
    } catch (const std::exception&) { return status; }  // the starter's folder is on another node, or its disk is full
    return done;
}

}  // namespace tw::app
