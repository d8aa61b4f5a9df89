#pragma once
#include <cstdint>
#include <functional>
#include <vector>

#include "base/vec3.h"
#include "sph_solver/bodies/samples.h"
#include "sph_solver/particles/particles.h"

namespace tw {

/// Force on what stands in a fixed box, or in some of its cells, from the momentum of the water that
/// crosses the faces:
///
///   F = -d/dt (sum_inside m u) + sum_crossing m u / dt - sum_faces p n A + sum_inside m g
///
/// Momentum inside and across is counted particle by particle (exact); the pressure on the faces is sampled as
/// the pair forces carry it, p m_nn (see CarriedShare): among disordered particles that is about 1 % less than p.
/// Means over a time much longer than a particle's passage dp/U are meaningful, single values are not.
class ControlVolume {
public:
    /// The running sums, part of a restart.
    struct State {
        Vec3 crossed = Vec3::Zero();  ///< momentum carried in minus out since the start [N s]
        Vec3 impulse = Vec3::Zero();  ///< of face pressure and gravity [N s]
        double since = 0;
    };

    ControlVolume() = default;
    /// The box is cut into cells of about `size`, whose outer faces are the patches; faces that are symmetry planes
    /// count like the others. In two dimensions cells reach over the whole span of the box, and their faces lie at its
    /// middle. `takes`: which cells belong to it, by their middle; all where it is not given.
    ControlVolume(const Box& box, double size, int dimensions, const std::function<bool(const Vec3&)>& takes = {});
    const Box& box() const { return box_; }
    PointSamples& faces() { return faces_; }
    bool inside(double x, double y, double z) const {
        const Vec3 at = (Vec3(x, y, z) - box_.min).cwiseQuotient(cell_);
        if (!(at.x() >= 0 && at.y() >= 0 && at.z() >= 0)) return false;
        return inside(static_cast<int>(at.x()), static_cast<int>(at.y()), static_cast<int>(at.z()));
    }
    void add_crossed(const Vec3& momentum) { state_.crossed += momentum; }
    /// Adds the face pressure (after `faces()` were sampled) and gravity over the time `dt`.
    void add_impulse(double mass_inside, const Vec3& body_force, double dt);
    const State& state() const { return state_; }
    void set_state(const State& s) { state_ = s; }

    /// Momentum and mass of the water inside [N s, kg].
    static Vec3 momentum_inside(const ControlVolume& cv, const Particles& p, double particle_mass, double& mass_inside);

private:
    bool inside(int i, int j, int k) const {
        if (i < 0 || j < 0 || k < 0 || i >= count_.x() || j >= count_.y() || k >= count_.z()) return false;
        return taken_.empty() || taken_[static_cast<std::size_t>((std::int64_t{k} * count_.y() + j) * count_.x() + i)];
    }

    Box box_;
    Vec3 cell_ = Vec3::Ones();
    Eigen::Array3i count_ = Eigen::Array3i::Zero();
    std::vector<char> taken_;  ///< of the cells; empty: all
    PointSamples faces_;
    std::vector<Vec3> area_;
    State state_;
};

}  // namespace tw
