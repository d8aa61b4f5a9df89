#include "sph_solver/measure/tank_balance.h"

#include <fmt/format.h>

#include "record/tank_table.h"
#include "sph_solver/backend/for_particles.h"

namespace tw {
namespace {

/// Over the water, by mass [N s], [N], [W].
struct Sums {
    Vec3 momentum = Vec3::Zero(), force = Vec3::Zero();
    double power = 0;
};

/// Of the particles that count, of all sizes and of the air.
Sums sums_of(const Simulation& simulation) {
    const SimulationSetup& s = simulation.setup();
    const FrameForce force = s.force(simulation.time());
    Sums sums;
    for (const auto& level : simulation.levels()) {
        const Particles& p = level->particles();
        const auto add = [&](Sums& part, std::size_t first, std::size_t last) {
            for (std::size_t i = first; i < last; ++i) {
                if (!is_active(p.kind[i])) continue;
                const Vec3 u(p.u[i], p.v[i], p.w[i]), f = force.at({p.x[i], p.y[i], p.z[i]}, u);
                part.momentum += u;
                part.force += f;
                part.power += (f - s.gravity).dot(u);
            }
        };
        Sums all;
        for (const Sums& part : in_fixed_ranges<Sums>(p.size(), add)) {
            all.momentum += part.momentum;
            all.force += part.force;
            all.power += part.power;
        }
        const double m = level->mass();
        sums.momentum += m * all.momentum;
        sums.force += m * all.force;
        sums.power += m * all.power;
    }
    return sums;
}

}  // namespace

void TankBalance::begin(const Simulation& simulation) {
    momentum_ = sums_of(simulation).momentum;
    impulse_ = Vec3::Zero();
    work_ = since_ = 0;
    time_ = simulation.time();
}

void TankBalance::after_step(const Simulation& simulation) {
    const double dt = simulation.time() - time_;
    const Sums now = sums_of(simulation);
    impulse_ += dt * now.force;
    work_ += dt * now.power;
    since_ += dt;
    time_ = simulation.time();
}

void TankBalance::record(const Simulation& simulation, Table& tank, const std::string& N, const std::string& J) {
    const Vec3 force = (impulse_ - (sums_of(simulation).momentum - momentum_)) / since_;
    const Column* before = tank.find(tank_work);
    const double work = (before && !before->values.empty() ? before->values.back() : 0) + work_;
    tank.time.push_back(simulation.time());
    for (int a = 0; a < 3; ++a) tank.column(fmt::format("f{}", "xyz"[a]), N).values.push_back(force[a] + 0.0);
    tank.column(tank_work, J).values.push_back(work);
    begin(simulation);
}

}  // namespace tw
