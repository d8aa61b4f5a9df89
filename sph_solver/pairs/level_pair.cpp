#include "sph_solver/pairs/level_pair.h"

#include "sph_solver/backend/for_particles.h"
#include "sph_solver/equations/level_pair.h"
#include "sph_solver/levels/level.h"
#include "sph_solver/pair_loops/level_pair_views.h"

namespace tw {

bool LevelPair::lists_outlived() const {
    return a_.level->travel_ahead() + b_.level->travel_ahead() >
           ListLife::wall_slack_over_dp * a_.level->system().setup.dp;  // both move
}

void LevelPair::find_neighbours() {
    const auto find = [](Side& own, const Side& other) {
        Level& level = *own.level;
        const double reach = level.system().kernel.support() + ListLife::wall_slack_over_dp * level.system().setup.dp;
        const Reaches reaches{reach, reach, reach};
        own.near = level.maker().find_neighbours(other.level->maker(), reaches, own.room);
        const StepView step = level.maker().step_view(level.system().time);
        own.sums.zeros(step.device, step.n);
    };
    find(a_, b_);
    find(b_, a_);
}

void LevelPair::meet(double t) {
    const StepView a = a_.level->maker().step_view(t), b = b_.level->maker().step_view(t);
    const auto sums_of = [](const StepView& own, const StepView& other, const Side& side) {
        own.pairs(MeetOtherData{.water = own.water,
                                .other = other.water,
                                .list = side.near.lists,
                                .inv_W_dp = side.level->system().inv_W_dp(),
                                .sums = side.sums.data()},
                  side.near.clusters);
    };
    sums_of(a, b, a_);
    sums_of(b, a, b_);
}

void LevelPair::press(double t) {
    const StepView a = a_.level->maker().step_view(t), b = b_.level->maker().step_view(t);
    const float of_a = a_.level->system().artificial_viscosity(), of_b = b_.level->system().artificial_viscosity();
    const auto press_on = [&](const StepView& own, const StepView& other, const Side& side) {
        own.pairs(PressOtherData{.water = own.water,
                                 .other = other.water,
                                 .list = side.near.lists,
                                 .shift = own.shift,
                                 .rate = own.rate,
                                 .viscosity = harmonic_mean(of_a, of_b),
                                 .tension_control_from = side.level->system().tension_control_from()},
                  side.near.clusters);
    };
    press_on(a, b, a_);
    press_on(b, a, b_);
}

const OtherSums* LevelPair::sums_for(const Level& level) const {
    return &level == a_.level ? a_.sums.data() : &level == b_.level ? b_.sums.data() : nullptr;
}

std::size_t LevelPair::bytes() const {
    const auto of = [](const Side& s) {
        return s.room.lists.bytes() + s.room.clusters.capacity() * sizeof(Cluster) + s.sums.bytes();
    };
    return of(a_) + of(b_);
}

}  // namespace tw
