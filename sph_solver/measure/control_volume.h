#pragma once
#include "base/vec3.h"
#include "sph_solver/bodies/samples.h"
#include "sph_solver/particles/particles.h"

namespace tw {

/// Force on what stands in a fixed box, from the momentum of the water that crosses its faces:
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
    explicit ControlVolume(const Box& box) : box_(box) {}
    /// Face patches of about `size`; faces that are symmetry planes count like the others. In two dimensions the patches
    /// reach over the whole span of the box and lie at its middle.
    void make_faces(double size, int dimensions);
    const Box& box() const { return box_; }
    PointSamples& faces() { return faces_; }
    bool inside(double x, double y, double z) const {
        return x >= box_.min.x() && x < box_.max.x() && y >= box_.min.y() && y < box_.max.y() && z >= box_.min.z() &&
               z < box_.max.z();
    }
    void add_crossed(const Vec3& momentum) { state_.crossed += momentum; }
    /// Adds the face pressure (after `faces()` were sampled) and gravity over the time `dt`.
    void add_impulse(double mass_inside, const Vec3& body_force, double dt);
    const State& state() const { return state_; }
    void set_state(const State& s) { state_ = s; }

    /// Momentum and mass of the water inside [N s, kg].
    static Vec3 momentum_inside(const ControlVolume& cv, const Particles& p, double particle_mass, double& mass_inside);

private:
    Box box_;
    PointSamples faces_;
    std::vector<Vec3> area_;
    State state_;
};

}  // namespace tw
