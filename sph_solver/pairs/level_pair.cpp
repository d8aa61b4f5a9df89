#include "sph_solver/pairs/level_pair.h"

#include "sph_solver/backend/for_particles.h"
#include "sph_solver/effects/passes.h"
#include "sph_solver/levels/level.h"

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

void LevelPair::meet(double t) {
    const PassData a = a_.level->pass_data(t), b = b_.level->pass_data(t);
    const Passes& passes = a_.level->passes();
    for_pairs(passes.meet_other_phase, LevelPairData{a_.lists.view(), &a, &b, a_.sums.data()}, a_.groups);
    for_pairs(passes.meet_other_phase, LevelPairData{b_.lists.view(), &b, &a, b_.sums.data()}, b_.groups);
}

void LevelPair::press(double t) {
    const PassData a = a_.level->pass_data(t), b = b_.level->pass_data(t);
    const Passes& passes = a_.level->passes();
    for_pairs(passes.press_other_phase, LevelPairData{a_.lists.view(), &a, &b, nullptr}, a_.groups);
    for_pairs(passes.press_other_phase, LevelPairData{b_.lists.view(), &b, &a, nullptr}, b_.groups);
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
