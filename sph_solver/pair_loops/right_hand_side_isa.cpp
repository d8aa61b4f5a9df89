// The sums of the right-hand side, the wall pressure and the neighbour search, compiled once per variant of a processor
// and, by cuda/kernels.cpp, for a GPU.
#include "sph_solver/pair_loops/extrapolate.h"
#include "sph_solver/pair_loops/right_hand_side.h"
#ifdef TW_THREADS
#include "sph_solver/pair_loops/search_in_threads.h"
#else
#include "sph_solver/pair_loops/search.h"
#endif
