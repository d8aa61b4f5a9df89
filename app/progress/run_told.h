#pragma once
#include <filesystem>
#include <limits>
#include <string>
#include <vector>

#include "app/progress/member_state.h"
#include "record/run_record.h"

namespace tw::app {

/// A process of this machine or another one, as files name it.
struct ProcessName {
    std::string node;
    long pid = 0;
    std::string begun;  ///< its start as the kernel counts it: numbers of processes are used again

    static ProcessName own();
    /// Whether it still runs. Of another machine that is not known: then whether it has told something lately, `told`
    /// [s since 1970].
    bool alive(double told) const;
};

/// One component of the force on the hull or the solids so far.
struct ForceTold {
    std::string name, unit;  ///< fx, fy, fz, my as in the record's table `forces`
    double now = std::numeric_limits<double>::quiet_NaN(), mean = std::numeric_limits<double>::quiet_NaN();
};

/// How far a run has come: RUN/METHOD/progress.json. The run replaces it at most once a second, and it stays when the
/// run has ended; so whoever sees the folder can look.
struct RunTold {
    MemberState::Kind kind = MemberState::Kind::waiting;
    std::string method, why, note;
    ProcessName process = {};
    double told = 0;                ///< when [s since 1970]
    double time = 0, duration = 0;  ///< simulated [s]
    double wall = 0, left = 0;      ///< [s]; left 0: not known
    double steps = 0;               ///< [-]
    double mean_from = 0;           ///< where the means begin [s]
    std::vector<ForceTold> forces = {};
    std::vector<RecordedCheck> checks = {};

    double share() const;
    bool ended() const { return kind != MemberState::Kind::waiting && kind != MemberState::Kind::running; }
    /// Said to be running by a process that has ended.
    bool lost() const { return kind == MemberState::Kind::running && !process.alive(told); }
};

inline constexpr const char* progress_file = "progress.json";
double seconds_since_1970();
std::string json_of(const RunTold& told);
/// Waiting where there is no file, or none that can be read.
RunTold read_run_told(const std::filesystem::path& folder);

/// A run of those that a command makes one after another.
struct ListedRun {
    std::string name;
    std::filesystem::path folder;  ///< within that of the results
    double seconds = 0;            ///< predicted [s]
};
/// Those runs as a file in the command's folder of results, OUT/runs.json: with it `status` knows those that have not
/// begun.
struct RunsList {
    ProcessName maker = {};
    double told = 0;  ///< when [s since 1970]
    std::vector<ListedRun> runs = {};
};
inline constexpr const char* runs_list_file = "runs.json";
std::string json_of(const RunsList& list);
/// Throws InputError: it is not there or cannot be read.
RunsList read_runs_list(const std::filesystem::path& out);

}  // namespace tw::app
