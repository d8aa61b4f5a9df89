#pragma once
#include <vector>

namespace tw::app {

/// The cost of one run of a study.
struct JobCost {
    double core_seconds = 0;  ///< on one core [s]
    double bytes = 0;         ///< [bytes]
    double cores_alone = 1;   ///< that it gets when it runs by itself [-]
    bool threads = false;     ///< its cores are threads, whose number changes no bit; else ranks of MPI
};

/// How many runs of a study go side by side, and what that is worth by prediction.
struct SideBySideChoice {
    int jobs = 1;                         ///< 1: one after another, each with all the cores it can use
    double one_by_one = 0, together = 0;  ///< wall time of the study [s]
};

/// On `cores` cores and with `memory` bytes, where the user says nothing: as many at a time as there are cores, each on
/// one of them, where that is faster by a tenth and the study takes more than half a minute. By the cost table, another
/// core of a run is worth 0.97 of the first as a thread of the particles (1.97 times on two), and 0.7 as a rank of
/// interFoam (1.7 times on two); the other runs need no more than one core each. The largest runs have to fit the
/// memory together.
SideBySideChoice jobs_by_default(std::vector<JobCost> runs, int cores, double memory);

}  // namespace tw::app
