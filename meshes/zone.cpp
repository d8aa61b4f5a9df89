#include "meshes/zone.h"

#include <algorithm>
#include <cmath>
#include <limits>

namespace tw {

namespace {

Vec3 middle_of(const Box& box) { return (box.min + box.max) / 2; }

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

std::optional<Zone::Shift> Zone::shift_since(const Zone& before) const {
    if (boxes_.size() != before.boxes_.size() || surface_ != before.surface_ || width_ != before.width_) return {};
    const auto face = [](double now, double then) { return now == then ? 0.0 : std::abs(now - then); };
    Shift shift;
    for (std::size_t b = 0; b < boxes_.size(); ++b) {
        Vec3 most;
        for (int a = 0; a < 3; ++a)
            most[a] = std::max(face(boxes_[b].min[a], before.boxes_[b].min[a]),
                               face(boxes_[b].max[a], before.boxes_[b].max[a]));
        shift.by = std::max(shift.by, most.norm());
    }
    if (std::isinf(shift.by)) return {};
    if (!surface_) return shift;
    // A place y beside the surface at the start is now beside y' = R y + t = y + (R c + t - c) + (R - 1)(y - c), and
    // |(R - 1) v| is no more than the angle of R times |v|.
    const Eigen::Isometry3d step = back_ * before.back_.inverse();
    const Vec3 middle = middle_of(surface_->box());
    shift.by = std::max(shift.by, steepest * (step * middle - middle).norm());
    shift.turn = steepest * Eigen::AngleAxisd(step.linear()).angle();
    return shift;
}

Vec3 Zone::pivot() const { return surface_ ? back_.inverse() * middle_of(surface_->box()) : Vec3::Zero(); }

double Zone::pivot_radius() const { return surface_ ? surface_->box().size().norm() / 2 : 0; }

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
