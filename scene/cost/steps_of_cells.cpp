#include "scene/cost/steps_of_cells.h"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <vector>

#include "meshes/mass_properties.h"
#include "scene/box/tank_wave.h"
#include "scene/defaults.h"
#include "scene/mesh/mesh_cells.h"
#include "scene/mesh/step_limits.h"
#include "scene/water/quiet_layer.h"

namespace tw {
namespace {

bool stands_over(const Surface& solid, double x, double y, bool flat) {
    const Box b = solid.bounds();
    return x > b.min.x() && x < b.max.x() && (flat || (y > b.min.y() && y < b.max.y()));
}

/// The front of the deepest water of a tank over the shallowest, or over dry floor: its speed [m/s], 0 where all is
/// level, and the time in which it gets it, sqrt(h/g)/2 [s].
struct Front {
    double speed = 0, grows_in = 1;
    double at(double time) const { return speed * -std::expm1(-time / grows_in); }
};
Front fastest_front(const Scene& scene) {
    if (scene.water_blocks.empty()) return {};
    const Box& tank = scene.domain.box;
    const bool flat = scene.domain.dimensions == 2;
    constexpr int along = 64;
    const int across = flat ? 1 : along;
    double deep = 0, shallow = HUGE_VAL;
    for (int i = 0; i < along; ++i)
        for (int j = 0; j < across; ++j) {
            const double x = tank.min.x() + (i + 0.5) / along * tank.size().x(),
                         y = tank.min.y() + (j + 0.5) / across * tank.size().y();
            if (std::ranges::any_of(scene.obstacles,
                                    [&](const Obstacle& o) { return stands_over(o.surface, x, y, flat); }) ||
                std::ranges::any_of(scene.bodies,
                                    [&](const MovingBody& b) { return stands_over(b.surface, x, y, flat); }))
                continue;
            double depth = 0;
            for (const Box& block : scene.water_blocks)
                if (x > block.min.x() && x < block.max.x() && (flat || (y > block.min.y() && y < block.max.y())))
                    depth = std::max(depth, block.max.z() - tank.min.z());
            deep = std::max(deep, depth), shallow = std::min(shallow, depth);
        }
    const double g = scene.water.gravity;
    if (!(deep > shallow) || !(g > 0)) return {};
    return {2 * (std::sqrt(g * deep) - std::sqrt(g * shallow)), std::sqrt(deep / g) / 2};
}

double level_of(const Scene& scene) {
    double level = scene.water_blocks.empty() ? 0 : -HUGE_VAL;
    for (const Box& block : scene.water_blocks) level = std::max(level, block.max.z());
    return level;
}

/// How a body goes through air and water, roughly: speeds at even times, and what its jets have run at the end.
///
///   d/dt ((m + m_a) V) = m g - rho g vol(z) - D(V),   m_a = rho pi/8 (2 c)^2 l,   dc/dt = pi/2 V b/rise up to c = b
///
/// with V down, c the half width that is wet and D(V) the drag of slow_body once all of the width is.
constexpr std::size_t even_times = 1000;
struct Way {
    std::vector<double> speed = std::vector<double>(even_times);  ///< [m/s]
    double jet = 0;                                               ///< [m]
};
Way way_of(const MovingBody& body, const Scene& scene) {
    Way way;
    const Box box = body.surface.bounds();
    const Vec3 size = box.size(), start = body.motion.velocity;
    const double level = level_of(scene), g = scene.water.gravity, rho = scene.water.density,
                 dt = scene.run.duration / even_times;
    if (body.motion.law || body.elastic) {
        std::ranges::fill(way.speed, body.motion.law ? body.fastest(g) : start.norm());
        return way;
    }
    const bool flat = scene.domain.dimensions == 2, falls = body.motion.free.along[2];
    const double m = body.motion.mass.mass, half_width = (flat ? size.x() : std::min(size.x(), size.y())) / 2,
                 along = flat ? 1 : std::max(size.x(), size.y()), volume = mass_properties(body.surface).volume;
    const BodyDrag drag = drag_of(scene, body);
    // The bottom's rise, from its lowest point to where it is widest.
    double widest = 0, rise = size.z();
    for (const Vec3& p : body.surface.points) {
        const double off = std::abs(p.x() - (box.min.x() + box.max.x()) / 2), up = p.z() - box.min.z();
        if (off > widest * (1 + 1e-6)) widest = off, rise = up;
        if (off > widest * (1 - 1e-6)) rise = std::min(rise, up);
    }
    const double aside = start.head<2>().norm();
    double low = box.min.z(), V = -start.z(), c = low < level ? half_width : 0;
    const auto added = [&] { return rho * std::numbers::pi / 8 * 4 * c * c * along; };
    for (double& speed : way.speed) {
        const double momentum = (m + added()) * V, wet = std::clamp((level - low) / size.z(), 0.0, 1.0);
        if (wet > 0 && V > 0 && c < half_width) {
            const double before = c;
            c = rise > 0 ? std::min(half_width, c + dt * std::numbers::pi / 2 * V * half_width / rise) : half_width;
            way.jet += 2 * (c - before);
        }
        const double D = c < half_width ? 0 : drag.viscous * V + drag.inertial * V * std::abs(V);
        // implicit in the drag, which may be stiff
        const double force = falls ? m * g - rho * g * volume * wet : 0, M = m + added();
        V = (momentum + dt * force) / (M + (V != 0 ? dt * D / V : 0));
        low -= dt * V;
        speed = std::hypot(V, aside);
    }
    return way;
}

/// Until when the steps of bodies that are let go at rest are those of the release [s]; 0: there are none. Each of the
/// case's limits is twice the one before it, and OpenFOAM divides what is left until the next of them into equal steps
/// of which none is a fifth longer than the last: the steps do not grow before the last limit has ended.
double end_of_release(const Scene& scene, double cell) {
    const double g = scene.water.gravity, crossing = std::sqrt(2 * cell / g);
    const auto rests = [&](const MovingBody& b) {
        const double speed = b.motion.velocity.norm() + b.motion.spin.norm() * b.surface.bounds().size().norm();
        return !b.motion.law && speed * crossing <= cell;
    };
    if (scene.bodies.empty() || !(g > 0) || !std::ranges::all_of(scene.bodies, rests)) return 0;
    double end = 0;
    for (double step = release_step(cell, g); step < longest_step_of_still_water(cell, g); step *= 2)
        end = 2 * steps_of_release * step;
    return end;
}

}  // namespace

double speed_of_crests(const Scene& scene) {
    if (scene.wave)
        return std::numbers::pi * scene.wave->height / scene.wave->period_in_water() /
               std::tanh(scene.wave->k() * scene.wave->depth);
    if (!scene.sea) return 0;
    const WaveScales wave = wave_scales(scene);
    return 2 * std::numbers::pi * wave.crest / scene.sea->peak_period /
           std::tanh(2 * std::numbers::pi / wave.length * scene.sea->depth());
}

double steps_of_cells_in_tank(const Scene& scene, double crossings) {
    const double a = finest_cell(scene), g = scene.water.gravity, T = scene.run.duration;
    const double per_metre = 1 / (a * std::min(scene.fvm.max_courant, scene.fvm.max_alpha_courant));
    const double falls = std::sqrt(2 * std::abs(g) * scene.domain.box.size().z());
    double driven = falls + fastest_wall(scene), jets = 0;
    std::vector<Way> ways;
    for (const MovingBody& body : scene.bodies) {
        ways.push_back(way_of(body, scene));
        jets = std::max(jets, ways.back().jet), driven = std::max(driven, body.fastest(g));
    }
    const Front front = fastest_front(scene);
    double rest = crossings * std::max(speed_of_crests(scene), fastest_wall(scene)) * per_metre;
    if (g > 0) rest = std::max(rest, 1 / longest_step_of_still_water(a, g));
    const double release = end_of_release(scene, a);
    double rate = 0;  // the mean
    for (std::size_t k = 0; k < even_times; ++k) {
        const double time = (static_cast<double>(k) + 0.5) * T / even_times;
        double now = time < release ? std::max(rest, 1 / release_step(a, g)) : rest;
        now = std::max(now, front.at(time) * per_metre);
        for (const Way& way : ways) now = std::max(now, crossings * way.speed[k] * per_metre);
        rate += now / even_times;
    }
    if (!(rate > 0)) return 1;
    // 1.2^n from a twentieth of a cell on: the last six of them take as long as one of the longest
    const double first = 0.05 * a / std::max(driven, 1e-6), growth = std::log(1.2),
                 growing = std::log(1 / (rate * first)) / growth, most = std::log1p(0.2 * T / first) / growth;
    return std::min(T * rate + std::max(0.0, growing - 6), std::max(T * rate, most)) + jets * per_metre;
}

}  // namespace tw
