#pragma once
#include <filesystem>
#include <string>
#include <vector>

#include "app/progress/run_told.h"

namespace tw::app {

/// How far the runs in a folder are, from the files that they leave there.
class RunsStatus {
public:
    /// Throws InputError where there is nothing to be told of.
    explicit RunsStatus(const std::filesystem::path& folder);

    std::string text() const;
    std::string json() const;
    double share() const;  ///< of all runs, by their predicted times
    bool over() const;     ///< nothing of it runs any longer
    bool all_done() const;
    std::string states() const;  ///< changes when a run begins or ends

private:
    struct Line {
        std::string name;
        std::filesystem::path folder;
        double predicted = 0;  ///< [s]; 0: not known
        RunTold told = {};
        std::string state() const;
        std::string remark() const;
    };
    void read_list();
    void find_runs();
    double seconds_left() const;

    std::filesystem::path folder_;
    std::vector<Line> lines_;
    ProcessName maker_;  ///< of all the runs; no pid: not known
    double listed_ = 0;  ///< when [s since 1970]
};

}  // namespace tw::app
