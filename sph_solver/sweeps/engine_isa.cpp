// The engine's own sweeps, once per variant.
#include "sph_solver/sweeps/extrapolate.h"
#include "sph_solver/sweeps/right_hand_side.h"
#ifdef TW_THREADS
#include "sph_solver/sweeps/search_in_threads.h"
#else
#include "sph_solver/sweeps/search.h"
#endif
