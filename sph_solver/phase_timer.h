#pragma once
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <string>
#include <utility>

#include "record/run_record.h"
#include "sph_solver/run_files.h"

namespace tw {

/// Wall clock, processor time of this process [s], and the most memory that it has held [bytes].
inline double wall_now() {
    return std::chrono::duration<double>(std::chrono::steady_clock::now().time_since_epoch()).count();
}
inline double cpu_now() {
    rusage u{};
    getrusage(RUSAGE_SELF, &u);
    const auto seconds = [](const timeval& t) { return double(t.tv_sec) + 1e-6 * double(t.tv_usec); };
    return seconds(u.ru_utime) + seconds(u.ru_stime);
}
inline double peak_memory() {
    rusage u{};
    getrusage(RUSAGE_SELF, &u);
    return 1024.0 * double(u.ru_maxrss);
}

/// Adds wall and processor time to a phase of the record while it lives; without that of `files`, where they are
/// written meanwhile.
class PhaseTimer {
public:
    PhaseTimer(RunRecord& record, std::string name, const RunFiles* files = nullptr)
        : record_(record), name_(std::move(name)), files_(files), wall_(wall_now()), cpu_(cpu()) {}
    ~PhaseTimer() {
        auto p =
            std::find_if(record_.phases.begin(), record_.phases.end(), [&](const Phase& q) { return q.name == name_; });
        if (p == record_.phases.end()) p = record_.phases.insert(p, Phase{name_, 0, 0});
        p->wall += wall_now() - wall_;
        p->cpu += std::max(0.0, cpu() - cpu_);  // two clocks, which the system brings up to date at different times
    }
    PhaseTimer(const PhaseTimer&) = delete;
    PhaseTimer& operator=(const PhaseTimer&) = delete;

private:
    double cpu() const { return cpu_now() - (files_ ? files_->cpu() : 0); }

    RunRecord& record_;
    std::string name_;
    const RunFiles* files_;
    double wall_, cpu_;
};

}  // namespace tw
