#include "sph_solver/pairs/level_pair.h"

#include "sph_solver/backend/for_particles.h"
#include "sph_solver/equations/level_pair.h"
#include "sph_solver/levels/level.h"
#include "sph_solver/pairs/level_pair_views.h"

namespace tw {

bool LevelPair::lists_outlived() const {
    return a_.level->travel_ahead() + b_.level->travel_ahead() >
           ListLife::wall_skin_over_dp * a_.level->setup().dp;  // both move
}

void LevelPair::find_neighbours() {
    const auto find = [&](Side& own, const Side& other) {
        const Level& level = *own.level;
        const double reach = level.kernel().support() + ListLife::wall_skin_over_dp * level.setup().dp;
        own.groups = level.groups();
        own.lists.build(level.passes(), level.quanta(), level.sources().front(), own.groups, other.level->sources(),
                        {reach, reach, reach});
        std::erase_if(own.groups, [](const Group& g) { return g.list.size == 0; });
        own.sums.assign(level.particles().size(), {});
    };
    find(a_, b_);
    find(b_, a_);
}

void LevelPair::meet() {
    const FirstSweepData a = a_.level->first_sweep_data(), b = b_.level->first_sweep_data();
    const auto sums_of = [&](const FirstSweepData& own, const FirstSweepData& other, Side& side) {
        const MeetOtherData d{.water = own.water,
                              .other = other.water,
                              .list = side.lists.view(),
                              .inv_W_dp = own.inv_W_dp,
                              .sums = side.sums.data()};
        for_pairs(a_.level->passes(), d, side.groups);
    };
    sums_of(a, b, a_);
    sums_of(b, a, b_);
}

void LevelPair::press(double t) {
    const SecondSweepData a = a_.level->second_sweep_data(t), b = b_.level->second_sweep_data(t);
    const auto press_on = [&](const SecondSweepData& own, const SecondSweepData& other, const Side& side) {
        const PressOtherData d{.water = own.water,
                               .other = other.water,
                               .list = side.lists.view(),
                               .shift = own.shift,
                               .rate = own.rate,
                               .viscosity = harmonic_mean(own.viscosity, other.viscosity),
                               .tension_control_from = own.tension_control_from};
        for_pairs(a_.level->passes(), d, side.groups);
    };
    press_on(a, b, a_);
    press_on(b, a, b_);
}

const OtherSums* LevelPair::sums_for(const Level& level) const {
    return &level == a_.level ? a_.sums.data() : &level == b_.level ? b_.sums.data() : nullptr;
}

std::size_t LevelPair::bytes() const {
    const auto of = [](const Side& s) {
        return s.lists.bytes() + s.groups.capacity() * sizeof(Group) + s.sums.capacity() * sizeof(OtherSums);
    };
    return of(a_) + of(b_);
}

}  // namespace tw
