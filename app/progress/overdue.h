#pragma once
#include <optional>
#include <string>

#include "scene/run/run_options.h"

namespace tw::app {

/// Whether a run will take several times what was predicted of it: seen once, after its first minute.
class Overdue {
public:
    /// `predicted` [s] for the whole run; 0: nothing was predicted, and nothing is overdue.
    explicit Overdue(double predicted) : predicted_(predicted) {}
    /// A sentence where it will take at least three times as long by the pace of its steps so far; else empty, and empty
    /// once it has been said. Meshing and what an earlier start has computed do not count.
    std::string look(const Progress& progress);

private:
    struct Start {
        double time, wall;  ///< simulated and wall [s]
    };
    double predicted_;
    std::optional<Start> start_ = {};
    bool looked_ = false;
};

}  // namespace tw::app
