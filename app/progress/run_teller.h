#pragma once
#include <array>
#include <chrono>
#include <filesystem>
#include <string>

#include "app/progress/run_told.h"
#include "scene/run/run_options.h"

namespace tw::app {

/// The forces of a run that grows, and their file: RUN/METHOD/forces.csv, one row for each 2000th of the run's
/// duration, the mean over the time since the row before. It is written anew where a run begins or is resumed.
class ForcesSoFar {
public:
    /// `mean_from` [s]: where the running means begin.
    ForcesSoFar(std::filesystem::path file, double mean_from) : file_(std::move(file)), mean_from_(mean_from) {}
    /// Takes the rows of table `forces` that are new. `duration` [s] of the run.
    void take(const RunRecord& record, double duration);
    const std::vector<ForceTold>& told() const { return told_; }

private:
    /// Sum over time of a value, and the time over which it is known.
    struct Sum {
        double value = 0, time = 0;
        void add(double v, double seconds);
        double mean() const { return value / time; }  ///< NaN where nothing is known
    };
    void begin(const Table& forces);

    std::filesystem::path file_;
    double mean_from_;
    std::vector<ForceTold> told_;
    std::vector<Sum> row_, all_;  ///< of each component: since the row before, since `mean_from`
    std::size_t read_ = 0;        ///< rows of the table
    double last_ = 0;             ///< time of the last of them [s]
    double next_row_ = 0;         ///< [s]
};

/// Leaves how far one run has come in its folder, at most once a second.
class RunTeller {
public:
    /// `speaks`: of the processes that share a run one alone writes.
    RunTeller(std::filesystem::path folder, std::string method, double mean_from, bool speaks);
    void progress(const Progress& progress);
    /// A message for those who watch the run, shown from the next progress on.
    void warn(const std::string& what) { told_.why = what; }
    /// `state` and `reason` as in a run's record.
    void end(const RunRecord& record);
    /// Begun, and not finished. Nothing where it had not begun: the folder may be another run's.
    void failed(const std::string& why);

private:
    void write();

    std::filesystem::path folder_;
    bool speaks_, begun_ = false;
    RunTold told_;
    ForcesSoFar forces_;
    std::chrono::steady_clock::time_point written_;
};

}  // namespace tw::app
