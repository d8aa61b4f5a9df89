#include "sph_solver/levels/level_stages.h"

#include "sph_solver/backend/stopwatch.h"

namespace tw {

void LevelStages::begin(bool freeze_diffusion) {
    const StepView view = steps_->step_view(system_.time);
    compression_.resize(view.device, view.n);
    start_.resize(view.device, view.n);
    mean_.zeros(view.device, view.n);
    if (freeze_diffusion) diffusion_.resize(view.device, view.n);
    loads_.assign(system_.bodies.size(), {});
}

void LevelStages::note_compression() {
    float* const compression = compression_.data();
    if (!compression) return;
    const StepView view = steps_->step_view(system_.time);
    view.each(view.n, NoteCompression{view.rate, compression});
}

void LevelStages::go_to(double since) {
    const Stopwatch watch(timers_.update);
    const StepView view = steps_->step_view(system_.time);
    view.each(view.n,
              GoToStage{view.p, view.kind, start_.data(), view.rate, since,
                        system_.stream_velocity(system_.time + since), system_.stream_velocity(system_.time),
                        system_.around.stream ? system_.around.stream->behind_share : 1, system_.inlet_has_wave()});
}

void LevelStages::add(double weight, bool first, bool freeze_diffusion) {
    const Stopwatch watch(timers_.update);
    const StepView view = steps_->step_view(system_.time);
    view.each(view.n, AddStage{view.p, view.rate, start_.data(), mean_.data(), compression_.data(),
                               freeze_diffusion ? diffusion_.data() : nullptr, weight, first});
    for (std::size_t b = 0; b < loads_.size(); ++b) loads_[b] += weight * system_.walls.loads()[b];
}

void LevelStages::end() {
    system_.walls.set_loads(loads_);
    const StepView view = steps_->step_view(system_.time);
    view.each(view.n, EndStages{view.p, view.rate, start_.data(), mean_.data()});
}

double LevelStages::bytes() const {
    return double(start_.bytes() + mean_.bytes() + compression_.bytes() + diffusion_.bytes());
}

}  // namespace tw
