#include "sph_solver/ghosts/ghosts.h"

namespace tw {

Ghosts::Ghosts(const Surroundings& around, const LevelSetup& level, const FixedPoint& fixed_point)
    : around_(around),
      fixed_point_(fixed_point),
      still_{level.rho0, level.state_equation.c0},
      maps_(around.mirrors, around.domain, fixed_point) {}

void Ghosts::find(const Particles& p, const PencilGrid& grid, double reach) {
    const std::vector<Link> found = find_images(around_.mirrors, around_.domain, p, reach);
    std::vector<WidePlace> places(found.size());
    for (std::size_t k = 0; k < found.size(); ++k) {
        const auto i = static_cast<std::size_t>(found[k].index);
        places[k] = maps_[found[k]].place(fixed_point_.wide({p.x[i], p.y[i], p.z[i]}));
    }
    std::vector<std::int32_t> order;
    sort_by_pencil(grid, places, order, start_);
    links_.resize(found.size());
    for (std::size_t k = 0; k < found.size(); ++k) links_[k] = found[static_cast<std::size_t>(order[k])];
}

}  // namespace tw
