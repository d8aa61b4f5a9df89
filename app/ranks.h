#pragma once
#include "app/run_method.h"

namespace tw::app {

/// Throws InputError where a run cannot be shared among so many processes: another method than the particles, twins, a
/// scene that the engine refuses (sph_solver/ranks_refused.h), or other ranks than mpirun has started.
void refuse_unshared(const Scene& scene, const RunCommand& command, int ranks);

/// Becomes mpirun, which starts this very command on so many ranks. Returns only by InputError: no MPI, or no mpirun.
[[noreturn]] void start_on_ranks(int ranks);

}  // namespace tw::app
