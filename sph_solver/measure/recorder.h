#pragma once
#include <optional>

#include "record/run_record.h"
#include "scene/scene.h"
#include "sph_solver/bodies/samples.h"
#include "sph_solver/measure/height_probes.h"
#include "sph_solver/measure/level_ledger.h"
#include "sph_solver/measure/spray_gate.h"
#include "sph_solver/measure/tank_balance.h"
#include "sph_solver/measure/zone_mass.h"
#include "sph_solver/simulation.h"

namespace tw {

/// Turns the running simulation into the run record: forces and the motions of bodies at every step, surface pressure
/// every few steps, pressure probes every half millisecond or at every longer step, and at every frame the raster, the
/// control volume's balance, all probes and the ledgers. Half-model loads become the whole hull's here, once.
class Recorder {
public:
    Recorder(const Scene& scene, const Simulation& simulation, RunRecord record);

    /// After each step. `frame`: also everything that is sampled at frame times.
    void after_step(Simulation& simulation, bool frame);
    /// Lets the gate take detached water out of the run after a frame, and writes it into the table "spray".
    void take_spray(Simulation& simulation, const SprayGate& gate);
    /// After a restart: drops what the record holds beyond the simulation's time.
    void rewind(Simulation& simulation);
    RunRecord& record() { return record_; }
    void fill_hull_pressure(Simulation& simulation);

private:
    void sample_hull(Simulation& simulation);
    void sample_surface(Simulation& simulation, std::size_t row);
    void sample_frame(Simulation& simulation, std::size_t row);
    void begin_balance(Simulation& simulation);
    void record_levels(double time);
    void record_bodies(const Simulation& simulation);
    void record_walls(Simulation& simulation, std::size_t row);
    void probe_pressure(Simulation& simulation);
    Table& forces() { return record_.table("forces"); }
    std::string per_span(const char* unit) const { return scene_.spanwise_unit(unit); }

    const Scene& scene_;
    RunRecord record_;
    int factor_ = 1;
    std::optional<SurfaceSamples> hull_at_start_, hull_;  ///< the second where the hull is now
    /// The other solids that keep their shape.
    struct SampledSolid {
        std::size_t body;
        SurfaceSamples at_start;
    };
    std::vector<SampledSolid> solids_;
    PointSamples pressure_points_;
    HeightProbes height_probes_;
    Vec3 momentum_ = Vec3::Zero();  ///< in the control volume at the last frame
    bool momentum_known_ = false;
    bool volume_held_ = true;  ///< since then, by particles of its size
    double last_face_sample_ = 0;
    std::vector<LevelLedger> sizes_;  ///< after the last step; empty: the particles have one size
    ZoneMass zone_mass_;
    std::optional<TankBalance> tank_;  ///< of one that moves
};

}  // namespace tw
