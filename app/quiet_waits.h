#pragma once

namespace tw::app {

/// Threads that wait for others sleep instead of spinning. On a core that is shared (a second run, MPI ranks, a busy
/// machine) the spinning costs more than half of the speed (measured: 40 s against 16 s for 300 steps of 55 thousand
/// particles on two busy cores). The OpenMP runtime reads its settings when the program is loaded, so the program
/// starts itself anew once. Whoever sets OMP_WAIT_POLICY or GOMP_SPINCOUNT is obeyed.
void wait_without_spinning(char** argv);

}  // namespace tw::app
