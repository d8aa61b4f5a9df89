#include "sph_solver/bodies/body.h"

#include <algorithm>
#include <cmath>
#include <limits>

#include "sph_solver/bodies/elastic/elastic_body.h"

namespace tw {

BodySetup::BodySetup(std::shared_ptr<const ElasticSetup> setup) : surface(skin_of(*setup)), elastic(std::move(setup)) {}

Body::Body(BodySetup setup) : setup_(std::move(setup)), query_(setup_.surface) {
    if (setup_.moving) rigid_.emplace(*setup_.moving);
    if (setup_.elastic) elastic_ = std::make_unique<ElasticBody>(setup_.elastic);
}
Body::~Body() = default;
Body::Body(Body&&) noexcept = default;

void Body::note_surface() {
    if (elastic_) elastic_->note_surface();
}

const SurfaceQuery& Body::query() const { return elastic_ ? elastic_->query() : query_; }

bool Body::stays_along(int axis) const {
    if (!rigid_ || rigid_->prescribed()) return fixed();
    const Freedoms& free = rigid_->freedoms();
    const auto a = static_cast<std::size_t>(axis);
    return !free.along[a] && !free.about[(a + 1) % 3] && !free.about[(a + 2) % 3];
}

Vec3 Body::now(const Vec3& x) const {
    if (elastic_) return elastic_->place(elastic_->tie(x));
    if (!rigid_) return x;
    return rigid_->state().centre + rigid_->state().attitude * (x - rigid_->mass().centre);
}

Vec3 Body::at_start(const Vec3& x) const {
    if (elastic_) return elastic_->as_noted(x);
    if (!rigid_) return x;
    return rigid_->mass().centre + turned_back(x - rigid_->state().centre);
}

Box Body::bounds() const {
    Box box{Vec3::Constant(std::numeric_limits<double>::infinity()),
            Vec3::Constant(-std::numeric_limits<double>::infinity())};
    for (const Vec3& x : surface().points) box.min = box.min.cwiseMin(now(x)), box.max = box.max.cwiseMax(now(x));
    return box;
}

MovedSolid Body::moved() const {
    MovedSolid solid{bounds()};
    if (!rigid_) return solid;
    solid.way.linear() = rigid_->state().attitude.toRotationMatrix();
    solid.way.translation() = now(Vec3::Zero());
    return solid;
}

BodyMotion Body::motion() const {
    if (!rigid_) return {};
    const RigidBody::State& s = rigid_->state();
    if (rigid_->prescribed())
        return {s.centre, s.velocity, rigid_->spin(), rigid_->prescribed_acceleration(),
                rigid_->prescribed_angular_acceleration()};
    return {s.centre, s.velocity, rigid_->spin(), acceleration_, angular_acceleration_};
}

void Body::set_shell(const WaterShell& shell) { shell_ = shell; }

/// The largest ratio of the shell's to the body's moment of inertia about a free axis.
double Body::shell_over_inertia() const {
    double most = 0;
    for (int a = 0; a < 3; ++a)
        if (rigid_->freedoms().about[static_cast<std::size_t>(a)])
            most = std::max(most, shell_.inertia(a, a) / rigid_->mass().inertia(a, a));
    return most;
}

/// Water that a wall moves into is compressed within one spacing: a spring of stiffness rho0 c0^2 A / dp, A the area.
/// With rho0 A dp a third of the shell's mass, which is more than three spacings deep, its frequency is
///
///   omega = c0 / dp sqrt(M_s / (3 m)),
///
/// and a step made of kicks and drifts is stable below 2 / omega. A wall's area counts in full here, whatever its
/// direction, so this is on the safe side: twice the step was still stable at a density of a hundredth of water's.
double Body::stable_step() const {
    if (elastic_) return elastic_->stable_step();
    if (!rigid_ || rigid_->prescribed()) return std::numeric_limits<double>::infinity();
    const double ratio = std::max(shell_.mass / rigid_->mass().mass, shell_over_inertia());
    return 2 * shell_.spacing / (shell_.sound_speed * std::sqrt(ratio / 3));
}

double Body::step_within(double dt) const { return elastic_ ? elastic_->step_within(dt) : dt; }

void Body::kick(const Vec3& force, const Vec3& moment, const Vec3& reference, const Vec3& gravity, double dt) {
    if (!rigid_ || rigid_->prescribed()) return;
    const Vec3 velocity = rigid_->state().velocity, spin = rigid_->spin();
    rigid_->kick(force + rigid_->mass().mass * gravity, moment - (rigid_->state().centre - reference).cross(force), dt);
    const double by_mass = 1 / (1 + shell_.mass / rigid_->mass().mass), by_inertia = 1 / (1 + shell_over_inertia());
    acceleration_ += by_mass * ((rigid_->state().velocity - velocity) / dt - acceleration_);
    angular_acceleration_ += by_inertia * ((rigid_->spin() - spin) / dt - angular_acceleration_);
}

void Body::strike(const Vec3& impulse, const Vec3& turn, const Vec3& reference) {
    if (rigid_) rigid_->kick(impulse, turn - (rigid_->state().centre - reference).cross(impulse), 1);
}

void Body::drift(double dt) {
    if (rigid_) rigid_->drift(dt);
    if (elastic_) elastic_->look_ahead(dt);
}

void Body::restore(const State& state) {
    rigid_.value().set_state(state.rigid);
    acceleration_ = state.acceleration;
    angular_acceleration_ = state.angular_acceleration;
}

}  // namespace tw
