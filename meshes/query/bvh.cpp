#include "meshes/query/bvh.h"

#include <algorithm>
#include <array>
#include <cmath>
#include <numeric>

#include "base/numbers.h"

namespace tw {
namespace {
constexpr std::uint32_t leaf_size = 4;

Box nothing() { return {Vec3::Constant(infinite), Vec3::Constant(-infinite)}; }
void include(Box& box, const Box& other) {
    box.min = box.min.cwiseMin(other.min);
    box.max = box.max.cwiseMax(other.max);
}
double half_area(const Box& box) {
    const Vec3 s = box.size();
    return s.x() * s.y() + s.y() * s.z() + s.z() * s.x();
}

/// Where to split: the best of 16 bins along the widest axis of the centres by the surface area heuristic. Returns the
/// first index of the right part; half-way when the bins do not separate the triangles.
std::uint32_t split(std::vector<std::uint32_t>& order, const std::vector<Box>& boxes, std::uint32_t begin,
                    std::uint32_t end) {
    Box centres = nothing();
    const auto centre = [&](std::uint32_t i) { return Vec3(0.5 * (boxes[i].min + boxes[i].max)); };
    for (std::uint32_t i = begin; i < end; ++i) {
        const Vec3 c = centre(order[i]);
        include(centres, {c, c});
    }
    Eigen::Index axis = 0;
    const double width = centres.size().maxCoeff(&axis);
    const auto middle = begin + (end - begin) / 2;
    const auto at = [&](std::uint32_t i) { return order.begin() + i; };
    if (width > 0) {
        constexpr int bins = 16;
        const auto bin = [&](std::uint32_t i) {
            return std::min(bins - 1, static_cast<int>(bins * (centre(i)[axis] - centres.min[axis]) / width));
        };
        std::array<Box, bins> box;
        box.fill(nothing());
        std::array<int, bins> count{};
        for (std::uint32_t i = begin; i < end; ++i) {
            const auto b = static_cast<std::size_t>(bin(order[i]));
            include(box[b], boxes[order[i]]);
            ++count[b];
        }
        std::array<double, bins> right_cost{};
        Box sum = nothing();
        int n = 0;
        for (std::size_t b = bins - 1; b > 0; --b) {
            include(sum, box[b]);
            n += count[b];
            right_cost[b] = n > 0 ? n * half_area(sum) : 0;
        }
        sum = nothing();
        n = 0;
        double best = infinite;
        int best_bin = 0;
        for (std::size_t b = 0; b + 1 < bins; ++b) {
            include(sum, box[b]);
            n += count[b];
            const double cost = (n > 0 ? n * half_area(sum) : 0) + right_cost[b + 1];
            if (cost < best) {
                best = cost;
                best_bin = static_cast<int>(b);
            }
        }
        const auto cut = std::partition(at(begin), at(end), [&](std::uint32_t i) { return bin(i) <= best_bin; });
        const auto result = static_cast<std::uint32_t>(cut - order.begin());
        // A lopsided cut would deepen the tree beyond the traversal's fixed stack.
        const auto least = std::max(1u, (end - begin) / 8);
        if (result >= begin + least && result + least <= end) return result;
    }
    std::nth_element(at(begin), at(middle), at(end),
                     [&](std::uint32_t i, std::uint32_t j) { return centre(i)[axis] < centre(j)[axis]; });
    return middle;
}
}  // namespace

Bvh::Bvh(const Surface& surface) {
    const auto n = static_cast<std::uint32_t>(surface.triangles.size());
    if (n == 0) return;
    std::vector<Box> boxes(n);
    for (std::uint32_t t = 0; t < n; ++t) {
        boxes[t] = nothing();
        for (int k = 0; k < 3; ++k) {
            const Vec3 p = surface.corner(static_cast<int>(t), k);
            include(boxes[t], {p, p});
        }
    }
    std::vector<std::uint32_t> order(n);
    std::iota(order.begin(), order.end(), 0u);

    struct Task {
        std::uint32_t node, begin, end;
    };
    std::vector<Task> tasks{{0, 0, n}};
    nodes_.reserve(n);
    nodes_.emplace_back();
    while (!tasks.empty()) {
        const Task task = tasks.back();
        tasks.pop_back();
        Box box = nothing();
        for (std::uint32_t i = task.begin; i < task.end; ++i) include(box, boxes[order[i]]);
        if (task.end - task.begin <= leaf_size) {
            nodes_[task.node] = {box, task.begin, task.end - task.begin};
            continue;
        }
        const std::uint32_t middle = split(order, boxes, task.begin, task.end);
        const auto child = static_cast<std::uint32_t>(nodes_.size());
        nodes_[task.node] = {box, child, 0};
        nodes_.emplace_back();
        nodes_.emplace_back();
        tasks.push_back({child, task.begin, middle});
        tasks.push_back({child + 1, middle, task.end});
    }
    leaves_.reserve(n);
    for (const std::uint32_t t : order) {
        const int i = static_cast<int>(t);
        leaves_.push_back({surface.corner(i, 0), surface.corner(i, 1), surface.corner(i, 2), i});
    }
}

bool Bvh::meets(const Box& box, const Vec3& origin, const Vec3& inverse, double length) {
    double enter = 0, leave = length;
    for (int k = 0; k < 3; ++k) {
        if (std::isinf(inverse[k])) {  // 0 * infinity would be NaN
            if (origin[k] < box.min[k] || origin[k] > box.max[k]) return false;
            continue;
        }
        const double t0 = (box.min[k] - origin[k]) * inverse[k], t1 = (box.max[k] - origin[k]) * inverse[k];
        enter = std::max(enter, std::min(t0, t1));
        leave = std::min(leave, std::max(t0, t1));
    }
    return enter <= leave * (1 + 1e-12);
}

}  // namespace tw
