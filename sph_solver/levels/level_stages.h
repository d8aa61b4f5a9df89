#pragma once
#include <memory>
#include <vector>

#include "sph_solver/backend/device_loops.h"
#include "sph_solver/bodies/load.h"
#include "sph_solver/levels/particle_system.h"
#include "sph_solver/levels/step_maker.h"
#include "sph_solver/levels/timers.h"
#include "sph_solver/loops/stages.h"

namespace tw {

/// A level's steps in stages (explicit Runge-Kutta) instead of one evaluation: each stage starts from the step's begin
/// with the rates of the stage before. Of other steps it holds nothing.
class LevelStages {
public:
    /// All must outlive this; another maker may take the place of the one that `steps` owns.
    LevelStages(ParticleSystem& system, const std::unique_ptr<StepMaker>& steps, Timers& timers)
        : system_(system), steps_(steps), timers_(timers) {}

    /// `freeze_diffusion`: that of the first stage is the one of all.
    void begin(bool freeze_diffusion);
    void go_to(double since);  ///< the step's begin [s]
    /// The rates and loads of the evaluation there count so much.
    void add(double weight, bool first, bool freeze_diffusion);
    /// Back to the step's begin, with the mean rates and loads of all stages.
    void end();

    void note_compression();                                ///< of a stage, in its evaluation
    const StageMean* mean() const { return mean_.data(); }  ///< by the step's end; null: not in stages
    double bytes() const;

private:
    ParticleSystem& system_;
    const std::unique_ptr<StepMaker>& steps_;
    Timers& timers_;
    LoopArray<StageStart> start_;
    LoopArray<StageMean> mean_;
    LoopArray<float> compression_, diffusion_;  ///< see AddStage
    std::vector<Load> loads_;                   ///< mean
};

}  // namespace tw
