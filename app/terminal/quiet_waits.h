#pragma once

namespace tw::app {

/// Threads that wait for others spin for some tens of microseconds and then sleep. On a core that is shared (a second
/// run, MPI ranks, a busy machine) spinning on and on costs more than half of the speed (measured: 40 s against 16 s for
/// 300 steps of 55 thousand particles on two busy cores); sleeping at once costs a sixth of it where the cores are free
/// and particles have several sizes, because there are many short loops (7.2 s against 6.1 s for 0.25 s of
/// studies/planing_prism_levels.toml --scale 2 on two cores). The OpenMP runtime reads its settings when the program is
/// loaded, so the program starts itself anew once. Whoever sets OMP_WAIT_POLICY or GOMP_SPINCOUNT is obeyed.
void spin_briefly(char** argv);

}  // namespace tw::app
