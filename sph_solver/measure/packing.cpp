#include "sph_solver/measure/packing.h"

#include <limits>

#include "base/exact_sum.h"

namespace tw {
namespace {

constexpr double inside_from = 0.95;  ///< S of a particle that no free surface is near [-]

/// By the densities, and by the places, over those of particles of density rho0 [-].
struct Volumes {
    ExactSum by_density, by_packing;

    Volumes& operator+=(const Volumes& other) {
        by_density += other.by_density, by_packing += other.by_packing;
        return *this;
    }
};

}  // namespace

double crowding(const Simulation& simulation) {
    double by_density = 0, by_packing = 0;
    for (const auto& level : simulation.water()) {
        const Particles& p = level->fields().particles();
        const double rho0 = level->system().setup.rho0;
        const Volumes sums = level->fields().sum_over_all<Volumes>([&](Volumes& sum, std::size_t i) {
            if (p.kind[i] != Kind::fluid || p.shift_support.empty())
                return;  // all ranks sum, with particles or without
            const double S = double(p.shift_support[i].support);
            if (!(S > inside_from)) return;
            const double V = rho0 / (rho0 + double(p.drho[i]));
            sum.by_density += V;
            sum.by_packing += V / S;
        });
        by_density += level->system().mass * sums.by_density.value(),
            by_packing += level->system().mass * sums.by_packing.value();
    }
    return by_density > 0 ? 1 - by_packing / by_density : std::numeric_limits<double>::quiet_NaN();
}

}  // namespace tw
