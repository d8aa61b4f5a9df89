#pragma once
#include <cstdint>
#include <functional>
#include <vector>

#include "base/exact_sum.h"
#include "base/vec3.h"
#include "sph_solver/bodies/samples.h"
#include "sph_solver/fields/particles.h"

namespace tw {

/// Force on what stands in a fixed box, or in some of its cells, from the momentum of the water that crosses the faces:
///
///   F = -d/dt (sum_i phi m u) + sum_i m u dphi/dt - sum_faces P n A + sum_i phi m g
///
/// with phi the share of a particle, a cube of a cell's size, that is inside. Whole particles will not do: water by the
/// floor keeps its layers, and one layer more or less weighs rho g dp, while the pressure on the floor is continuous
/// (docs/decisions/058). Momentum inside and across is exact; P on the faces is sampled as the pair forces carry it,
/// the sum of p m V W (see CarriedShare): among disordered particles it is up to 1 % less than p, and pulls along the
/// faces too. Means over a time much longer than a particle's passage dp/U are meaningful, single values are not.
class ControlVolume {
public:
    /// The running sums, part of a restart.
    struct State {
        Vec3 crossed = Vec3::Zero();  ///< momentum carried in minus out since the start [N s]
        Vec3 impulse = Vec3::Zero();  ///< of face pressure and gravity [N s]
        double since = 0;             ///< for so long the sums have been taken [s]
    };

    ControlVolume() = default;
    /// The box is cut into cells of about `size`, whose outer faces are the patches. In two dimensions cells reach over
    /// the whole span of the box, and their faces lie at its middle.
    struct Shape {
        int dimensions = 3;
        bool mirrored = false;                     ///< the face at low y is a symmetry plane; it counts like the others
        std::function<bool(const Vec3&)> takes{};  ///< which cells belong to it, by their middle; empty: all
    };
    ControlVolume(const Box& box, double size, const Shape& shape);
    const Box& box() const { return box_; }
    PointSamples& faces() { return faces_; }
    /// Which share of a particle at a place is inside [0, 1].
    double share(double x, double y, double z) const {
        Vec3 at = (Vec3(x, y, z) - box_.min).cwiseQuotient(cell_).array() + 0.5;  // from the middles of cells -1
        if (flat_) at.y() = 1;
        if (!(at.array() >= 0).all() || (at.array() >= count_.cast<double>() + 1).any()) return 0;
        const Eigen::Array3i first = at.array().cast<int>();
        const std::uint8_t corners = corners_[corner(first)];
        if (corners == 0) return 0;
        return corners == 255 ? 1 : between(corners, at - first.cast<double>().matrix());
    }
    void add_crossed(const Vec3& momentum) { state_.crossed += momentum; }
    /// Adds the face pressure (after `faces()` were sampled) and gravity over the time `dt`.
    void add_impulse(double mass_inside, const Vec3& body_force, double dt);
    const State& state() const { return state_; }
    void set_state(const State& s) { state_ = s; }

    /// Of the water inside, per unit of particle mass.
    struct Inside {
        ExactVectorSum momentum;  ///< [m/s]
        ExactSum share;           ///< particles
        Inside& operator+=(const Inside& other) {
            momentum += other.momentum, share += other.share;
            return *this;
        }
    };
    void add_inside(const Particles& p, std::size_t i, Inside& inside) const;

private:
    /// Index of the corner where the cells c - 1 and c meet.
    std::size_t corner(const Eigen::Array3i& c) const {
        return static_cast<std::size_t>((std::int64_t{c.z()} * (count_.y() + 1) + c.y()) * (count_.x() + 1) + c.x());
    }
    static double between(std::uint8_t corners, const Vec3& part);

    Box box_;
    Vec3 cell_ = Vec3::Ones();
    Eigen::Array3i count_ = Eigen::Array3i::Zero();
    bool flat_ = false;
    std::vector<std::uint8_t>
        corners_;  ///< of each corner which of the eight cells that meet there belong: bit x + 2 y + 4 z
    PointSamples faces_;
    std::vector<Vec3> area_;
    State state_;
};

}  // namespace tw
