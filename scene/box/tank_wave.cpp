#include "scene/box/tank_wave.h"

#include <algorithm>
#include <cmath>

#include "scene/box/forcing_zones.h"
#include "waves/dispersion.h"

namespace tw {

TankWave::TankWave(const Scene& scene)
    : wave_(*scene.wave), low_(scene.domain.box.min.x()), high_(scene.domain.box.max.x()) {
    const ForcingZones plan = forcing_zones(scene);
    for (const ForcingZone& zone : plan.zones) {
        begin_[zone.makes_wave ? 0 : 1] = zone.begin;
        end_[zone.makes_wave ? 0 : 1] = zone.end;
    }
    in_zone_only_ = scene.hull || !scene.bodies.empty() || !scene.obstacles.empty();
    const auto steps = static_cast<std::size_t>(std::ceil((high_ - low_) / wave_.length * 400));
    step_ = (high_ - low_) / static_cast<double>(steps);
    const auto middle = [&](std::size_t i) { return low_ + (static_cast<double>(i) + 0.5) * step_; };
    double raised = 0, room = 0;
    for (std::size_t i = 0; i < steps; ++i) {
        raised += step_ * surface(middle(i));  // level_ is still 0
        room += step_ * (in_zone_only_ ? share(middle(i)) : 1);
    }
    level_ = -raised / room;
    integral_.assign(steps + 1, 0);
    for (std::size_t i = 0; i < steps; ++i) integral_[i + 1] = integral_[i] + step_ * surface(middle(i));
}

double TankWave::share(double x) const {
    const int zone = in_zone_only_ ? 0 : 1;
    const double s = std::clamp((x - begin_[zone]) / (end_[zone] - begin_[zone]), 0.0, 1.0);
    return in_zone_only_ ? s * s * (3 - 2 * s) : 1 - s * s;
}

double TankWave::surface(double x) const {
    const double part = share(x);
    return (in_zone_only_ ? part : 1) * level_ + part * wave_surface(wave_.sum, x, 0);
}

Vec3 TankWave::velocity(double x, double z) const {
    double u, w;
    wave_velocity(wave_.sum, x, z, 0, u, w);
    return share(x) * Vec3(u, 0, w);
}

double TankWave::pressure_head(double x, double z) const {
    const double part = share(x), eta = wave_surface(wave_.sum, x, 0),
                 dynamic =
                     wave_.pressure_over_density(x, std::min(z, eta), 0) / wave_.gravity - (eta - std::min(z, eta));
    return std::max(0.0, surface(x) - z + part * dynamic);
}

double TankWave::integral(double x) const {
    const double at = std::clamp((x - low_) / step_, 0.0, static_cast<double>(integral_.size() - 1));
    const auto i = std::min(static_cast<std::size_t>(at), integral_.size() - 2);
    const double part = at - static_cast<double>(i);
    return integral_[i] + part * (integral_[i + 1] - integral_[i]);
}

Vec3 TankWave::moved(const Vec3& at_rest) const {
    const double d = wave_.depth;
    double x = at_rest.x();
    for (int step = 0; step < 60; ++step) {  // x + integral(x)/d = x0; its slope is (d + eta)/d
        const double off = (x + integral(x) / d - at_rest.x()) / (1 + surface(x) / d);
        x = std::clamp(x - off, low_, high_);
        if (std::abs(off) < 1e-12 * wave_.length) break;
    }
    return {x, at_rest.y(), -d + (at_rest.z() + d) * (1 + surface(x) / d)};
}

double loss_by_artificial_viscosity(const Scene& scene, double distance) {
    const RegularWave& wave = *scene.wave;
    const double k = wave.k(), h = scene.sph.h_over_dp * scene.resolution.near_hull,
                 nu = scene.sph.alpha * scene.sph.c0 * h / (scene.domain.dimensions == 2 ? 8 : 10),
                 group = group_speed_ratio(k * wave.depth) * wave.sum.speed;
    return 1 - std::exp(-2 * nu * k * k * distance / group);
}

}  // namespace tw
