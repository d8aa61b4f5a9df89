#include "sph_solver/measure/tank_balance.h"

#include <fmt/format.h>

#include "base/exact_sum.h"
#include "record/tank_table.h"

namespace tw {
namespace {

/// Calls `add(sum, place, velocity)` for the particles of a level that count, on all ranks.
template <class Sum, class Add>
Sum sum_over_water(const Level& level, const Add& add) {
    const Particles& p = level.fields().particles_in_motion();
    return level.fields().sum_over_all<Sum>([&](Sum& sum, std::size_t i) {
        if (is_active(p.kind[i])) add(sum, Vec3(p.x[i], p.y[i], p.z[i]), Vec3(p.u[i], p.v[i], p.w[i]));
    });
}

/// Of all sizes and of the air [N s].
Vec3 momentum_of(const Simulation& simulation) {
    Vec3 momentum = Vec3::Zero();
    for (const auto& level : simulation.levels())
        momentum += level->system().mass *
                    sum_over_water<ExactVectorSum>(*level, [](ExactVectorSum& sum, const Vec3&, const Vec3& u) {
                        sum += u;
                    }).value();
    return momentum;
}

/// What the tank's motion does to the water of all sizes and to the air [N], [W].
struct Drive {
    Vec3 force = Vec3::Zero();
    double power = 0;
};

Drive drive_of(const Simulation& simulation) {
    struct Sums {  // per unit of particle mass
        ExactVectorSum force;
        ExactSum power;
        Sums& operator+=(const Sums& other) {
            force += other.force, power += other.power;
            return *this;
        }
    };
    const Vec3& gravity = simulation.setup().gravity;
    const FrameForce frame = simulation.setup().force(simulation.time());
    Drive drive;
    for (const auto& level : simulation.levels()) {
        const Sums sums = sum_over_water<Sums>(*level, [&](Sums& sum, const Vec3& x, const Vec3& u) {
            const Vec3 f = frame.at(x, u);
            sum.force += f;
            sum.power += (f - gravity).dot(u);
        });
        drive.force += level->system().mass * sums.force.value();
        drive.power += level->system().mass * sums.power.value();
    }
    return drive;
}

/// Of water and air on the bodies that are not fixed in the tank [N].
Vec3 force_on_bodies(const Simulation& simulation) {
    Vec3 force = Vec3::Zero();
    for (std::size_t b = 0; b < simulation.bodies().size(); ++b) {
        if (simulation.body(b).fixed()) continue;
        force += simulation.load(b).force;
        if (const Level* air = simulation.gas()) force += air->system().walls.loads()[b].force;
    }
    return force;
}

}  // namespace

void TankBalance::begin(const Simulation& simulation) {
    momentum_ = momentum_of(simulation);
    impulse_ = Vec3::Zero();
    work_ = since_ = 0;
    time_ = simulation.time();
}

void TankBalance::after_step(const Simulation& simulation) {
    const double dt = simulation.time() - time_;
    const Drive now = drive_of(simulation);
    impulse_ += dt * (now.force - force_on_bodies(simulation));
    work_ += dt * now.power;
    since_ += dt;
    time_ = simulation.time();
}

void TankBalance::record(const Simulation& simulation, Table& tank, const std::string& N, const std::string& J) {
    const Vec3 force = (impulse_ - (momentum_of(simulation) - momentum_)) / since_;
    const Column* before = tank.find(tank_work);
    const double work = (before && !before->values.empty() ? before->values.back() : 0) + work_;
    const std::size_t row = tank.append(simulation.time());
    for (int a = 0; a < 3; ++a) tank.set(row, fmt::format("f{}", "xyz"[a]), N, force[a] + 0.0);
    tank.set(row, tank_work, J, work);
    begin(simulation);
}

}  // namespace tw
