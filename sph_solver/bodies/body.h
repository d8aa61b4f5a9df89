#pragma once
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "meshes/moved_solid.h"
#include "meshes/query.h"
#include "meshes/surface.h"
#include "motion/rigid_body.h"
#include "sph_solver/bodies/motion.h"

namespace tw {

class ElasticBody;
struct ElasticSetup;

/// A closed solid in the water.
struct BodySetup {
    Surface surface;  ///< as it stands at the start
    /// Velocity of the surface along itself, as of a belt [m/s]. Felt by water that the walls hold (effect viscosity,
    /// no slip).
    Vec3 sliding = Vec3::Zero();
    std::optional<RigidBodySetup> moving = {};  ///< none: fixed, or elastic
    std::shared_ptr<const ElasticSetup> elastic = {};
    std::string name = "body";  ///< in messages
    bool is_hull = false;       ///< the hull of the scene, whose loads and motion are reported as such

    BodySetup() = default;
    BodySetup(Surface s, const Vec3& along = Vec3::Zero()) : surface(std::move(s)), sliding(along) {}
    /// With the surface that the water sees.
    explicit BodySetup(std::shared_ptr<const ElasticSetup> setup);
};

/// The dummies of a body with water's density: a measure of the water that answers to its accelerations at once.
struct WaterShell {
    double mass = 0;                                    ///< [kg]
    Eigen::Matrix3d inertia = Eigen::Matrix3d::Zero();  ///< about the body's centre of mass [kg m2]
    double spacing = 0, sound_speed = 0;                ///< of the water [m], [m/s]
};

/// A solid's surface and motion: fixed, rigid or elastic (elastic/elastic_body.h). What a level of particles sees of it
/// are dummies (walls.h); what it feels of a level is a Load.
///
/// The body of a free motion and the water are advanced in turn, in the same kick-drift-kick: the water's last forces
/// kick the body, and its dummies hand the water an acceleration. Water near answers to that acceleration within the
/// same evaluation, with a force -M a, where M is about the mass of the water within the kernels' reach of the body. Of
/// a light body M > m, and a handed over as it was in the step before would grow by -M/m a step. So it is relaxed:
///
///   a' += theta (a - a'),   theta = 1 / (1 + M_s / m),
///
/// M_s the mass of water that the dummies would be (WaterShell, an upper bound of M), and likewise for rotation with
/// the inertias. The lag, (1 + M_s/m) steps of about dp/c0, vanishes with dp. Decision 032 has the measurements.
class Body {
public:
    explicit Body(BodySetup setup);
    ~Body();
    Body(Body&&) noexcept;

    const Surface& surface() const { return setup_.surface; }  ///< at the start
    const std::string& name() const { return setup_.name; }
    bool is_hull() const { return setup_.is_hull; }
    const Vec3& sliding() const { return setup_.sliding; }
    bool fixed() const { return !rigid_ && !elastic_; }
    /// Whether no point of it ever moves along an axis (0..2), as of a hull free in heave and pitch across its length.
    bool stays_along(int axis) const;
    /// Throws std::bad_optional_access for a body that is not rigid.
    const RigidBody& rigid() const { return rigid_.value(); }
    /// Null for a body that is not elastic.
    ElasticBody* elastic() { return elastic_.get(); }
    const ElasticBody* elastic() const { return elastic_.get(); }
    /// Of a rigid body, with the relaxed acceleration of a free one.
    BodyMotion motion() const;

    /// Where a point of the body is now that was at `x` at the start, and back [m]; of an elastic body back to where
    /// `query` sees its surface.
    Vec3 now(const Vec3& x) const;
    Vec3 at_start(const Vec3& x) const;
    Box bounds() const;        ///< of the surface now
    MovedSolid moved() const;  ///< of an elastic body without the way
    /// Directions likewise.
    Vec3 turned(const Vec3& v) const { return rigid_ ? Vec3(rigid_->state().attitude * v) : v; }
    Vec3 turned_back(const Vec3& v) const { return rigid_ ? Vec3(rigid_->state().attitude.conjugate() * v) : v; }
    /// Of the surface as it stood at the start; of an elastic body as it stood when the lists were made.
    const SurfaceQuery& query() const;
    void note_surface();  ///< for `query`; rigid bodies need it not

    /// Before the first step: see above.
    void set_shell(const WaterShell& shell);
    /// So that neither the body on the spring of compressible water nor its turning is unstable [s], see body.cpp.
    double stable_step() const;
    /// The step that the body takes where `dt` is allowed [s].
    double step_within(double dt) const;

    /// `moment`: about `reference` [m]. Weight is added here.
    void kick(const Vec3& force, const Vec3& moment, const Vec3& reference, const Vec3& gravity, double dt);
    /// Blows of particles that a wall had to hold: impulse [N s] and its moment about `reference` [N m s].
    void strike(const Vec3& impulse, const Vec3& turn, const Vec3& reference);
    void drift(double dt);

    /// What a restart needs.
    struct State {
        RigidBody::State rigid;
        Vec3 acceleration = Vec3::Zero(), angular_acceleration = Vec3::Zero();  ///< relaxed
    };
    /// Of a rigid body; an elastic one has its own.
    State state() const { return {rigid().state(), acceleration_, angular_acceleration_}; }
    void restore(const State& state);

private:
    double shell_over_inertia() const;

    BodySetup setup_;
    SurfaceQuery query_;
    std::optional<RigidBody> rigid_;
    std::unique_ptr<ElasticBody> elastic_;
    Vec3 acceleration_ = Vec3::Zero(), angular_acceleration_ = Vec3::Zero();
    WaterShell shell_;
};

}  // namespace tw
