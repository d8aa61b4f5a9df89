#pragma once
#include <functional>
#include <string>
#include <vector>

#include "stability/hard_case.h"
#include "stability/judge.h"

namespace tw {

/// One number of a case that a map varies.
struct MapAxis {
    std::string name;  ///< with its unit, e.g. "deadrise [deg]"
    double HardCase::*number = nullptr;
    std::vector<double> values;
};
struct MapCell {
    HardCase c;
    HardCaseRun run;
    StabilityJudgement judgement;
};
/// A cut through the room of all numbers: two of them over their ranges, the rest as in `base`.
struct StabilityMap {
    std::string title;
    HardCase base;
    MapAxis x, y;
    std::vector<MapCell> cells;  ///< row by row: x runs fastest
    const MapCell& at(std::size_t ix, std::size_t iy) const { return cells[iy * x.values.size() + ix]; }
};

/// The maps to run, cells not yet run. `quick`: half as fine (the tank 0.7 times).
std::vector<StabilityMap> stability_maps(bool quick);

struct MapProgress {
    double share = 0;               ///< of the predicted work
    double seconds = 0, left = 0;   ///< [s] wall; left 0: not known yet
    std::size_t done = 0, all = 0;  ///< cases
    std::string now;                ///< what runs
};
/// Runs every cell, equal ones once, `threads` cases at a time (0: as many as there are cores); the result does not
/// depend on it. `show` is called from one thread at a time. False: `stop` said so, and the maps are not complete.
bool run_stability_maps(std::vector<StabilityMap>& maps, int threads,
                        const std::function<void(const MapProgress&)>& show, const std::function<bool()>& stop);

/// "impact, 30 m/s, 30 deg, h/dp 1.5, CFL 0.7, c0/U 40"
std::string describe(const HardCase& c);

}  // namespace tw
