#include "foam_cases/doctor.h"

#include <fmt/format.h>
#include <unistd.h>

#include <cstdlib>
#include <fstream>
#include <sstream>
#include <thread>

#include "app/about.h"
#include "app/arguments/output.h"
#include "app/pace/machine_pace.h"
#include "app/runs/facts_json.h"
#include "app/runs/solvers.h"
#include "base/errors.h"
#include "foam_cases/own_openfoam.h"
#include "methods/names.h"
#include "record/code_version.h"
#include "record/this_machine.h"
#include "sph_solver/gpu_self_test.h"
#include "sph_solver/on_gpu.h"

namespace tw::app {
namespace {

namespace fs = std::filesystem;

/// Full path of a program on PATH; empty when it is not there.
std::string on_path(const std::string& program) {
    const char* path = std::getenv("PATH");
    std::istringstream folders(path ? path : "");
    for (std::string folder; std::getline(folders, folder, ':');) {
        const fs::path candidate = fs::path(folder) / program;
        if (::access(candidate.c_str(), X_OK) == 0 && !fs::is_directory(candidate)) return candidate.string();
    }
    return {};
}

std::string graphics_card() {
    std::error_code ignored;
    for (const auto& card : fs::directory_iterator("/proc/driver/nvidia/gpus", ignored)) {
        std::ifstream facts(card.path() / "information");
        for (std::string line; std::getline(facts, line);)
            if (line.starts_with("Model:")) return line.substr(line.find_first_not_of(" \t", 6));
    }
    return {};
}

void ask_gpu(MachineFacts& f) {
    try {
        f.gpu_error = gpu_self_test();
        const bool sound = f.gpu_error < sound_gpu_error;
        f.gpu_verdict = fmt::format("{}: error {:.2g} % of the pressure at the floor in water at rest",
                                    sound ? "sound" : "NOT SOUND", 100 * f.gpu_error);
        if (sound) f.gpu_pace = calibrate_gpu_pace(pace_on_gpu(sph_method));
    } catch (const RunError& e) { f.gpu_verdict = std::string("NOT SOUND: ") + e.what(); } catch (const InputError& e) {
        f.gpu_verdict = std::string("not tested: ") + e.what();
    }
}

MachineFacts examine(const std::string& preferred) {
    MachineFacts f;
    f.version = TWINWAKE_CODE_VERSION;
    f.built_with = TWINWAKE_COMPILER;
    for (const char* compiler : {"g++", "clang++", "nvcc"})
        if (const std::string found = on_path(compiler); !found.empty()) f.compilers.push_back(found);
    f.processor = cpu_model();
    f.isa = instruction_set();
    f.cores = std::thread::hardware_concurrency();
    f.memory = static_cast<double>(sysconf(_SC_PHYS_PAGES)) * static_cast<double>(sysconf(_SC_PAGESIZE));
    f.mpirun = on_path("mpirun");
    f.gpu = graphics_card();
    f.gpu_reason = why_no_gpu_here();
    if (f.gpu_reason.empty()) ask_gpu(f);
    f.passes = measure_passes(runnable_passes());
    remember_passes(best_of(f.passes));
    f.chosen_passes = choose_passes().isa;
    f.pace = calibrate_pace();
    f.openfoam = find_openfoam(preferred);
    // A run takes the release whose environment is loaded, sound or not.
    for (const OpenFoam& one : f.openfoam) f.sound |= one.sound && one.loaded == f.openfoam.front().loaded;
    return f;
}

}  // namespace

int run_doctor(const DoctorCommand& command, const Common& common) {
    const MachineFacts f = examine(command.openfoam);
    std::string out =
        fmt::format("twinwake    {}\n            built with {}\nprocessor   {}, {} cores, {}\nmemory      {:.3g} GB\n",
                    f.version, f.built_with, f.processor, f.cores, f.isa, f.memory / 1e9);
    for (const std::string& c : f.compilers) out += "compiler    " + c + "\n";
    out +=
        "mpirun      " + (f.mpirun.empty() ? std::string("none: the mesh method runs on one core") : f.mpirun) + "\n";
    out += "graphics    " + (f.gpu.empty() ? std::string("no NVIDIA card") : f.gpu) + "; " +
           (f.gpu_reason.empty() ? "particles can run on it: " + gpu_in_words() + "\n            " + f.gpu_verdict
                                 : "not used: " + f.gpu_reason) +
           "\n";
    if (f.gpu_pace > 0)
        out +=
            fmt::format("            {:.3g} times the speed of a core of the cost table's machine\n", 1 / f.gpu_pace);
    out += fmt::format(
        "pace        {:.2g} times the speed of the cost table's machine, from a calibration on one core; refined by "
        "every "
        "run\n",
        1 / f.pace);
    out += fmt::format("pair loops  {} in new runs; on one core {}\n", f.chosen_passes, passes_line(f.passes));
    for (const OpenFoam& o : f.openfoam)
        out += fmt::format("openfoam    {}{}: {}: {}\n", o.command(), o.loaded ? " (environment loaded)" : "",
                           o.sound ? "sound" : "NOT SOUND", o.verdict);
    if (f.openfoam.empty())
        out += "openfoam    none found: on Debian and Ubuntu sudo apt-get install --no-install-recommends openfoam\n";
    out += f.sound ? std::string("\nsound: both methods can run here\n")
                   : fmt::format(
                         "\nnot sound: only the particle method can run here. This builds a sound OpenFOAM in two "
                         "minutes, or says what it needs:\n  {}\n{}",
                         setup_command(), about_openfoam);
    say(common, out);
    if (common.quiet && !f.sound)
        complain("not sound: only the particle method can run here; " + setup_command() + " builds a sound OpenFOAM");
    write_json(common, doctor_json(f));
    return f.sound ? done : bad_input;
}

}  // namespace tw::app
