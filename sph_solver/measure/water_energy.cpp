#include "sph_solver/measure/water_energy.h"

#include "base/exact_sum.h"

namespace tw {
namespace {

/// Of a level's particles, each counted once.
struct Sums {
    std::int64_t count = 0;
    ExactSum speed2, height, deviation2;  ///< [m2/s2], [m], [kg2/m6]

    Sums& operator+=(const Sums& other) {
        count += other.count;
        speed2 += other.speed2, height += other.height, deviation2 += other.deviation2;
        return *this;
    }
};

}  // namespace

WaterEnergy water_energy(const Simulation& simulation) {
    const SimulationSetup& s = simulation.setup();
    const double of_deviation = s.state_equation.c0 / s.rho0;
    WaterEnergy energy;
    for (const auto& level : simulation.water()) {
        const Particles& p = level->fields().particles();
        const Sums sums = level->fields().sum_over_all<Sums>([&](Sums& sum, std::size_t i) {
            if (p.kind[i] != Kind::fluid) return;
            ++sum.count;
            sum.speed2 += double(p.u[i]) * p.u[i] + double(p.v[i]) * p.v[i] + double(p.w[i]) * p.w[i];
            sum.height += p.z[i];
            sum.deviation2 += double(p.drho[i]) * p.drho[i];
        });
        const double m = level->system().mass;
        energy.mass += m * double(sums.count);
        energy.kinetic += 0.5 * m * sums.speed2.value();
        energy.potential -= m * s.gravity.z() * sums.height.value();
        energy.elastic += 0.5 * m * of_deviation * of_deviation * sums.deviation2.value();
    }
    return energy;
}

}  // namespace tw
