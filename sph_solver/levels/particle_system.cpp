#include "sph_solver/levels/particle_system.h"

#include <algorithm>
#include <bit>
#include <cmath>

#include <fmt/format.h>

#include "sph_solver/effects/effects.h"
#include "sph_solver/equations/water_completeness.h"

namespace tw {

namespace {

FixedPoint fixed_point_of(const Surroundings& around, double dp) {
    Vec3 middle = (around.domain.min + around.domain.max) / 2;
    if (around.dimensions == 2) middle.y() = 0;
    return FixedPoint(middle, dp / (1 << 18));
}

/// The pencils cover the domain, its mirror images and the buffers of the stream.
Box pencil_area(const Surroundings& around, double support, double dp) {
    Box area = around.domain;
    area.min.array() -= support + dp;
    area.max.array() += support + dp;
    if (around.stream) {
        area.min.x() -= around.stream->buffer;
        area.max.x() += around.stream->buffer;
    }
    return area;
}

}  // namespace

ParticleSystem::ParticleSystem(const Surroundings& surroundings, LevelSetup material, const EffectOptions& options,
                               const Bodies& all_bodies, const Passes& variant, const Fluid& fluid)
    : around(surroundings),
      setup(std::move(material)),
      bodies(all_bodies),
      passes(variant),
      h(setup.h_over_dp * setup.dp),
      mass(setup.rho0 * (fluid.volume > 0 ? fluid.volume : std::pow(setup.dp, around.dimensions))),
      kernel(h, around.dimensions),
      given_back(static_cast<float>(WaterCompleteness::of_plane_surface(kernel, setup.dp, around.dimensions))),
      fixed_point(fixed_point_of(around, setup.dp)),
      grid(pencil_area(around, kernel.support(), setup.dp), setup.dp, around.dimensions, fixed_point, passes.lanes),
      ghosts(around, setup, fixed_point),
      walls(bodies, around, setup, kernel.support(), grid, fixed_point, passes.lanes) {
    for (const EffectOn& on : options) particles.allocate(effects.emplace_back(on.make())->brings());
    if (!walls.empty()) {
        particles.allocate(With::walls);
        if (walls.move()) particles.allocate(With::moving_bodies);
        if (walls.any_deformable()) particles.allocate(With::elastic_bodies);
    }
    if (inlet_has_wave() && around.stream->wave->is_sum()) particles.allocate(With::sea_at_inlet);
    particles.reserve(fluid.places.size());
    for (std::size_t k = 0; k < fluid.places.size(); ++k) {
        const Vec3& p = fluid.places[k];
        const double depth_pressure =
            around.at_rest ? around.at_rest->carried(p.z()) : setup.rho0 * around.gravity.norm() * fluid.depth[k];
        const Kind kind = around.stream && p.x() < around.domain.min.x()   ? Kind::inlet
                          : around.stream && p.x() > around.domain.max.x() ? Kind::outlet
                                                                           : Kind::fluid;
        particles.add(p.x(), p.y(), p.z(),
                      static_cast<float>(stream_velocity(0) * (around.stream ? around.stream->share_at(p.x()) : 1)),
                      setup.state_equation.deviation_of_lattice(setup.rho0, depth_pressure), ledger.next_id++, kind);
        if (particles.has(With::sea_at_inlet)) particles.calm_height.back() = static_cast<float>(p.z());
    }
    ledger.next_id = ranks().sum(ledger.next_id);  // the first rank has all
    for (std::size_t i = 0; i < fluid.velocity.size(); ++i) {
        const Eigen::Vector3f u = fluid.velocity[i].cast<float>();
        particles.u[i] = u.x(), particles.v[i] = u.y(), particles.w[i] = u.z();
    }
    if (!around.frame) return;
    const Eigen::Vector3f u = around.frame->velocity_of_rest().cast<float>();
    for (std::size_t i = 0; i < particles.size(); ++i)
        particles.u[i] = u.x(), particles.v[i] = u.y(), particles.w[i] = u.z();
}

WaterView ParticleSystem::water_view() const {
    const Particles& r = particles;
    const bool of_one_kind = !particles.has(With::coarser) && !particles.has(With::finer) && !around.stream;
    return {.list = near.lists.view(),
            .place = r.place.data(),
            .motion = r.velocity_density.data(),
            .stress = r.gradient_pressure.data(),
            .surface = r.surface.data(),
            .kind = of_one_kind ? nullptr : particles.kind.data(),
            .kernel = kernel,
            .unit = static_cast<float>(fixed_point.size),
            .rho0 = static_cast<float>(setup.rho0),
            .inv_mass = static_cast<float>(1 / mass),
            .two_dimensional = around.dimensions == 2};
}

WallView ParticleSystem::wall_view() const {
    return {.list = walls.lists(),
            .place = walls.places().data(),
            .p = walls.pressures().data(),
            .velocity = walls.velocities(),
            .body_end = walls.body_end().data(),
            .bodies = static_cast<int>(walls.body_end().size()),
            .normal = particles.wall_normal.data()};
}

FirstPairLoopData ParticleSystem::first_pair_loop_data() {
    Particles& r = particles;
    return {.water = water_view(),
            .walls = wall_view(),
            .stress = r.gradient_pressure.data(),
            .shift = r.shift_support.data(),
            .rate = r.rate.data(),
            .carried = r.carried.empty() ? nullptr : r.carried.data(),
            .inv_W_dp = inv_W_dp(),
            .fastest_shift = static_cast<float>(setup.state_equation.c0 / 10),
            .inv_dp = static_cast<float>(1 / setup.dp),
            .inv_void = static_cast<float>(1 / (1 - setup.touch_support)),
            .surface_support = static_cast<float>(setup.surface_support),
            .given_back = given_back};
}

SecondPairLoopData ParticleSystem::second_pair_loop_data(double t) {
    const LevelSetup& s = setup;
    const double stream_acceleration = around.stream ? around.stream->acceleration(t) : 0;
    return {.water = water_view(),
            .walls = wall_view(),
            .leaving = particles.wall_leaving.data(),
            .since_walls = static_cast<float>(near.life.since_walls),
            .shift = particles.shift_support.data(),
            .rate = particles.rate.data(),
            .wall_load = walls.cluster_loads().data(),
            .diffusion = static_cast<float>(s.delta * s.state_equation.c0),
            .packing = s.shifting > 0 ? static_cast<float>(s.packing * s.state_equation.c0 / h * s.rho0) : 0,
            .packing_reach = static_cast<float>(kernel.support() - s.dp / 2),
            .viscosity = artificial_viscosity(),
            .gx = static_cast<float>(around.weight().x() + stream_acceleration),
            .gy = static_cast<float>(around.weight().y()),
            .gz = static_cast<float>(around.weight().z()),
            .tension_control_from = tension_control_from()};
}

AfterFirstPairLoop ParticleSystem::after_first_pair_loop(const FieldsView& f, double compress, double drift) const {
    return {.p = state_of(f),
            .to_fixed_point = to_fixed_point(),
            .kind = f.kind,
            .rate = f.rate,
            .shift = f.shift_support,
            .aired = f.aired,
            .place = f.place,
            .motion = f.velocity_density,
            .stress = f.gradient_pressure,
            .wall = f.wall_normal,
            .compress = compress,
            .drift = drift,
            .surface_support = setup.surface_support,
            .trend = f.trend,
            .compression = f.compression,
            .density_rate = f.density_rate};
}

ExtrapolateData ParticleSystem::extrapolation() const {
    ExtrapolateData e;
    e.water = water_view();
    e.gx = static_cast<float>(around.weight().x());
    e.gy = static_cast<float>(around.weight().y());
    e.gz = static_cast<float>(around.weight().z());
    return e;
}

InterpolateData ParticleSystem::interpolation() const {
    const Eigen::Vector3f slope =
        (setup.rho0 / (setup.state_equation.c0 * setup.state_equation.c0) * around.gravity).cast<float>();
    InterpolateData d;
    d.water.kernel = Kernel(interpolation_h_over_dp * setup.dp, around.dimensions);
    d.water.unit = static_cast<float>(fixed_point.size);
    d.gx = slope.x(), d.gy = slope.y(), d.gz = slope.z();
    d.water.two_dimensional = around.dimensions == 2;
    return d;
}

TakeGiving ParticleSystem::giving(const FieldsView& f, const Link* links, std::size_t n, const Asking& asking) const {
    return {.place = f.place,
            .motion = f.velocity_density,
            .shift = f.shift_support,
            .density_rate = f.density_rate,
            .kind = f.kind,
            .links = links,
            .n = n,
            .of = asking.of,
            .density_before = asking.density_before,
            .without = asking.without ? *asking.without : SurfaceExcess(),
            .row = density_of_row(),
            .to_place = nullptr,
            .to_motion = nullptr,
            .known_support = nullptr,
            .rate = nullptr};
}

StepView ParticleSystem::step_view(double t, const Halo& halo) {
    Particles& p = particles;
    StepView view{.around = around,
                  .level = setup,
                  .n = p.size(),
                  .images = ghosts.count(),
                  .p = state_view(),
                  .kind = p.kind.data(),
                  .fields = p.view(),
                  .shift = p.shift_support.data(),
                  .water = water_view(),
                  .dummies = {},
                  .stress = p.gradient_pressure.data(),
                  .rate = p.rate.data(),
                  .passes = passes,
                  .clusters = near.clusters,
                  .bodies = {},
                  .dummy_count = walls.size(),
                  .sliding = walls.sliding().empty() ? nullptr : walls.sliding().data(),
                  .wall_load_count = walls.cluster_load_count(),
                  .links = ghosts.links().data(),
                  .maps = ghosts.maps().data(),
                  .ranks = ranks(),
                  .halo = halo,
                  .dummies_halo = walls.halo(),
                  .h = h,
                  .mass = mass,
                  .time = t};
    if (walls.empty()) return view;
    view.dummies = wall_view();
    for (const Walls::Part& part : walls.parts())
        view.bodies.push_back({part.first, part.water.view(), part.near_water});
    return view;
}

double ParticleSystem::slack_of_lists() const {
    // Edges between sizes are mended, and some walls found, when lists are made: that must not be long ago.
    const bool old_walls = !walls.empty() && !walls.found_at_every_step();
    if (particles.has(With::coarser) || particles.has(With::finer) || old_walls)
        return ListLife::least_slack_over_dp * setup.dp;
    return ListLife::slack_for(setup.dp, 2 * dt * near.life.relative_speed, dt * (extremes.speed + walls.fastest()));
}

ParticleSystem::ReachesOfLists ParticleSystem::reaches_of_lists(double drift) const {
    const double support = kernel.support();
    const auto reaches = [&](double now, double slack) {
        return Reaches{std::max(support + slack, now), now, support - slack};
    };
    return {reaches(reach_among(drift), near.life.slack),
            reaches(reach_to_walls(drift), ListLife::wall_slack_over_dp * setup.dp)};
}

Reaches ParticleSystem::reaches_of_interpolation() const {
    return reaches_of_points(Kernel(interpolation_h_over_dp * setup.dp, around.dimensions));
}

Reaches ParticleSystem::reaches_of_points(const Kernel& of) const {
    const double support = of.support();
    return {support, support, support, near.life.travel + 0.1 * setup.dp};
}

double ParticleSystem::reach_of_others() const {
    if (!particles.has(With::coarser) && !particles.has(With::finer)) return 0;
    return Kernel(interpolation_h_over_dp * setup.dp, around.dimensions).support() +
           ListLife::wall_slack_over_dp * setup.dp;
}

Vec3 ParticleSystem::body_force() const {
    return around.weight() + Vec3(around.stream ? around.stream->acceleration(time) : 0, 0, 0);
}

double ParticleSystem::density_of_row() const {
    const double c0 = setup.state_equation.c0;
    return setup.rho0 * around.gravity.norm() * setup.dp / (c0 * c0);
}

std::int64_t ParticleSystem::live_pairs(const Cluster& g) const {
    std::int64_t live = 0;
    const auto count = [&](const Lists& lists, const ListRef& list) {
        const NeighbourBlock* blocks = lists.blocks(list);
        for (std::int32_t k = 0; k < list.size; ++k) live += std::popcount(blocks[k].live);
    };
    count(near.lists.view(), g.list);
    count(walls.lists(), g.wall_list);
    return live;
}

std::string ParticleSystem::text_of_failure(std::size_t i, const std::string& what) const {
    const Particles& p = particles;
    return fmt::format("{} particle {} at t = {:.6g} s (step {}) near ({:.4g}, {:.4g}, {:.4g}) m, |u| = {:.4g} m/s, {}",
                       setup.material, p.id[i], time, steps, p.x[i], p.y[i], p.z[i],
                       std::sqrt(double(p.u[i]) * p.u[i] + double(p.v[i]) * p.v[i] + double(p.w[i]) * p.w[i]), what);
}

double ParticleSystem::bytes() const {
    double sum = double(near.lists.bytes() + walls.bytes() + ghosts.bytes() + particles.bytes());
    sum += double(near.clusters.capacity() * sizeof(Cluster));
    for (const auto& effect : effects) sum += double(effect->bytes());
    return sum;
}

}  // namespace tw
