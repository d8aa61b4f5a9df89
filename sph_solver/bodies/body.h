#pragma once
#include <functional>
#include <limits>
#include <memory>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "meshes/moved_solid.h"
#include "meshes/query.h"
#include "meshes/surface.h"
#include "motion/moving_frame.h"
#include "motion/rigid_body.h"
#include "motion/wall_contact.h"
#include "sph_solver/bodies/attached.h"
#include "sph_solver/bodies/dummies.h"
#include "sph_solver/bodies/load.h"

namespace tw {

struct ElasticSetup;
struct PointSamples;

/// A closed solid in the water.
struct BodySetup {
    Surface surface;  ///< as it stands at the start
    /// Velocity of the surface along itself, as of a belt [m/s]. Felt by water that the walls hold (effect viscosity,
    /// no slip).
    Vec3 sliding = Vec3::Zero();
    std::optional<RigidBodySetup> moving = {};  ///< none: fixed, or elastic
    std::optional<WallContact> contact = {};    ///< of a free body with walls of the tank; none: it must not touch them
    std::shared_ptr<const ElasticSetup> elastic = {};
    std::string name = "body";  ///< in messages
    bool is_hull = false;       ///< the hull of the scene, whose loads and motion are reported as such

    BodySetup() = default;
    BodySetup(Surface s, const Vec3& along = Vec3::Zero()) : surface(std::move(s)), sliding(along) {}
    /// With the surface that the water sees.
    explicit BodySetup(std::shared_ptr<const ElasticSetup> setup);
};

/// What a body has to know of the water round it.
struct WaterNear {
    double density = 0, spacing = 0, sound_speed = 0;  ///< [kg/m3], [m], [m/s]
    Vec3 gravity = Vec3::Zero(), moment_reference = Vec3::Zero();
    std::optional<MovingFrame> frame = {};  ///< of a tank that moves, in whose axes the body is
    int dimensions = 3;
};

/// A step of the finest particles: for how long forces act, what was drifted before, and what will be at its end [s].
struct BodyStep {
    double kick, drifted, drift;
};

/// A solid in the water, behind one face for all kinds: it moves, its dummies show that to the water (walls.h), and it
/// takes what the water does to them. This one is fixed; rigid_in_water.h and elastic/elastic_body.h are the others.
///
/// In a step of the finest particles, the calls are
///
///   look_ahead(drift)                          to where the water is found by its pair loops
///   take(...), sub_iterate(step)               as often as the body asks for; the forces are found anew after each
///   take(...), move(step)                      through the step
///   take_impulse(...)                          what the walls had to hold at the step's end
class Body {
public:
    /// Of the kind that the setup asks for.
    static std::unique_ptr<Body> of(BodySetup setup);
    explicit Body(BodySetup setup);
    virtual ~Body() = default;
    Body(const Body&) = delete;
    Body& operator=(const Body&) = delete;

    const Surface& surface() const { return setup_.surface; }  ///< at the start
    const std::string& name() const { return setup_.name; }
    const Vec3& sliding() const { return setup_.sliding; }
    bool is_hull() const { return setup_.is_hull; }
    virtual bool fixed() const { return true; }
    /// Whether the water has no part in how it moves.
    virtual bool prescribed() const { return fixed(); }
    /// Whether its shape changes.
    virtual bool is_deformable() const { return false; }
    /// Whether no point of it ever moves along an axis (0..2), as of a hull free in heave and pitch across its length.
    virtual bool stays_along(int /*axis*/) const { return fixed(); }
    /// Whether it may touch the tank's wall of this normal into the tank, because its contact with that is solved.
    virtual bool meets_wall(const Vec3& /*normal*/) const { return false; }

    // --- where it is
    /// Where a point of the body is now that was at `x` at the start, and back [m]; of one that deforms back to where
    /// `query` sees its surface.
    virtual Vec3 now(const Vec3& x) const { return x; }
    virtual Vec3 at_start(const Vec3& x) const { return x; }
    /// Directions likewise; of one that deforms as they are.
    virtual Vec3 turned(const Vec3& v) const { return v; }
    virtual Vec3 turned_back(const Vec3& v) const { return v; }
    /// Its surface now. `span`: of a section, how far its prism reaches [m].
    virtual Surface surface_now(std::optional<double> span = {}) const;
    Box bounds() const { return surface_now().bounds(); }
    virtual MovedSolid moved() const { return {bounds()}; }  ///< of one that deforms without the way
    /// Of the surface as it stood at the start; of one that deforms as it stood when it was last noted.
    virtual const SurfaceQuery& query() const { return query_; }
    virtual void note_surface() {}  ///< for `query`, when lists are made

    // --- dummies
    virtual Dummies dummies(const DummyLattice& lattice) const;
    /// Points that go with the body from where they are at the start.
    virtual std::unique_ptr<Attached> attach(std::vector<Vec3> at_start) const;

    // --- move
    /// Before the first step. `dummies`: as the finest particles see it, at the start.
    virtual void meet(const WaterNear& /*water*/, const Dummies& /*dummies*/) {}
    virtual double stable_step() const { return std::numeric_limits<double>::infinity(); }  ///< [s]
    /// The step that the body takes where `dt` is allowed [s].
    virtual double step_within(double dt) const { return dt; }
    /// How often it wants to try a step before it makes it.
    virtual int sub_iterations() const { return 0; }
    virtual void look_ahead(double /*drift*/) {}
    virtual void sub_iterate(const BodyStep& /*step*/) {}
    virtual void move(const BodyStep& /*step*/) {}
    /// Impulses of particles that a wall had to hold: all together, or place by place.
    virtual void take_impulse(const Impulse& /*all*/) {}
    virtual void take_impulse(const WallImpulse& /*place*/) {}

    // --- take: what the water does to it in the next `sub_iterate` or `move`
    virtual void take(const Load& /*load*/) {}
    virtual bool takes_forces_of_dummies() const { return false; }
    /// Where it wants to know the water's pressure, and takes it [m]; empty: nowhere now.
    virtual std::vector<Vec3> feels_at() const { return {}; }
    virtual void take(const PointSamples& /*felt*/) {}
    /// Forces on points attached to it [N] (per metre of width in two dimensions), and at places of its surface.
    virtual void take(const Attached& /*dummies*/, const std::vector<Vec3>& /*forces*/) {}
    virtual void take(const WallPush& /*push*/) {}
    /// Whether it presses on particles by a force of its own, and that force along the surface's normal on one whose
    /// distance from the surface is `distance` [N].
    virtual bool presses() const { return false; }
    virtual double pressing(double /*distance*/, double /*dp*/) const { return 0; }

    // --- what is kept of it
    /// Gets a name, a unit and a value; forces and energies are those of the whole width.
    using Note = std::function<void(const std::string& name, const std::string& unit, double value)>;
    /// Where it is and how it moves, under the water's load.
    virtual void describe(const Load& /*load*/, const Note& /*note*/) const {}
    /// Whether the work of the water is in that description.
    virtual bool knows_its_work() const { return false; }
    /// Energy that its interface with the water has made lately, over that exchanged [-]; nothing where none can be
    /// made. Beyond `trusted_interface_energy` the interface is not trusted.
    virtual std::optional<double> energy_made_lately() const { return {}; }
    /// All that changes, for a restart that goes on to the same bits.
    virtual std::vector<double> state() const { return {}; }
    /// Throws std::invalid_argument for numbers that are those of no state of this body.
    virtual void restore(std::span<const double> state);

private:
    BodySetup setup_;
    SurfaceQuery query_;
};

inline constexpr double trusted_interface_energy = 0.5;

using Bodies = std::vector<std::unique_ptr<Body>>;

/// Whether all are fixed.
bool all_fixed(const Bodies& bodies);

}  // namespace tw
