#pragma once
#include <vector>

#include "app/progress/member_state.h"
#include "app/study/study.h"

namespace tw::app {

/// How many runs at a time, and whether each has one core, ranks of MPI too, as by default (jobs_by_default.h).
struct Sharing {
    int jobs = 1;
    bool one_core_each = false;
};

/// Of this machine, for all runs together [bytes].
double memory_for_jobs();

/// Runs the members of a study on this machine, each as a process of this program (`twinwake member`), the longest
/// first, at most so many at a time and no more than cores and memory allow; one that several processes share starts
/// those. Cores are shared by predicted time among members whose bits do not depend on their number; the others have
/// those that they would have alone, unless each is to have one. SIGINT and SIGTERM are handed on. One that fails does
/// not end the others. Returns their states: waiting are those that a stop kept from being begun.
std::vector<MemberState> run_side_by_side(const Study& study, const Sharing& sharing, const Common& common);

/// Cores for a member when the next `waiting` of them (in the order in which they are begun, it is the first) are to
/// share `free` cores: its part of their predicted time, and at least one for each of the others.
int share_of_cores(const std::vector<double>& waiting, int free);

}  // namespace tw::app
