#pragma once
#include <chrono>
#include <string>

#include "scene/run/run_options.h"

namespace tw::app {

/// Shows how far a run is on standard error: one line that is rewritten on a terminal and no wider than it, a line
/// every tenth of the run or every half minute (whichever is rarer) in a log. Nothing is coloured, so that NO_COLOR has
/// nothing to take away.
class ProgressBar {
public:
    ProgressBar(std::string label, bool quiet);
    ~ProgressBar();
    void show(const Progress& progress);
    /// Work that is no simulated time: its share done, wall time gone and left [s] (0: not known), what was done.
    void show(double share, double wall, double left, const std::string& done, const std::string& note);

    /// Takes the line off a terminal, for others to be printed there.
    void clear() const;

private:
    bool due(double share, bool phase) const;
    void draw(double share, const std::string& facts);

    std::string label_;
    bool quiet_, terminal_, shown_ = false;
    std::chrono::steady_clock::time_point last_;
    double last_share_ = -1;
    std::string last_note_;
};

}  // namespace tw::app
