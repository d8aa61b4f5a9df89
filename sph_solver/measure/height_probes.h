#pragma once
#include "meshes/query/solid_column.h"
#include "record/run_record.h"
#include "scene/scene.h"
#include "sph_solver/bodies/samples.h"
#include "sph_solver/simulation.h"

namespace tw {

/// The height probes of a scene, read from the particles as record/gauge_level.h defines their elevation. The share of
/// water at a place is the Shepard sum of the water there over what solids leave of the kernel:
///
///   water = S (1 + p / (rho0 c0^2)) / (1 - S_wall(d))
///
/// d: distance from the nearest solid, S_wall: support of a half space (equations/half_space.h). S is the share of the
/// volume that the particles have at their density; the factor makes of it that of incompressible water: without it the
/// floor's pressure would lower the surface by rho0 g H^2 / (2 rho0 c0^2), 0.25 % of the depth. Walls of the tank need
/// none of that: the water's mirror images count in S.
class HeightProbes {
public:
    /// `scene` must outlive it.
    HeightProbes(const Scene& scene, const SimulationSetup& setup);
    /// Adds a row of the present time to the record's table of heights, where the scene has such probes.
    void record(Simulation& simulation, RunRecord& record);

private:
    std::vector<Stretch> solids_at(const Simulation& simulation, const HeightProbe& probe) const;

    const Scene& scene_;
    Stretch line_;
    double step_ = 0;       ///< [m]
    double stiffness_ = 0;  ///< rho0 c0^2 [Pa]; infinite where the weight of water at rest is no pressure of particles
    std::size_t per_probe_ = 0;
    PointSamples points_;
};

}  // namespace tw
