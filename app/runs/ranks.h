#pragma once
#include <functional>
#include <string>

#include "app/arguments/commands.h"
#include "app/runs/run_method.h"
#include "scene/scene.h"
#include "sph_solver/parallel/comm.h"

namespace tw::app {

/// Throws InputError where the ranks of `plan` cannot share its run: methods that are not the particles, a program
/// without MPI. `option`: that of --ranks; 0: the scene's
/// key, whose place the text then names.
void refuse_unshared(const PlannedRun& plan, int option);

/// Likewise of what else was asked of the run: coarser members, a study, other ranks than mpirun has started.
void refuse_unshared(const PlannedRun& plan, const RunCommand& command);

/// What each of the ranks takes, in a line and for programs; of one rank a line alone. Throws InputError likewise, and
/// where there are fewer pencils of particles than ranks.
struct RanksTake {
    std::string line;
    int ranks = 1;
    double particles = 0, copies = 0, bytes = 0, seconds = 0;  ///< of the rank with most [-], [-], [bytes], [s]
    double bytes_at_start = 0;                                 ///< of the first one [bytes]
};
RanksTake ranks_take(const PlannedRun& plan, int option);

/// Where a scene asks for ranks, that the runs of a study have none; else nothing.
std::string unused_ranks(const Scene& scene);

/// Has mpirun start this very command on so many ranks, passes on signals that ask to stop, and returns their exit
/// status. Throws InputError: no mpirun; RunError: it says that all went well, and the run is not `made`.
int run_on_ranks(int ranks, const std::function<bool()>& made);

/// Of a rank, with the `status` of all: the exit status of this process. Where run_on_ranks has started it, that is 0,
/// and the first rank leaves `status` to it in a file: after any other exit status mpirun waits, up to 20 s, for ranks
/// that have ended.
int leave_to_starter(int status, const Comm& ranks);

}  // namespace tw::app
