#include "sph_solver/bodies/rigid_in_water.h"

#include <algorithm>
#include <cmath>
#include <stdexcept>

namespace tw {
namespace {

/// Points of a rigid body, which move as it did when it was looked at last.
class RigidPoints : public Attached {
public:
    RigidPoints(const RigidInWater& body, std::vector<Vec3> places) : Attached(std::move(places)), body_(body) {
        for (const Vec3& x : at_start()) reach_ = std::max(reach_, (x - body.rigid().mass().centre).norm());
        motion_ = body.motion();
    }
    void look() override { motion_ = body_.motion(); }
    Vec3 place(std::size_t k) const override { return body_.now(at_start()[k]); }
    Motion motion(std::size_t, const Vec3& x) const override {
        return {motion_.velocity_at(x), motion_.acceleration_at(x)};
    }
    Vec3 surface_velocity(const Vec3& x, std::int32_t) const override { return motion_.velocity_at(x); }
    WallMotion surface_motion() const override {
        const auto v3 = [](const Vec3& v) { return V3<double>{v.x(), v.y(), v.z()}; };
        return {v3(motion_.centre), v3(motion_.velocity), v3(motion_.rotation)};
    }
    double fastest() const override { return motion_.velocity.norm() + motion_.rotation.norm() * reach_; }

private:
    const RigidInWater& body_;
    BodyMotion motion_;
    double reach_ = 0;  ///< from the body's centre [m]
};

}  // namespace

RigidInWater::RigidInWater(BodySetup setup) : Body(setup), rigid_(setup.moving.value()), contact_(setup.contact) {}

BodyMotion RigidInWater::motion() const {
    const RigidBody::State& s = rigid_.state();
    if (rigid_.prescribed())
        return {s.centre, s.velocity, rigid_.spin(), rigid_.prescribed_acceleration(),
                rigid_.prescribed_angular_acceleration()};
    return {s.centre, s.velocity, rigid_.spin(), acceleration_, angular_acceleration_};
}

bool RigidInWater::stays_along(int axis) const {
    if (rigid_.prescribed()) return false;
    const DegreesOfFreedom& free = rigid_.dofs();
    const auto a = static_cast<std::size_t>(axis);
    return !free.along[a] && !free.about[(a + 1) % 3] && !free.about[(a + 2) % 3];
}

Vec3 RigidInWater::now(const Vec3& x) const { return rigid_.now(x); }

Vec3 RigidInWater::at_start(const Vec3& x) const {
    return rigid_.mass().centre + turned_back(x - rigid_.state().centre);
}

MovedSolid RigidInWater::moved() const {
    MovedSolid solid{bounds()};
    solid.way.linear() = rigid_.state().attitude.toRotationMatrix();
    solid.way.translation() = now(Vec3::Zero());
    return solid;
}

std::unique_ptr<Attached> RigidInWater::attach(std::vector<Vec3> places) const {
    return std::make_unique<RigidPoints>(*this, std::move(places));
}

// --- move -----------------------------------------------------------------------------------------------------------

void RigidInWater::meet(const WaterNear& water, const Dummies& dummies) {
    water_ = water;
    if (contact_) {
        contact_->keep_room(water.spacing);
        film_.emplace(surface(), water.dimensions, water.spacing);
    }
    shell_mass_ = 0;
    shell_inertia_.setZero();
    for (std::size_t k = 0; k < dummies.places.size(); ++k) {
        const double m = water.density * dummies.volumes[k];
        const Vec3 r = dummies.places[k] - rigid_.mass().centre;
        shell_mass_ += m;
        shell_inertia_ += m * (r.squaredNorm() * Eigen::Matrix3d::Identity() - r * r.transpose());
    }
}

/// The largest ratio of the shell's to the body's moment of inertia about a free axis.
double RigidInWater::shell_over_inertia() const {
    double most = 0;
    for (int a = 0; a < 3; ++a)
        if (rigid_.dofs().about[static_cast<std::size_t>(a)])
            most = std::max(most, shell_inertia_(a, a) / rigid_.mass().inertia(a, a));
    return most;
}

/// Water that a wall moves into is compressed within one spacing: a spring of stiffness rho0 c0^2 A / dp, A the area.
/// With rho0 A dp a third of the shell's mass, which is more than three spacings deep, its frequency is
///
///   omega = c0 / dp sqrt(M_s / (3 m)),
///
/// and a step made of kicks and drifts is stable below 2 / omega. A wall's area counts in full here, whatever its
/// direction, so this is on the safe side: twice the step was still stable at a density of a hundredth of water's.
double RigidInWater::stable_step() const {
    if (rigid_.prescribed()) return std::numeric_limits<double>::infinity();
    const double ratio = std::max(shell_mass_ / rigid_.mass().mass, shell_over_inertia());
    return 2 * water_.spacing / (water_.sound_speed * std::sqrt(ratio / 3));
}

/// A moment about the run's reference as one about the centre of mass.
Vec3 RigidInWater::about_centre(const Vec3& force, const Vec3& moment) const {
    return moment - (rigid_.state().centre - water_.moment_reference).cross(force);
}

/// By the water and by its weight; in a tank that moves by what the body feels of that, found in the middle of the kick
/// because it goes with the velocity.
void RigidInWater::kick(double dt) {
    const Vec3 moment = about_centre(load_.force, load_.moment);
    if (!water_.frame) return rigid_.kick(load_.force + rigid_.mass().mass * water_.gravity, moment, dt);
    const FrameForce f = water_.frame->force(rigid_.state().time, water_.gravity);
    const auto load = [&](const RigidBody& body) {
        const FrameLoad felt = load_on(body, f);
        return FrameLoad{load_.force + felt.force, moment + felt.moment};
    };
    RigidBody middle = rigid_;
    const FrameLoad first = load(middle);
    middle.kick(first.force, first.moment, dt / 2);
    const FrameLoad second = load(middle);
    rigid_.kick(second.force, second.moment, dt);
}

std::vector<Vec3> RigidInWater::feels_at() const {
    if (!film_ || film_->share(contact_->gap(rigid_)) == 0) return {};
    return film_->places(rigid_);
}

void RigidInWater::take(const PointSamples& felt) {
    const Vec3& centre = rigid_.state().centre;
    const Vec3 f = water_.frame
                       ? water_.frame->force(rigid_.state().time, water_.gravity).at(centre, rigid_.state().velocity)
                       : water_.gravity;
    const Load pressed = film_->load(rigid_, *contact_, felt, water_.density * f);
    const Vec3 moment = pressed.moment + (centre - water_.moment_reference).cross(pressed.force);
    // friction is left as it is, but for its moment, which is not known apart
    of_film_ = film_->share(contact_->gap(rigid_)) *
               Load{pressed.force - (load_.force - load_.friction), Vec3::Zero(), moment - load_.moment};
    load_ += of_film_;
}

void RigidInWater::move(const BodyStep& step) {
    if (!rigid_.prescribed()) {
        const Vec3 velocity = rigid_.state().velocity, spin = rigid_.spin();
        kick(step.kick);
        of_walls_ = {};
        last_kick_ = step.kick;
        meet_walls(2 * step.drift);  // with the next step's first half
        const double by_mass = 1 / (1 + shell_mass_ / rigid_.mass().mass), by_inertia = 1 / (1 + shell_over_inertia());
        acceleration_ += by_mass * ((rigid_.state().velocity - velocity) / step.kick - acceleration_);
        angular_acceleration_ += by_inertia * ((rigid_.spin() - spin) / step.kick - angular_acceleration_);
    }
    rigid_.drift(step.drift);
}

void RigidInWater::meet_walls(double ahead) {
    if (!contact_) return;
    ahead_ = ahead;
    const WallReaction reaction = contact_->resist(rigid_, ahead);
    of_walls_.impulse += reaction.impulse, of_walls_.turn += reaction.turn;
}

void RigidInWater::take_impulse(const Impulse& all) {
    if (all.impulse.isZero(0) && all.turn.isZero(0)) return;
    rigid_.kick(all.impulse, about_centre(all.impulse, all.turn), 1);
    meet_walls(ahead_);
}

// --- what is kept of it ---------------------------------------------------------------------------------------------

void RigidInWater::describe(const Load& load, const Note& note) const {
    const auto put = [&](const std::string& before, const std::string& after, const std::string& unit, const Vec3& v) {
        for (int a = 0; a < 3; ++a) note(before + "xyz"[a] + after, unit, v[a] + 0.0);
    };
    const RigidBody::State& s = rigid_.state();
    put("", "", "m", s.centre);
    double lowest = HUGE_VAL;
    for (const Vec3& p : surface().points) lowest = std::min(lowest, now(p).z());
    note("lowest", "m", lowest);
    note("q0", "-", s.attitude.w());
    put("q", "", "-", s.attitude.vec());
    put("v", "", "m/s", s.velocity);
    put("spin_", "", "rad/s", rigid_.spin());
    const Vec3 moment = about_centre(load.force, load.moment);
    put("f", "", "N", load.force);
    put("m", "", "N m", moment);
    put("f", "_body", "N", turned_back(load.force));
    put("m", "_body", "N m", turned_back(moment));
    if (!contact_) return;
    put("film_", "", "N", of_film_.force);
    put("walls_", "", "N", last_kick_ > 0 ? Vec3(of_walls_.impulse / last_kick_) : Vec3::Zero());
}

std::vector<double> RigidInWater::state() const {
    const RigidBody::State& s = rigid_.state();
    const Eigen::Quaterniond& q = s.attitude;
    std::vector<double> numbers{s.time, q.w(), q.x(), q.y(), q.z()};
    for (const Vec3& v : {s.centre, s.velocity, s.angular_momentum, acceleration_, angular_acceleration_})
        numbers.insert(numbers.end(), v.data(), v.data() + 3);
    if (contact_)
        for (const bool cleared : contact_->cleared()) numbers.push_back(cleared);
    return numbers;
}

void RigidInWater::restore(std::span<const double> n) {
    const std::size_t walls = contact_ ? contact_->walls().size() : 0;
    if (n.size() != 20 + walls) throw std::invalid_argument("another number of numbers");
    RigidBody::State s;
    s.time = n[0];
    s.attitude = Eigen::Quaterniond(n[1], n[2], n[3], n[4]);
    std::size_t k = 5;
    for (Vec3* v : {&s.centre, &s.velocity, &s.angular_momentum, &acceleration_, &angular_acceleration_}) {
        *v = Vec3(n[k], n[k + 1], n[k + 2]);
        k += 3;
    }
    rigid_.set_state(s);
    if (!contact_) return;
    std::vector<bool> cleared;
    for (const double flag : n.subspan(20)) cleared.push_back(flag != 0);
    contact_->set_cleared(std::move(cleared));
}

}  // namespace tw
