#include "meshes/zone.h"

#include <algorithm>
#include <limits>

namespace tw {

namespace {

/// Signed distance from a box.
double outside_of(const Box& box, const Vec3& x) {
    const Vec3 beyond = (box.min - x).cwiseMax(x - box.max);
    const double deepest = beyond.maxCoeff();
    return deepest <= 0 ? deepest : beyond.cwiseMax(0.0).norm();
}

}  // namespace

double Zone::outside(const Vec3& x) const {
    double nearest = std::numeric_limits<double>::infinity();
    for (std::size_t b = 0; b < boxes_.size(); ++b) {
        double distance = outside_of(boxes_[b], x);
        if (b == 0 && surface_) distance = std::max(distance, surface_->at(back_ * x) - width_);
        nearest = std::min(nearest, distance);
    }
    return nearest;
}

std::vector<Box> Zone::sliced() const {
    constexpr int slices = 16;
    if (!surface_) return boxes_;
    std::vector<Box> cut;
    const Box& all = surface_->box();
    for (int s = 0; s < slices; ++s) {
        Box slice = boxes_.front();
        if (s > 0) slice.min.x() = all.min.x() + s * all.size().x() / slices;
        if (s + 1 < slices) slice.max.x() = all.min.x() + (s + 1) * all.size().x() / slices;
        if (const Box held = surface_->nearer_than(width_, slice); held.size().minCoeff() > 0) cut.push_back(held);
    }
    cut.insert(cut.end(), boxes_.begin() + 1, boxes_.end());
    return cut;
}

}  // namespace tw
