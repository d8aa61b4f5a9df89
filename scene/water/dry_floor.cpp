#include "scene/water/dry_floor.h"

#include <algorithm>
#include <set>
#include <vector>

#include "scene/water/running_water.h"
#include "scene/water/water_blocks.h"

namespace tw {

double dry_floor(const Scene& scene) {
    const Box& tank = scene.domain.box;
    std::vector<Box> standing = blocks_of_water(scene);
    std::erase_if(standing, [&](const Box& b) { return b.min.z() > tank.min.z() + 0.5 * scene.resolution.near_hull; });
    // The blocks' edges cut the floor into rectangles, each of which is wholly under a block or under none.
    std::set<double> xs{tank.min.x(), tank.max.x()}, ys{tank.min.y(), tank.max.y()};
    for (const Box& b : standing)
        for (const Vec3& p : {b.min, b.max}) {
            xs.insert(std::clamp(p.x(), tank.min.x(), tank.max.x()));
            ys.insert(std::clamp(p.y(), tank.min.y(), tank.max.y()));
        }
    double dry = 0;
    for (auto x = xs.begin(); std::next(x) != xs.end(); ++x)
        for (auto y = ys.begin(); std::next(y) != ys.end(); ++y) {
            const double cx = (*x + *std::next(x)) / 2, cy = (*y + *std::next(y)) / 2;
            if (std::ranges::none_of(standing, [&](const Box& b) {
                    return b.min.x() <= cx && cx <= b.max.x() && b.min.y() <= cy && cy <= b.max.y();
                }))
                dry += (*std::next(x) - *x) * (*std::next(y) - *y);
        }
    const double floor = tank.size().x() * tank.size().y();
    return floor > 0 ? dry / floor : 0;
}

double released_height(const Scene& scene) { return running_water(scene) ? water_height(scene) : 0; }

}  // namespace tw
