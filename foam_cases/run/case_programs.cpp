#include "foam_cases/run/case_programs.h"

#include <fmt/format.h>

#include <algorithm>
#include <chrono>
#include <csignal>
#include <fstream>
#include <thread>

#include "base/errors.h"
#include "foam_cases/read/solver_log.h"
#include "foam_cases/run/environment.h"
#include "foam_cases/run/wrapper.h"

namespace tw {
namespace fs = std::filesystem;

namespace {
bool openfoam_takes(const fs::path& path) {
    const std::string text = path.string();
    return std::all_of(text.begin(), text.end(), [](char c) {
        return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || (c >= '0' && c <= '9') ||
               std::string_view("_./+-").find(c) != std::string_view::npos;
    });
}
}  // namespace

CasePrograms::CasePrograms(const OpenFoam& openfoam, fs::path case_folder)
    : openfoam_(openfoam), case_(fs::absolute(case_folder).lexically_normal()), folder_(case_) {
    if (!openfoam_takes(case_)) {
        aside_.emplace();
        folder_ = aside_->path;
        link_ = folder_ / "case";
        fs::create_directory_symlink(case_, link_);
    }
    environment_ = environment_of(openfoam, folder_);
}

fs::path CasePrograms::find_mpirun() const { return find_program(environment_, "mpirun"); }

std::unique_ptr<ChildProcess> CasePrograms::start(const fs::path& program, std::vector<std::string> arguments,
                                                  const std::string& log_name, int ranks) const {
    const bool wrapped = !openfoam_.prefix.empty();
    const fs::path path = program.has_parent_path() ? program : openfoam_.bin / program;  // never another release's
    if (!wrapped && !fs::exists(path))
        throw RunError(
            fmt::format("'{}' is not in the OpenFOAM installation {} (programs in {}); its package is not complete",
                        program.string(), openfoam_.project_dir.string(), openfoam_.bin.string()));
    // Behind a prefix a program may start elsewhere: a container goes to / where it has not this folder.
    if (!link_.empty() || wrapped)
        arguments.insert(arguments.end(), {"-case", (link_.empty() ? folder_ : link_).string()});
    Command command{path, arguments};
    if (ranks > 1) {
        const fs::path mpirun = wrapped ? "mpirun" : find_mpirun();
        if (mpirun.empty()) throw RunError("mpirun is not on the PATH; install openmpi-bin, or run with one thread");
        // Not bound to cores and yielding while they wait: ranks share the machine with whatever else runs on it. By
        // its full path Open MPI would put its own folder's libraries, and any OpenFOAM there, before the release's.
        command.program = mpirun;
        command.arguments = {"-np",   std::to_string(ranks), "--noprefix", "--bind-to",  "none",
                             "--mca", "mpi_yield_when_idle", "1",          path.string()};
        command.arguments.insert(command.arguments.end(), arguments.begin(), arguments.end());
        command.arguments.push_back("-parallel");
    }
    if (wrapped) command = behind(openfoam_.prefix, command.program.string(), command.arguments, environment_);
    return std::make_unique<ChildProcess>(command, environment_, folder_, log(log_name));
}

Ended CasePrograms::run(const fs::path& program, const std::vector<std::string>& arguments, const Watch& watch,
                        const std::string& log_name) const {
    const std::string name = log_name.empty() ? program.filename().string() : log_name;
    std::error_code none;
    fs::remove(log(name), none);  // of an earlier try
    const auto child = start(program, arguments, name);
    for (double pause = 0.005;; pause = std::min(0.1, 1.5 * pause)) {
        if (const auto ended = child->poll()) {
            if (ended->ok()) return *ended;
            throw RunError(fmt::format(
                "{} failed ({}):\n{}{}", name,
                ended->signal != 0 ? signal_in_words(ended->signal) : fmt::format("exit status {}", ended->status),
                why_it_failed(log(name)),
                openfoam_.prefix.empty() ? ""
                                         : "\n  (it ran behind TWINWAKE_OPENFOAM_PREFIX: " + folder_.string() +
                                               " must be seen there under the same path)"));
        }
        if (watch && watch(*child)) {
            child->signal_group(SIGKILL);
            return child->wait();
        }
        std::this_thread::sleep_for(std::chrono::duration<double>(pause));
    }
}

std::string why_it_failed(const fs::path& log) {
    std::ifstream in(log, std::ios::binary);
    SolverLog reader;
    std::string text(std::istreambuf_iterator<char>(in), {});
    reader.feed(text);
    reader.feed("\n");
    std::string out = reader.fatal().empty() ? reader.tail(12) : reader.fatal();
    // A stack trace is of use to nobody who runs a case.
    std::string kept;
    for (std::size_t at = 0; at < out.size();) {
        const std::size_t end = std::min(out.find('\n', at), out.size());
        const std::string line = out.substr(at, end - at);
        if (line.rfind("#", 0) != 0 && !line.empty()) kept += "  " + line + "\n";
        at = end + 1;
    }
    return kept + "  (all of it: " + log.string() + ")";
}

}  // namespace tw
