#include "motion/wall_contact.h"

#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace tw {
namespace {

/// A corner at a wall.
struct Corner {
    Vec3 arm, normal;
    double gap;
    Vec3 impulse = Vec3::Zero();
    double normal_response = 0, tangent_response = 0;  ///< most velocity by impulse, across and along the wall [1/kg]
};

/// Of many corners at one wall those that are extreme in some directions along it, the nearest first: they carry a flat
/// face as all of them would.
std::vector<Corner> thinned(std::vector<Corner> at_wall) {
    constexpr int directions = 32;
    constexpr double tilt = 1e-3;
    if (at_wall.size() <= directions) return at_wall;
    const Vec3 n = at_wall.front().normal, t1 = n.unitOrthogonal(), t2 = n.cross(t1);
    std::vector<std::size_t> kept;
    for (int d = 0; d < directions; ++d) {
        const double angle = 2 * std::numbers::pi * d / directions;
        const Vec3 along = std::cos(angle) * t1 + std::sin(angle) * t2;
        const auto reach = [&](const Corner& c) { return tilt * along.dot(c.arm) - c.gap; };
        const auto farthest = std::ranges::max_element(at_wall, {}, reach);
        kept.push_back(static_cast<std::size_t>(farthest - at_wall.begin()));
    }
    std::ranges::sort(kept);
    kept.erase(std::ranges::unique(kept).begin(), kept.end());
    std::vector<Corner> few;
    for (const std::size_t k : kept) few.push_back(at_wall[k]);
    return few;
}

}  // namespace

WallContact::WallContact(std::vector<Vec3> corners, std::vector<WallPlane> walls, double friction)
    : corners_(std::move(corners)), walls_(std::move(walls)), friction_(friction), cleared_(walls_.size()) {
    std::ranges::sort(corners_, [](const Vec3& a, const Vec3& b) {
        return std::lexicographical_compare(a.data(), a.data() + 3, b.data(), b.data() + 3);
    });
    corners_.erase(std::unique(corners_.begin(), corners_.end()), corners_.end());
    for (const Vec3& x : corners_) middle_ += x / static_cast<double>(corners_.size());
    for (const Vec3& x : corners_) reach_ = std::max(reach_, (x - middle_).norm());
}

bool WallContact::at(const Vec3& normal) const {
    return std::ranges::any_of(walls_, [&](const WallPlane& wall) { return wall.normal == normal; });
}

double WallContact::gap_to(const WallPlane& wall, const RigidBody& body) const {
    double least = std::numeric_limits<double>::infinity();
    for (const Vec3& x : corners_) least = std::min(least, wall.normal.dot(body.now(x)) - wall.offset);
    return least;
}

double WallContact::gap(const RigidBody& body) const {
    double least = std::numeric_limits<double>::infinity();
    for (const WallPlane& wall : walls_) least = std::min(least, gap_to(wall, body));
    return least;
}

void WallContact::note_clear(const RigidBody& body) {
    if (room_ == 0) return;
    for (std::size_t w = 0; w < walls_.size(); ++w)
        if (!cleared_[w]) cleared_[w] = gap_to(walls_[w], body) >= room_;
}

WallReaction WallContact::resist(RigidBody& body, double ahead) {
    constexpr double let_out = 0.1;  // of what has sunk in, in a step
    constexpr int most_rounds = 1000;
    constexpr double settled = 1e-9;  // change of a velocity in a round, over the largest there is
    if (body.prescribed() || body.held()) return {};
    note_clear(body);
    const Vec3 spin = body.spin();
    const double fastest = body.state().velocity.norm() + spin.norm() * 2 * reach_;
    std::vector<Corner> corners;
    for (std::size_t w = 0; w < walls_.size(); ++w) {
        const WallPlane& wall = walls_[w];
        const double within = 2 * fastest * ahead;  // what meets the wall at one corner turns to another
        const double stop = wall.offset + (cleared_[w] ? room_ : 0);
        if (wall.normal.dot(body.now(middle_)) - stop > reach_ + within) continue;
        std::vector<Corner> at_wall;
        for (const Vec3& x : corners_) {
            const Vec3 place = body.now(x), arm = place - body.state().centre;
            const double gap = wall.normal.dot(place) - stop;
            if (gap <= within) at_wall.push_back({arm, wall.normal, gap});
        }
        for (const Corner& c : thinned(std::move(at_wall))) corners.push_back(c);
    }
    if (corners.empty()) return {};

    const RigidBody::Mobility mobility = body.mobility();
    Vec3 velocity = body.state().velocity, turning = spin;
    for (Corner& c : corners) {
        Eigen::Matrix3d across;
        across << 0, -c.arm.z(), c.arm.y(), c.arm.z(), 0, -c.arm.x(), -c.arm.y(), c.arm.x(), 0;
        Eigen::Matrix3d response = mobility.linear - across * mobility.angular * across;
        c.normal_response = c.normal.dot(response * c.normal);
        const Eigen::Matrix3d along = Eigen::Matrix3d::Identity() - c.normal * c.normal.transpose(),
                              in_wall = along * response * along;
        const double sum = in_wall.trace(), squares = in_wall.squaredNorm();                 // of its two eigenvalues
        c.tangent_response = (sum + std::sqrt(std::max(0.0, 2 * squares - sum * sum))) / 2;  // the larger one
    }
    const double negligible = 1e-12 * mobility.linear.norm();
    const auto push = [&](const Corner& c, const Vec3& impulse) {
        velocity += mobility.linear * impulse;
        turning += mobility.angular * c.arm.cross(impulse);
        return (mobility.linear * impulse).norm() + (mobility.angular * c.arm.cross(impulse)).norm() * c.arm.norm();
    };
    for (int round = 0; round < most_rounds; ++round) {
        double change = 0;
        for (Corner& c : corners) {
            const double before = c.impulse.dot(c.normal);
            double pressed = before;
            if (c.normal_response > negligible) {
                const double u_n = c.normal.dot(velocity + turning.cross(c.arm));
                const double wanted = -(c.gap > 0 ? c.gap : let_out * c.gap) / ahead;
                pressed = std::max(0.0, before + (wanted - u_n) / c.normal_response);
                change = std::max(change, push(c, (pressed - before) * c.normal));
            }
            Vec3 held = c.impulse - before * c.normal;
            if (c.tangent_response > negligible && friction_ > 0) {
                const Vec3 u = velocity + turning.cross(c.arm), u_t = u - c.normal.dot(u) * c.normal, had = held;
                held -= u_t / c.tangent_response;
                if (const double most = friction_ * pressed; held.norm() > most) held *= most / held.norm();
                change = std::max(change, push(c, held - had));
            }
            c.impulse = pressed * c.normal + held;
        }
        if (change <= settled * fastest) break;
    }
    WallReaction all;
    for (const Corner& c : corners) all.impulse += c.impulse, all.turn += c.arm.cross(c.impulse);
    body.kick(all.impulse, all.turn, 1);
    return all;
}

}  // namespace tw
