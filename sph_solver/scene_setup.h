#pragma once
#include <optional>

#include "scene/scene.h"
#include "sph_solver/air.h"
#include "sph_solver/levels/control_volume.h"
#include "sph_solver/parallel/comm.h"
#include "sph_solver/simulation.h"

namespace tw {

/// The scene as the engine needs it.
struct SphSetup {
    SimulationSetup simulation;
    std::vector<Fluid> fluid;     ///< of each level of particle size, coarsest first
    int pressure_iterations = 0;  ///< that found the pressure of water let go; 0: it begins under hydrostatic pressure
    struct Gas {
        AirOptions options;
        Fluid fluid;
    };
    std::optional<Gas> air;                       ///< when the effect is on
    std::optional<ControlVolume> control_volume;  ///< round the hull, clear of it and inside the water's sides
};

/// Of several ranks, which all call it, the first one has the particles. Throws InputError where no water particle fits
/// into the domain.
SphSetup sph_setup(const Scene& scene, int threads, const Comm& ranks = Comm::alone());

}  // namespace tw
