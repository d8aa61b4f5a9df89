#pragma once

namespace tw::app {

/// From now on the first SIGINT or SIGTERM only asks the run to save its state and end; the second one kills. SIGUSR1
/// asks too: mpirun hands it on to its ranks and waits for them, where SIGTERM makes it end them.
void catch_stop_signals();
bool stop_asked();

}  // namespace tw::app
