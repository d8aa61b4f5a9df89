// The engine's own sweeps, once per variant.
#include "sph_solver/sweeps/extrapolate.h"
#include "sph_solver/sweeps/first_sweep.h"
#include "sph_solver/sweeps/search.h"
#include "sph_solver/sweeps/second_sweep.h"
