#pragma once
// All that a device does for effects: bodies of loops, views of pair loops and, for kernels, the pair loops. A line for
// each file.
#include "sph_solver/effects/acoustic_damping_loops.h"
#include "sph_solver/effects/cavitation_loops.h"
#include "sph_solver/effects/dynamic_pressure_loops.h"
#include "sph_solver/effects/forcing_zones_loops.h"
#include "sph_solver/effects/kernel_list.h"
#include "sph_solver/effects/moving_tank_loops.h"
#include "sph_solver/effects/surface_tension.h"
#include "sph_solver/effects/surface_tension_loops.h"
#include "sph_solver/effects/ventilation.h"
#include "sph_solver/effects/ventilation_loops.h"
#include "sph_solver/effects/viscosity.h"
#include "sph_solver/effects/viscosity_loops.h"
#ifdef TW_THREADS
#include "sph_solver/effects/surface_tension_isa.cpp"
#include "sph_solver/effects/ventilation_isa.cpp"
#include "sph_solver/effects/viscosity_isa.cpp"
#endif
