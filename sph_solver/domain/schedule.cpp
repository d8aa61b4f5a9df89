#include "sph_solver/domain/schedule.h"

namespace tw {

Schedule::Evaluation Schedule::evaluation(double previous_dt) const {
    if (scheme_ == Scheme::kick_drift_kick) return {previous_dt / 2, previous_dt, previous_dt / 2};
    return {0, previous_dt, 0};
}

Schedule::Move Schedule::move(double previous_dt, double dt) const {
    if (scheme_ == Scheme::kick_drift_kick) return {(previous_dt + dt) / 2, previous_dt / 2, dt / 2};
    return {dt, 0, dt};
}

std::span<const Stage> Schedule::stages() const {
    static constexpr Stage midpoint[] = {{0, 0}, {1. / 2, 1}};
    static constexpr Stage classical[] = {{0, 1. / 6}, {1. / 2, 1. / 3}, {1. / 2, 1. / 3}, {1, 1. / 6}};
    if (scheme_ == Scheme::predictor_corrector) return midpoint;
    if (scheme_ == Scheme::rk4_frozen_diffusion) return classical;
    return {};
}

double Schedule::looks_ahead() const {
    switch (scheme_) {
        case Scheme::symplectic_euler: return 0;
        case Scheme::kick_drift_kick:
        case Scheme::predictor_corrector: return 0.5;
        case Scheme::rk4_frozen_diffusion: return 1;
    }
    return 1;
}

}  // namespace tw
