#include "foam_cases/run/solve.h"

#include <fmt/format.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <thread>

#include "base/atomic_file.h"
#include "foam_cases/run/body_guard.h"
#include "foam_cases/run/watchdog.h"

namespace tw {
namespace fs = std::filesystem;

namespace {

/// Waits for a child that was asked to end by itself; ends it after `patience` seconds.
Ended end_gently(ChildProcess& child, double patience) {
    const double until = wall_clock() + patience;
    while (wall_clock() < until) {
        if (const auto ended = child.poll()) return *ended;
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    child.signal_group(SIGTERM);
    const double killed = wall_clock() + 10;
    while (wall_clock() < killed) {
        if (const auto ended = child.poll()) return *ended;
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
    child.signal_group(SIGKILL);
    return child.wait();
}

}  // namespace

long long follow(const fs::path& file, long long offset, SolverLog& log) {
    std::ifstream in(file, std::ios::binary);
    if (!in) return offset;
    in.seekg(offset);
    std::string chunk(1 << 16, '\0');
    while (in.read(chunk.data(), static_cast<std::streamsize>(chunk.size())) || in.gcount() > 0) {
        log.feed(std::string_view(chunk.data(), static_cast<std::size_t>(in.gcount())));
        offset += in.gcount();
    }
    return offset;
}

SolverOutcome solve(const CasePlan& plan, const CasePrograms& programs, int ranks, SolverLog& log,
                    const std::function<bool()>& growing,
                    const std::function<std::optional<std::string>()>& wrong_in_water) {
    const fs::path stop_file = programs.case_folder() / "stop", log_file = programs.log("solver");
    std::error_code none;
    fs::remove(stop_file, none);
    long long offset = follow(log_file, 0, log);  // earlier starts of the same run
    SolverLog now;                                // this start only: its end, its errors
    long long now_offset = offset;
    const Limits limits = limits_of(plan);

    const auto child = programs.start(programs.openfoam().solver, plan.flavour.solver_arguments(), "solver", ranks);
    SolverOutcome out;
    double last_look = 0, started = wall_clock();
    for (;;) {
        const auto ended = child->poll();
        offset = follow(log_file, offset, log);
        now_offset = follow(log_file, now_offset, now);
        if (ended) {
            out.process = *ended;
            break;
        }
        if (growing()) {
            out.stopped = true;
            write_text_atomically(stop_file, "twinwake asks the solver to write its state and end\n");
            const double per_step =
                now.steps().empty() ? 60 : (wall_clock() - started) / static_cast<double>(now.steps().size());
            out.process = end_gently(*child, 30 + 20 * per_step);
            fs::remove(stop_file, none);
            break;
        }
        if (wall_clock() - last_look > 1) {
            last_look = wall_clock();
            const double time = now.steps().empty() ? 0 : now.steps().back().time;
            std::optional<std::string> wrong =
                trouble(now, latest_fastest(programs.case_folder() / "postProcessing", time), limits);
            if (!wrong) wrong = body_trouble(plan, now);
            if (!wrong) wrong = wrong_in_water();
            // Two more write times and the record have to fit.
            if (!wrong) wrong = disk_trouble(programs.case_folder(), 50e6);
            if (wrong) {
                out.failure = *wrong;
                write_text_atomically(stop_file, "twinwake stops the solver: the run has failed\n");
                out.process = end_gently(*child, 20);
                fs::remove(stop_file, none);
                break;
            }
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(200));
    }
    offset = follow(log_file, offset, log);
    follow(log_file, now_offset, now);
    const double reached = now.steps().empty() ? 0 : now.steps().back().time;
    if (out.failure.empty() && !out.stopped && (!out.process.ok() || !now.ended() || !now.fatal().empty())) {
        const std::string how = out.process.signal != 0   ? signal_in_words(out.process.signal)
                                : out.process.status != 0 ? fmt::format("exit status {}", out.process.status)
                                                          : std::string("it ended without reaching the end time");
        out.failure = fmt::format("{} died at t = {:.6g} of {:.6g} s ({}):\n{}", programs.openfoam().solver.string(),
                                  reached, plan.scene->run.duration, how, why_it_failed(log_file));
    }
    return out;
}

}  // namespace tw
