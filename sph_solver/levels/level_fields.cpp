#include "sph_solver/levels/level_fields.h"

#include "base/numbers.h"
#include "sph_solver/equations/wall_pressure.h"

namespace tw {

double LevelFields::pressure(std::size_t i) const {
    const Particles& p = particles();
    const LevelSetup& s = system_.setup;
    return double(s.state_equation.pressure(s.rho0, p.drho[i])) +
           (system_.around.at_rest ? system_.around.at_rest->at(p.z[i]) : 0);
}

KindCounts LevelFields::kinds() const {
    const Particles& p = system_.particles;
    CountKinds kinds{p.kind.data(), p.x.data(), -infinite, infinite, nullptr};
    if (system_.around.stream) kinds.first = system_.around.domain.min.x(), kinds.last = system_.around.domain.max.x();
    return system_.ranks().sum(steps_->count(kinds));
}

double LevelFields::lid_pressure() const {
    struct Under {
        ExactSum pressure;
        std::int64_t count = 0;
        Under& operator+=(const Under& other) {
            pressure += other.pressure, count += other.count;
            return *this;
        }
    };
    const Particles& p = particles();
    const Under lid = sum_over_all<Under>([&](Under& sum, std::size_t i) {
        if (p.z[i] <= system_.around.domain.max.z() - system_.kernel.support()) return;
        sum.pressure += system_.setup.state_equation.pressure(system_.setup.rho0, p.drho[i]);
        ++sum.count;
    });
    return lid.count > 0 ? lid.pressure.value() / double(lid.count) : 0;
}

void LevelFields::sample(PointSamples& points) const {
    const std::size_t n = points.places.size();
    points.p.assign(n, 0);
    points.support.assign(n, 0);
    if (points.want_flux) points.flux.assign(6 * n, 0);
    if (n == 0) return;
    // whose pencils are those of the particles
    SortedPlaces sorted(points.places, 1, system_, share_.own_pencils());
    std::vector<float> p(n), support(n), flux(points.want_flux ? 6 * n : 0);
    ExtrapolateData e = system_.extrapolation();
    e.at = sorted.places.data();
    e.p = p.data();
    e.support = support.data();
    if (points.want_flux) {
        e.carried = system_.particles.carried.data();
        e.flux = flux.data();
        e.gx = e.gy = e.gz = 0;  // pairs carry the particles' own pressure
    }
    steps_->sample(sorted, e);
    const auto& at_rest = system_.around.at_rest;
    for (std::size_t k = 0; k < n; ++k) {
        const auto i = static_cast<std::size_t>(sorted.order[k]);
        points.p[i] = p[k];
        points.support[i] = support[k];
        if (at_rest && !points.want_flux && support[k] > WallPressure::least_support)
            points.p[i] += static_cast<float>(at_rest->at(points.places[i].z()));
        for (std::size_t a = 0; a < 6 && points.want_flux; ++a) points.flux[6 * i + a] = flux[6 * k + a];
    }
    share_.exchange_samples(points);
}

}  // namespace tw
