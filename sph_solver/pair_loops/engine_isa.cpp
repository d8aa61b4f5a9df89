// The engine's own pair loops, once per variant.
#include "sph_solver/pair_loops/extrapolate.h"
#include "sph_solver/pair_loops/right_hand_side.h"
#ifdef TW_THREADS
#include "sph_solver/pair_loops/search_in_threads.h"
#else
#include "sph_solver/pair_loops/search.h"
#endif
