#include "scene/box/tank_wave.h"

#include <algorithm>
#include <cmath>
#include <numbers>

#include "scene/box/forcing_zones.h"
#include "scene/box/oblique_wave.h"
#include "waves/dispersion.h"

namespace tw {
namespace {

/// Of the energy, along the wave's direction over the scene's axes [m/s].
double group_speed(const RegularWave& wave) {
    return wave.group_speed_in_water() + wave.sum.direction * wave.sum.current;
}
double group_speed_in_water(const Sea& sea, double k, double omega) {
    return group_speed_ratio(k * sea.depth()) * omega / k;
}
double group_speed(const Sea& sea, double k, double omega) {
    return group_speed_in_water(sea, k, omega) + sea.waves.direction * sea.waves.stream;
}

}  // namespace

bool begins_in_zone(const Scene& scene) {
    return scene.hull || !scene.bodies.empty() || !scene.obstacles.empty() || !scene.wave_twin_of.empty();
}

bool begins_with_wave(const Scene& scene) { return scene.has_wave() && scene.motion.kind != Motion::Kind::stream; }

WaveScales wave_scales(const Scene& scene) {
    WaveScales w;
    if (scene.wave) {
        const RegularWave& wave = *scene.wave;
        w.direction = wave.sum.direction;
        w.height = wave.height;
        w.crest = wave.crest;
        w.length = w.longest = w.shortest = wave.length;
        w.period = wave.encounter_period();
        w.speed = wave.sum.speed;
        w.lowest_frequency = wave.encounter_frequency();
        w.slowest = group_speed(wave);
        w.comes_from_low_x = wave.sum.direction * w.slowest > 0;
        w.measured = 7 * w.period;
        if (runs_obliquely(scene)) {
            const Eigen::Vector2d energy = energy_velocity(scene);
            w.slowest = energy.norm();
            w.comes_from_low_x = energy.x() > 0;
            return w;
        }
        if (scene.motion.kind != Motion::Kind::stream || w.direction > 0) return w;
        const double in_water = wave.group_speed_in_water();
        w.slowest = std::abs(w.slowest);
        w.lowest_frequency = wave.k() * wave.speed_in_water * w.slowest / in_water;
        return w;
    }
    const Sea& sea = *scene.sea;
    const int low = sea.component_at(waves_that_count), high = sea.component_at(1 - waves_that_count);
    const bool focused = sea.kind == Sea::Kind::focused, two = sea.kind == Sea::Kind::bichromatic;
    double all = 0;
    for (int n = 0; n < sea.waves.count; ++n) all += sea.waves.height[n];
    const WaveComponents& all_of = sea.waves;
    w.direction = all_of.direction;
    w.comes_from_low_x = w.direction > 0;  // against a stream those alone are made whose energy passes it
    w.height = focused || two ? 2 * all : sea.significant_height;
    // the highest of a thousand crests of narrow spectra, sqrt(2 ln 1000) sqrt(m0) (Longuet-Higgins 1952)
    w.crest = focused || two ? all : 0.93 * sea.significant_height;
    w.length = sea.length_at_peak();
    w.period = sea.peak_period_met();
    w.speed = w.length / w.period;
    w.longest = sea.length(low);
    w.lowest_frequency = sea.met(low);
    w.shortest = sea.length(high);
    w.slowest = group_speed(sea, all_of.k[high], all_of.omega[high]);
    if (all_of.stream * w.direction < 0)
        w.lowest_frequency = all_of.omega[low] * group_speed(sea, all_of.k[low], all_of.omega[low]) /
                             group_speed_in_water(sea, all_of.k[low], all_of.omega[low]);
    w.measured = focused ? 4 * w.period : two ? 3 * sea.repeat_period : sea.repeat_period;
    return w;
}

TankWave::TankWave(const Scene& scene)
    : scene_(scene),
      depth_(scene.wave ? scene.wave->depth : scene.sea->depth()),
      low_(scene.domain.box.min.x()),
      high_(scene.domain.box.max.x()) {
    const ForcingZones plan = forcing_zones(scene);
    for (const ForcingZone& zone : plan.zones) {
        begin_[zone.makes_wave ? 0 : 1] = zone.begin;
        end_[zone.makes_wave ? 0 : 1] = zone.end;
    }
    in_zone_only_ = begins_in_zone(scene);
    if (scene.sea) sea_ = wave_moment(scene.sea->waves, 0);
    const auto steps = static_cast<std::size_t>(std::ceil((high_ - low_) / wave_scales(scene).shortest * 400));
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
    return (in_zone_only_ ? part : 1) * level_ + part * whole_surface(x);
}

double TankWave::whole_surface(double x) const {
    return scene_.wave ? wave_surface(scene_.wave->sum, x, 0) : wave_surface(scene_.sea->waves, x, 0);
}

Vec3 TankWave::velocity(double x, double z) const {
    double u, w;
    if (sea_)
        wave_velocity(*sea_, x, z, u, w);
    else
        wave_velocity(scene_.wave->sum, x, z, 0, u, w);
    return share(x) * Vec3(u, 0, w);
}

double TankWave::pressure_head(double x, double z) const {
    const double part = share(x);
    if (sea_) {  // above still water linear theory has none but that of the water above
        const Sea& sea = *scene_.sea;
        const double dynamic = sea.pressure_over_density(x, std::min(z, 0.0), 0) / sea.gravity - whole_surface(x);
        return std::max(0.0, surface(x) - z + part * dynamic);
    }
    const RegularWave& wave = *scene_.wave;
    const double eta = whole_surface(x), below = std::min(z, eta),
                 dynamic = wave.pressure_over_density(x, below, 0) / wave.gravity - (eta - below);
    return std::max(0.0, surface(x) - z + part * dynamic);
}

double TankWave::integral(double x) const {
    const double at = std::clamp((x - low_) / step_, 0.0, static_cast<double>(integral_.size() - 1));
    const auto i = std::min(static_cast<std::size_t>(at), integral_.size() - 2);
    const double part = at - static_cast<double>(i);
    return integral_[i] + part * (integral_[i + 1] - integral_[i]);
}

Vec3 TankWave::moved(const Vec3& at_rest) const {
    const double d = depth_, size = high_ - low_;
    double x = at_rest.x();
    for (int step = 0; step < 60; ++step) {  // x + integral(x)/d = x0; its slope is (d + eta)/d
        const double off = (x + integral(x) / d - at_rest.x()) / (1 + surface(x) / d);
        x = std::clamp(x - off, low_, high_);
        if (std::abs(off) < 1e-13 * size) break;
    }
    return {x, at_rest.y(), -d + (at_rest.z() + d) * (1 + surface(x) / d)};
}

double loss_by_artificial_viscosity(const Scene& scene, double distance) {
    double k, group;
    if (scene.wave) {
        k = scene.wave->k();
        group = runs_obliquely(scene) ? energy_velocity(scene).norm() : std::abs(group_speed(*scene.wave));
    } else {
        k = 2 * std::numbers::pi / scene.sea->length_at_peak();
        group = group_speed(*scene.sea, k, 2 * std::numbers::pi / scene.sea->peak_period);
    }
    const double h = scene.sph.h_over_dp * scene.resolution.near_hull,
                 nu = scene.sph.alpha * scene.sph.c0 * h / (scene.domain.dimensions == 2 ? 8 : 10);
    return 1 - std::exp(-2 * nu * k * k * distance / group);
}

}  // namespace tw
