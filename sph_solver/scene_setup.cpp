#include "sph_solver/scene_setup.h"

#include <algorithm>
#include <cmath>
#include <memory>

#include "base/errors.h"
#include "meshes/mass_properties.h"
#include "meshes/section.h"
#include "scene/box/inlet_wave.h"
#include "scene/box/tank_walls.h"
#include "scene/box/tank_wave.h"
#include "scene/new_record.h"
#include "scene/particles/particle_levels.h"
#include "scene/refined_places.h"
#include "scene/solids/walls_met.h"
#include "scene/water/quiet_layer.h"
#include "scene/water/tailwater.h"
#include "scene/water/water_blocks.h"
#include "sph_solver/bodies/elastic/elastic_setup.h"
#include "sph_solver/effects/effects.h"
#include "sph_solver/equations/packing.h"
#include "sph_solver/fit_solids.h"
#include "sph_solver/start_pressure.h"
#include "structure/tyre_static.h"

namespace tw {

namespace {

bool is_mirror(Side side) { return side == Side::slip_wall || side == Side::symmetry; }

/// Clear of the wet hull by half a beam below and beside it (a section: a quarter of its length; at least six
/// spacings), a quarter of its length ahead and as far behind as half of that, and open above. In two dimensions round
/// the whole section, because the jet under a plate wets it far ahead of still water; one metre of span, as what
/// particles carry. With several sizes of particles within the zone of those at the hull. Round the whole of a hull
/// that is free: it may dip all of its length, and moves within the box; as its zone goes with it, the box leaves it
/// some way to go.
ControlVolume control_volume(const Scene& scene, const SimulationSetup& s) {
    const Hull& hull = *scene.hull;
    const double dp = scene.resolution.near_hull;
    const Zone* zone = s.zones.size() > s.partial_zones ? &s.zones[s.zones.size() - s.partial_zones - 1] : nullptr;
    const double near = std::max(6 * dp, hull.section ? 0.25 * hull.length : 0.5 * hull.beam);
    const auto on_lattice = [&](double x) { return std::round(x / dp) * dp; };
    Box box = hull.section || hull.free ? hull.surface.bounds() : hull.still.wet_bounds;
    box.min -= Vec3(std::max(near, 0.25 * hull.length), near, near);
    box.max += Vec3(std::max(near, 0.125 * hull.length), near, 0);
    const double clear = 2 * dp;  // of the domain's sides
    // How far the zone of a free hull may go before the box is outside: what the hull has from its zone's edge to the
    // six spacings at which the run ends (bodies/collisions.cpp), less half of one. At most three: chosen, not derived.
    const double way = hull.free ? std::clamp(zone_width(scene) / dp - (6 + 0.5), 0.0, 3.0) * dp : 0;
    box.min = box.min.cwiseMax(s.domain.min + Vec3::Constant(clear));
    box.max = box.max.cwiseMin(s.domain.max - Vec3::Constant(clear));
    if (zone) {
        const Box& round_hull = zone->boxes().front();
        box.min = box.min.cwiseMax(round_hull.min + Vec3::Constant(2 * clear + way));
        box.max = box.max.cwiseMin(round_hull.max - Vec3::Constant(2 * clear + way));
    }
    for (int a = 0; a < 3; ++a) {
        box.min[a] = on_lattice(box.min[a]);
        box.max[a] = on_lattice(box.max[a]);
    }
    if (hull.half) box.min.y() = s.domain.min.y();
    if (hull.section) box.min.y() = -0.5, box.max.y() = 0.5;
    box.max.z() = s.domain.max.z();
    ControlVolume::Shape shape{s.dimensions, hull.half};
    const double inside = 2 * dp + way;  // of the zone's edge, so that no particle changes its kind within
    if (zone && zone->follows_surface()) shape.takes = [&](const Vec3& x) { return zone->outside(x) < -inside; };
    return ControlVolume(box, dp, shape);
}

/// A solid that stands flush against a mirror plane goes on through it, as a hull does through its plane of symmetry.
/// Else no dummies stand beyond the plane, and the water creeps in between the plane and the solid's face on it.
Surface through_mirrors(Surface surface, const SimulationSetup& s, double coarsest_dp) {
    const double flush = 1e-6 * s.domain.size().maxCoeff(), through = 4 * coarsest_dp;
    for (Vec3& p : surface.points)
        for (int a = 0; a < 3; ++a) {
            if (s.mirrors.on[static_cast<std::size_t>(a)][0] && std::abs(p[a] - s.domain.min[a]) < flush)
                p[a] -= through;
            else if (s.mirrors.on[static_cast<std::size_t>(a)][1] && std::abs(p[a] - s.domain.max[a]) < flush)
                p[a] += through;
        }
    return surface;
}

/// Of a free body with the walls of its tank; a section meets them in its plane.
std::optional<WallContact> wall_contact(const MovingBody& body, const Scene& scene) {
    std::vector<WallPlane> walls;
    for (const MetWall& wall : walls_met(body, scene)) walls.push_back(wall.plane);
    if (walls.empty()) return {};
    std::vector<Vec3> corners = body.surface.points;
    if (scene.domain.dimensions == 2)
        for (Vec3& corner : corners) corner.y() = 0;
    return WallContact(std::move(corners), std::move(walls), body.friction);
}

ElasticSetup elastic_setup(const ElasticPlate& plate) {
    structure::Shell shell = shell_of(plate, plate.strip());
    structure::DegreesOfFreedom dofs = dofs_of(plate, shell, plate.strip());
    ElasticSetup s{
        .structure =
            ElasticShell{.shell = std::move(shell), .skin = plate.skin, .large_rotations = plate.large_rotations},
        .dofs = std::move(dofs)};
    s.width = plate.two_dimensional() ? plate.strip() : 0;
    s.coupling = {.interface = interface_of(plate), .iterations = plate.coupling_iterations};
    s.damping = plate.damping;
    s.largest_step = plate.largest_step;
    s.velocity = plate.velocity;
    for (const ElasticGauge& g : plate.gauges)
        if (g.direction)
            s.gauges.push_back({g.name, g.position, *g.direction, g.top});
        else
            s.points.push_back({g.name, g.position});
    return s;
}

/// The tyre meets its floor one spacing above that of the tank: water under it is a particle thick, and could not leave
/// a narrower gap (decision 038).
ElasticSetup elastic_setup(const ElasticTyre& tyre, double floor) {
    structure::Solid solid = solid_of(tyre);
    structure::DegreesOfFreedom dofs = dofs_of(tyre, solid);
    ElasticSetup s{.structure = ElasticSolid{.solid = std::move(solid),
                                             .wet = "outside",
                                             .start = structure::blown_up(tyre.shape, tyre.rubbers(), tyre.pressure),
                                             .pressed = "inside",
                                             .pressure = tyre.pressure,
                                             .floor = FloorContact{floor, tyre.contact_stiffness()}},
                   .dofs = std::move(dofs)};
    s.damping = tyre.damping;
    s.largest_step = tyre.largest_step;
    s.velocity = tyre.velocity;
    for (const ElasticGauge& g : tyre.gauges) s.points.push_back({g.name, g.position});
    return s;
}

/// Of a solid, in two dimensions of a metre of its section.
Surroundings::Submerged submerged(const Surface& solid, bool flat) {
    const Surface all = flat ? section_prism(solid) : solid;
    const MassProperties whole = mass_properties(all);
    Surroundings::Submerged s{whole.volume, whole.centroid, 0};
    for (const Vec3& p : all.points) {
        Vec3 arm = p - whole.centroid;
        if (flat) arm.y() = 0;
        s.radius = std::max(s.radius, arm.norm());
    }
    return s;
}

/// Effect dynamic_pressure. What water at rest keeps of its pressure is that of one spacing: it is to stay above zero
/// behind a body.
void take_rest_pressure(const Scene& scene, SimulationSetup& s) {
    const QuietLayer layer = quiet_layer(scene);
    const double weight = scene.water.density * scene.water.gravity;
    s.at_rest = {layer.surface, layer.top, layer.bottom, weight, weight * scene.resolution.near_hull};
    for (const Obstacle& o : scene.obstacles) s.submerged.push_back(submerged(o.surface, s.dimensions == 2));
    for (const MovingBody& b : scene.bodies) s.submerged.push_back(submerged(b.surface, s.dimensions == 2));
}

/// Moves the water to where the wave has it, with its velocity and pressure.
void begin_with_wave(const Scene& scene, std::vector<Fluid>& fluids) {
    const TankWave wave(scene);
    for (Fluid& fluid : fluids) {
        fluid.velocity.assign(fluid.places.size(), Vec3::Zero());
        for (std::size_t i = 0; i < fluid.places.size(); ++i) {
            Vec3& at = fluid.places[i];
            if (wave.share(at.x()) == 0) continue;
            at = wave.moved(at);
            fluid.velocity[i] = wave.velocity(at.x(), at.z());
            fluid.depth[i] = wave.pressure_head(at.x(), at.z());
        }
    }
}

/// All particles, where they are at the start.
void place_particles(const Scene& scene, const std::vector<Box>& blocks, SphSetup& setup) {
    const SimulationSetup& s = setup.simulation;
    setup.fluid = fill_levels(s, blocks);
    fit_to_solids(s, blocks, setup.fluid);
    setup.pressure_iterations = find_start_pressure(s, blocks, setup.fluid);
    if (begins_with_wave(scene)) begin_with_wave(scene, setup.fluid);
    if (setup.air) setup.air->fluid = fill_with_air(s, blocks);
    if (setup.fluid.front().places.empty())
        throw InputError(scene.file.string() + ": no water particle fits: the spacing " + std::to_string(s.dp) +
                         " m is too coarse for the water");
}

/// What all ranks know of those.
void share_sums_of_particles(const Comm& ranks, SphSetup& setup) {
    setup.fluid.resize(setup.simulation.zones.size() + 1);
    for (Fluid& fluid : setup.fluid) ranks.take_from_owners(std::span(&fluid.volume, 1));
    if (setup.air) ranks.take_from_owners(std::span(&setup.air->fluid.volume, 1));
    setup.pressure_iterations = ranks.sum(setup.pressure_iterations);
}

}  // namespace

SphSetup sph_setup(const Scene& scene, int threads, const Comm& ranks) {
    SphSetup setup;
    SimulationSetup& s = setup.simulation;
    if (ranks.many()) s.ranks = &ranks;
    s.dimensions = scene.domain.dimensions;
    s.dp = finest_spacing(scene);
    s.h_over_dp = scene.sph.h_over_dp;
    s.rho0 = scene.water.density;
    s.gravity = Vec3(0, 0, -scene.water.gravity);
    s.state_equation.form = scene.sph.equation_of_state == "tait"             ? StateEquation::Form::tait
                            : scene.sph.equation_of_state == "mie_grueneisen" ? StateEquation::Form::mie_grueneisen
                                                                              : StateEquation::Form::linear;
    s.state_equation.c0 = scene.sph.c0;
    s.state_equation.gamma = scene.sph.gamma;
    s.delta = scene.sph.delta;
    s.alpha = scene.sph.alpha;
    s.scheme = scheme_of(scene.sph.scheme);
    s.cfl = scene.sph.cfl;
    s.shifting = scene.sph.shifting;
    s.touch_support = scene.sph.touch_support;
    s.domain = scene.domain.box;
    s.threads = threads;
    const Domain& d = scene.domain;
    s.mirrors.on = {{{is_mirror(d.x_min), is_mirror(d.x_max)},
                     {is_mirror(d.y_min), is_mirror(d.y_max)},
                     {is_mirror(d.z_min), is_mirror(d.z_max)}}};
    if (s.dimensions == 2) s.mirrors.on[1] = {false, false};
    if (tank_holds_water(scene))
        s.mirrors.holding = {{{d.x_min == Side::slip_wall, d.x_max == Side::slip_wall},
                              {d.y_min == Side::slip_wall, d.y_max == Side::slip_wall},
                              {d.z_min == Side::slip_wall, d.z_max == Side::slip_wall}}};
    if (scene.motion.kind == Motion::Kind::stream) {
        Stream stream;
        stream.speed = scene.motion.speed;
        stream.ramp = scene.motion.ramp;
        // the inlet must fill every support that reaches back over its plane, and outlast the steps between two list
        // builds
        stream.buffer = std::ceil(2 * s.h_over_dp + 2) * std::ldexp(s.dp, sizes_of_particles(scene) - 1);
        if (const auto enters = inlet_wave(scene)) {
            stream.wave = Stream::Wave{.gravity = scene.water.gravity, .begin = enters->begin, .ramp = enters->ramp};
            if (scene.wave)
                stream.wave->of = in_stream(*scene.wave);
            else
                stream.wave->of = sea_in_stream(scene.sea->waves);
        }
        if (const auto tail = tailwater(scene)) {
            stream.behind_from = blocks_of_water(scene).back().min.x();
            stream.behind_share = tail->speed / stream.speed;
        }
        s.stream = stream;
    }
    if (scene.hull) {
        const Surface& hull = scene.hull->surface;
        BodySetup& body = s.bodies.emplace_back(scene.hull->section ? with_span(hull, endless_span(hull)) : hull);
        body.name = "hull";
        body.is_hull = true;
        if (scene.hull->free) {
            body.moving = scene.hull->free->motion;
            body.moving->mass.mass /= scene.symmetry_factor();
            body.moving->mass.inertia /= scene.symmetry_factor();
        }
        s.moment_reference = moment_reference(scene);
    }
    s.frame = scene.tank_motion;
    s.zones = particle_zones(scene);
    s.partial_zones = static_cast<std::size_t>(sizes_below_near_hull(scene));
    if (!s.zones.empty() && zones_move(scene))
        s.zones_round = [of = std::make_shared<const Scene>(scene), start = s.zones](
                            std::span<const MovedSolid> moving) { return particle_zones(*of, moving, start); };
    if (scene.effect_on("dynamic_pressure")) take_rest_pressure(scene, s);
    s.effects = effects_of(scene, s, s);
    s.tension_control = scene.effect_on("tension_control");
    const double coarsest_dp = std::ldexp(s.dp, sizes_of_particles(scene) - 1);
    for (const Obstacle& o : scene.obstacles)
        s.bodies.emplace_back(through_mirrors(o.surface, s, coarsest_dp)).name = o.name;
    for (const MovingBody& b : scene.bodies) {
        if (b.elastic) {
            ElasticSetup made =
                b.tyre() ? elastic_setup(*b.tyre(), s.domain.min.z() + s.dp) : elastic_setup(*b.plate());
            if (s.frame) made.velocity += s.frame->velocity_of_rest();
            s.bodies.emplace_back(std::make_shared<const ElasticSetup>(std::move(made))).name = b.name;
            continue;
        }
        BodySetup& body =
            s.bodies.emplace_back(s.dimensions == 2 ? with_span(b.surface, endless_span(b.surface)) : b.surface);
        body.moving = b.motion;
        body.contact = wall_contact(b, scene);
        if (s.frame && !b.motion.law) body.moving->velocity += s.frame->velocity_of_rest();
        body.name = b.name;
    }

    if (scene.hull && scene.bodies.empty()) {
        ControlVolume volume = control_volume(scene, s);
        const auto clear_of = [&box = volume.box()](const Obstacle& o) {
            const Box solid = o.surface.bounds();
            return ((solid.min - box.max).array() > 0).any() || ((box.min - solid.max).array() > 0).any();
        };
        // it balances what the hull alone takes from the water
        if (std::ranges::all_of(scene.obstacles, clear_of)) setup.control_volume = std::move(volume);
    }

    std::vector<Box> blocks = scene.water_blocks;
    if (blocks.empty()) {
        blocks = blocks_of_water(scene);
        if (s.stream) {
            blocks.front().min.x() -= s.stream->buffer;
            blocks.back().max.x() += s.stream->buffer;
        }
    }
    if (scene.motion.kind == Motion::Kind::none && !scene.tank_motion && !scene.hull && scene.bodies.empty())
        s.packing = Packing::k;
    if (scene.effect_on("air")) {
        AirOptions& air = setup.air.emplace().options;
        air.density = scene.water.air_density;
        air.sound_speed = scene.sph.air_c0;
        setup.control_volume.reset();  // it balances the water alone
    }
    ranks.on_first([&] { place_particles(scene, blocks, setup); });
    share_sums_of_particles(ranks, setup);
    return setup;
}

}  // namespace tw
