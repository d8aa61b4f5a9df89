#pragma once
#include <optional>

#include "record/run_record.h"
#include "scene/scene.h"
#include "sph_solver/bodies/samples.h"
#include "sph_solver/solver.h"

namespace tw {

/// Turns the running solver into the run record: forces at every step, surface pressure every few steps, and at every
/// frame the raster, the control volume's balance, probes and the ledger. Half-model loads become the whole hull's
/// here, once.
class Recorder {
public:
    Recorder(const Scene& scene, const Solver& solver, RunRecord record);

    /// After each step. `frame`: also everything that is sampled at frame times.
    void after_step(Solver& solver, bool frame);
    /// After a restart: drops what the record holds beyond the solver's time.
    void rewind(Solver& solver);
    RunRecord& record() { return record_; }
    void fill_hull_pressure(Solver& solver);

private:
    void sample_surface(Solver& solver, std::size_t row);
    void sample_frame(Solver& solver, std::size_t row);
    void probe(Solver& solver);
    Table& forces() { return record_.table("forces"); }

    const Scene& scene_;
    RunRecord record_;
    int factor_ = 1;
    std::optional<SurfaceSamples> hull_;
    PointSamples pressure_points_, height_points_;
    int heights_per_gauge_ = 0;
    double height_step_ = 0;
    Vec3 momentum_ = Vec3::Zero();  ///< in the control volume at the last frame
    bool momentum_known_ = false;
    double last_face_sample_ = 0;
};

}  // namespace tw
