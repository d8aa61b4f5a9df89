#include "meshes/distance_grid.h"

#include <algorithm>
#include <cmath>

#include "base/numbers.h"
#include "meshes/query.h"

namespace tw {

DistanceGrid::DistanceGrid(const Surface& closed, const Box& box, double spacing, double reach) : box_(box) {
    for (int a = 0; a < 3; ++a) {
        const int cells = std::max(1, static_cast<int>(std::ceil(box.size()[a] / spacing - 1e-9)));
        count_[static_cast<std::size_t>(a)] = cells + 1;
        spacing_[a] = box.size()[a] / cells;
    }
    std::vector<Vec3> places(node(0, 0, count_[2]));
    for (std::size_t n = 0; n < places.size(); ++n) places[n] = place(n);
    std::vector<double> distance(places.size());
    SurfaceQuery(closed).signed_distances(places, distance, reach);
    distance_.assign(distance.begin(), distance.end());
}

Vec3 DistanceGrid::place(std::size_t n) const {
    const std::size_t row = node(0, 1, 0), layer = node(0, 0, 1);
    return box_.min + Vec3(double(n % row), double(n % layer / row), double(n / layer)).cwiseProduct(spacing_);
}

double DistanceGrid::at(const Vec3& x) const {
    std::array<int, 3> cell;
    Vec3 part;
    for (int a = 0; a < 3; ++a) {
        const int cells = count_[static_cast<std::size_t>(a)] - 1;
        const double nodes = std::clamp((x[a] - box_.min[a]) / spacing_[a], 0.0, double(cells));
        const int before = std::min(static_cast<int>(nodes), cells - 1);
        cell[static_cast<std::size_t>(a)] = before;
        part[a] = nodes - before;
    }
    const auto along_x = [&](int j, int k) {
        return std::lerp(double(distance_[node(cell[0], cell[1] + j, cell[2] + k)]),
                         double(distance_[node(cell[0] + 1, cell[1] + j, cell[2] + k)]), part.x());
    };
    return std::lerp(std::lerp(along_x(0, 0), along_x(1, 0), part.y()),
                     std::lerp(along_x(0, 1), along_x(1, 1), part.y()), part.z());
}

void DistanceGrid::draw_out(int axis, bool towards_high) {
    const auto n = static_cast<std::size_t>(count_[static_cast<std::size_t>(axis)]);
    const std::size_t stride = axis == 0 ? 1 : axis == 1 ? node(0, 1, 0) : node(0, 0, 1);
    for (std::size_t m = 0; m < distance_.size(); ++m) {
        const std::size_t here = towards_high ? m : distance_.size() - 1 - m, layer = here / stride % n;
        if (layer == (towards_high ? 0 : n - 1)) continue;
        distance_[here] = std::min(distance_[here], distance_[towards_high ? here - stride : here + stride]);
    }
}

Box DistanceGrid::nearer_than(double distance, const Box& part) const {
    Box bounds{Vec3::Constant(infinite), Vec3::Constant(-infinite)};
    for (std::size_t n = 0; n < distance_.size(); ++n) {
        const Vec3 x = place(n);
        if (double(distance_[n]) >= distance || !part.contains(x)) continue;
        bounds.min = bounds.min.cwiseMin(x - spacing_);
        bounds.max = bounds.max.cwiseMax(x + spacing_);
    }
    if (bounds.min.x() > bounds.max.x()) return {};
    bounds = {bounds.min.cwiseMax(part.min), bounds.max.cwiseMin(part.max)};
    for (int a = 0; a < 3; ++a) {
        if (std::isinf(part.min[a])) bounds.min[a] = -infinite;
        if (std::isinf(part.max[a])) bounds.max[a] = infinite;
    }
    return bounds;
}

}  // namespace tw
