#include "sph_solver/levels/level.h"
#include "sph_solver/loops/force_on_dummies.h"

namespace tw {

std::vector<Vec3> Level::forces_on_dummies(std::size_t body) {
    if (walls_.empty()) return {};
    const StepView step = step_view(time_);
    const StepView::DummiesOfBody& dummies = step.bodies[body];
    const auto lanes = static_cast<std::size_t>(passes_.lanes);
    V3<double>* const force =
        forces_on_dummies_.zeros(step.device, static_cast<std::size_t>(walls_.body_end()[body]) - dummies.first);
    step.each(lanes * dummies.groups.size(), ForceOnDummies{.water = step.water,
                                                            .walls = step.dummies,
                                                            .quantum = quanta_.size,
                                                            .own = step.n,
                                                            .first = dummies.first,
                                                            .lists = dummies.water,
                                                            .groups = dummies.groups.data(),
                                                            .lanes = lanes,
                                                            .force = force});
    // each by the rank whose column it stands in, nothing on the others
    std::vector<double> sums;
    for (const V3<double>& f : forces_on_dummies_.bring_home()) sums.insert(sums.end(), {f.x, f.y, f.z});
    ranks().take_from_owners(std::span(sums));
    std::vector<Vec3> forces;
    for (std::size_t k = 0; k < sums.size(); k += 3) forces.emplace_back(sums[k], sums[k + 1], sums[k + 2]);
    return forces;
}

}  // namespace tw
