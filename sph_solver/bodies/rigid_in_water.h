#pragma once
#include "sph_solver/bodies/body.h"
#include "sph_solver/bodies/water_film.h"

namespace tw {

/// How a rigid body moves at one moment: what its dummies hand to the water.
///
///   u(x) = U + omega x (x - X),   a(x) = dU/dt + domega/dt x (x - X) + omega x (omega x (x - X))
struct BodyMotion {
    Vec3 centre = Vec3::Zero();                ///< X [m]
    Vec3 velocity = Vec3::Zero();              ///< U [m/s]
    Vec3 rotation = Vec3::Zero();              ///< omega [rad/s]
    Vec3 acceleration = Vec3::Zero();          ///< dU/dt [m/s2]
    Vec3 angular_acceleration = Vec3::Zero();  ///< domega/dt [rad/s2]

    Vec3 velocity_at(const Vec3& x) const { return velocity + rotation.cross(x - centre); }
    Vec3 acceleration_at(const Vec3& x) const {
        return acceleration + angular_acceleration.cross(x - centre) + rotation.cross(rotation.cross(x - centre));
    }
};

/// A rigid body (motion/rigid_body.h) that moves as prescribed, or freely under the water's load and its weight.
///
/// The body of a free motion and the water are advanced in turn, in the same kick-drift-kick: the water's last forces
/// kick the body, and its dummies hand the water an acceleration. Water near answers to that acceleration within the
/// same evaluation, with a force -M a, where M is about the mass of the water within the kernels' reach of the body. Of
/// a light body M > m, and a handed over as it was in the step before would grow by -M/m a step. So it is relaxed:
///
///   a' += theta (a - a'),   theta = 1 / (1 + M_s / m),
///
/// M_s the mass of water that the dummies would be (an upper bound of M), and likewise for rotation with the inertias.
/// The lag, (1 + M_s/m) steps of about dp/c0, vanishes with dp. Decision 032 has the measurements.
class RigidInWater : public Body {
public:
    explicit RigidInWater(BodySetup setup);

    const RigidBody& rigid() const { return rigid_; }
    BodyMotion motion() const;  ///< with the relaxed acceleration of a free body

    bool fixed() const override { return false; }
    bool prescribed() const override { return rigid_.prescribed(); }
    bool stays_along(int axis) const override;
    bool meets_wall(const Vec3& normal) const override { return contact_ && contact_->at(normal); }

    Vec3 now(const Vec3& x) const override;
    Vec3 at_start(const Vec3& x) const override;
    Vec3 turned(const Vec3& v) const override { return rigid_.state().attitude * v; }
    Vec3 turned_back(const Vec3& v) const override { return rigid_.state().attitude.conjugate() * v; }
    MovedSolid moved() const override;
    std::unique_ptr<Attached> attach(std::vector<Vec3> at_start) const override;

    void meet(const WaterNear& water, const Dummies& dummies) override;
    /// So that neither the body on the spring of compressible water nor its turning is unstable, see the source.
    double stable_step() const override;
    void look_ahead(double drift) override { rigid_.drift(drift); }
    void move(const BodyStep& step) override;
    void take_impulse(const Impulse& all) override;
    void take(const Load& load) override { load_ = load, of_film_ = {}; }
    std::vector<Vec3> feels_at() const override;
    void take(const PointSamples& felt) override;

    void describe(const Load& load, const Note& note) const override;
    std::vector<double> state() const override;
    void restore(std::span<const double> state) override;

private:
    double shell_over_inertia() const;
    void kick(double dt);
    /// Keeps the body out of the walls for the time `ahead` [s]; the impulse counts as of the step.
    void meet_walls(double ahead);
    Vec3 about_centre(const Vec3& force, const Vec3& moment) const;

    RigidBody rigid_;
    Vec3 acceleration_ = Vec3::Zero(), angular_acceleration_ = Vec3::Zero();  ///< relaxed
    WaterNear water_;
    /// The dummies as water: their mass [kg], and its inertia about the body's centre of mass [kg m2].
    double shell_mass_ = 0;
    Eigen::Matrix3d shell_inertia_ = Eigen::Matrix3d::Zero();
    Load load_;  ///< that waits for `move`
    std::optional<WallContact> contact_;
    std::optional<WaterFilm> film_;
    Load of_film_;                      ///< what it adds to that of the particles, within load_
    WallReaction of_walls_;             ///< in the last step
    double last_kick_ = 0, ahead_ = 0;  ///< how long that was, and for how long it moves on by its velocity [s]
};

/// Throws std::bad_cast for a body that is not rigid.
inline const RigidBody& rigid_of(const Body& body) { return dynamic_cast<const RigidInWater&>(body).rigid(); }

}  // namespace tw
