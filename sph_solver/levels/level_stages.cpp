// The stages of explicit Runge-Kutta schemes.
#include "sph_solver/backend/stopwatch.h"
#include "sph_solver/levels/level.h"

namespace tw {

void Level::begin_stages(bool freeze_diffusion) {
    const StepView view = steps_->step_view(system_.time);
    stages_.compression.resize(view.device, view.n);
    stages_.start.resize(view.device, view.n);
    stages_.mean.zeros(view.device, view.n);
    if (freeze_diffusion) stages_.diffusion.resize(view.device, view.n);
    stages_.loads.assign(system_.bodies.size(), {});
}

void Level::note_compression() {
    float* const compression = stages_.compression.data();
    if (!compression) return;
    const StepView view = steps_->step_view(system_.time);
    view.each(view.n, NoteCompression{view.rate, compression});
}

void Level::go_to_stage(double since) {
    const Stopwatch watch(timers_.update);
    const StepView view = steps_->step_view(system_.time);
    view.each(view.n, GoToStage{view.p, view.kind, stages_.start.data(), view.rate, since,
                                system_.stream_velocity(system_.time + since), system_.stream_velocity(system_.time),
                                system_.around.stream ? system_.around.stream->behind_share : 1});
}

void Level::add_stage(double weight, bool first, bool freeze_diffusion) {
    const Stopwatch watch(timers_.update);
    const StepView view = steps_->step_view(system_.time);
    view.each(view.n, AddStage{view.p, view.rate, stages_.start.data(), stages_.mean.data(), stages_.compression.data(),
                               freeze_diffusion ? stages_.diffusion.data() : nullptr, weight, first});
    for (std::size_t b = 0; b < stages_.loads.size(); ++b) stages_.loads[b] += weight * system_.walls.loads()[b];
}

void Level::end_stages() {
    system_.walls.set_loads(stages_.loads);
    const StepView view = steps_->step_view(system_.time);
    view.each(view.n, EndStages{view.p, view.rate, stages_.start.data(), stages_.mean.data()});
}

}  // namespace tw
