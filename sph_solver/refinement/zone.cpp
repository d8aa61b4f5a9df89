#include "sph_solver/refinement/zone.h"

#include <algorithm>
#include <limits>

namespace tw {

double Zone::outside(const Vec3& x) const {
    double nearest = std::numeric_limits<double>::infinity();
    for (const Box& box : boxes_) {
        const Vec3 beyond = (box.min - x).cwiseMax(x - box.max);
        const double deepest = beyond.maxCoeff();
        nearest = std::min(nearest, deepest <= 0 ? deepest : beyond.cwiseMax(0.0).norm());
    }
    return nearest;
}

}  // namespace tw
