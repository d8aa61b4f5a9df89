#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <thread>

#include "base/errors.h"
#include "scene/cost/steps_of_cells.h"
#include "scene/defaults.h"
#include "scene/effects/registry.h"
#include "scene/elastic/tyre_steps.h"
#include "scene/mesh/courant_number.h"
#include "scene/mesh/edge_refinement.h"
#include "scene/mesh/mesh_cells.h"
#include "scene/mesh/mesh_motion.h"
#include "scene/particles/cores_of_particles.h"
#include "scene/particles/particles_of_sizes.h"
#include "scene/refined_places.h"
#include "scene/scene.h"
#include "scene/solids/added_mass.h"
#include "scene/water/running_water.h"
#include "scene/water/water_blocks.h"
#include "structure/solid/solid.h"
#include "text/plain_number.h"
#include "text/units.h"

namespace tw {
namespace {

// Throughput, measured on a core of an AMD EPYC with AVX-512 by processor time (docs/performance.md, "Predicted and spent
// time"); one place for all of them.
constexpr double particle_steps_per_core_second = 2.86e6;           // delta-SPH with renormalised diffusion, h/dp = 1.5
constexpr double cost_of_flat_particle = 0.37;                      // of one in three dimensions, h/dp = 1.5
constexpr double start_of_particles = 0.1;                          // seconds: the scene, its walls and the last record
// Peaks of runs less the program's own: prism at beam/20 (1.6 million) 480; the demo at b/14 and b/7, a cylinder's entry
// (26 000 to 130 000, several sizes) 600 to 950.
constexpr double bytes_per_particle = 480, of_several_sizes = 700;
constexpr double bytes_of_copies = 50;      // written beside the steps (sph_solver/run_files.h); 47 were measured
constexpr double bytes_per_open_voxel = 8;  // while a frame is filled; afterwards it keeps one byte
constexpr double wall_layers = 4;
constexpr double steps_of_shedding_edges = 1.45;      // half a prism with cells halved along chine and transom
constexpr double cell_steps_per_core_second = 335e3;  // interFoam, three dimensions, three pressure correctors
constexpr double cost_of_flat_step = 0.54;            // two dimensions: four faces of a cell in place of six
constexpr double cost_of_moving_step = 1.6;           // a mesh that follows a body, in two or three dimensions
// A free hull in a stream, beside which more of the mesh moves: with one corrector in a step, as in waves, and with three,
// where it is so light that body and water come to terms no sooner (foam_cases/viscous_steps.h). Measured: a ship and a
// planing hull in waves; two, of one that is not light in calm water, lie between.
constexpr double cost_of_free_hull_step = 1.9, cost_of_light_hull_step = 3.8;
constexpr double lightest_at_once = 0.375;            // share of its added mass
constexpr double seconds_per_frame = 0.012;           // files of a moment, whatever the mesh
constexpr double seconds_per_cell_of_frame = 3.5e-7;  // read again for the record
constexpr double cost_of_geometric_capture = 4;       // interIsoFoam's step beside interFoam's, in three dimensions
constexpr double bytes_per_cell = 2.5e3, bytes_of_interfoam = 115e6;
constexpr double steps_per_cell_crossing = 0.63;  // at Courant number 4: 240 steps/s at 21 mm and 8 m/s
constexpr double mean_of_fastest = 0.68;          // in time: weir, sluice and bump of studies/, 0.66 to 0.70
constexpr double steps_per_frame = 2;             // where interFoam hits every sampling time
// A hull held in a stream (decision 015): the demo's members, whose snapped cells set the steps; its settings.
constexpr double held_steps_per_cell_crossing = 1.2, cost_of_held_step = 0.67;
constexpr double start_seconds = 0.8;              // starting the programs of a case
constexpr double mesh_seconds_per_cell = 1.1e-4;   // blockMesh, features, snappyHexMesh, renumber
constexpr double seconds_per_element_step = 1e-6;  // of a tyre's hexahedra
constexpr double parallel_share = 0.8;             // of each further core (1.58 times on two)

/// Of a run of so many steps: its sub-steps, in each half of a step, on one core.
double seconds_of_tyre(const ElasticTyre& tyre, double duration, double steps) {
    const TyreSteps cut = steps_of(tyre, solid_of(tyre));
    return 2 * steps * std::ceil(duration / steps / 2 / cut.longest()) * cut.elements * seconds_per_element_step;
}

/// Of one of interFoam's, in those of the throughput above.
double cost_of_step(const Scene& scene) {
    const bool flat = scene.domain.dimensions == 2;
    const double surface = scene.fvm.captures_geometrically() && !flat ? cost_of_geometric_capture : 1;  // decision 028
    if (scene.hull && scene.hull->free && scene.motion.kind == Motion::Kind::stream) {
        const MovingBody hull = followed_by_mesh(scene).front();
        const bool light = hull.motion.mass.mass < lightest_at_once * added_mass(hull, scene);
        if (light) return surface * cost_of_light_hull_step;
        return surface * cost_of_free_hull_step * (scene.has_wave() ? 1 : 1.5);
    }
    if (!scene.bodies.empty() || (scene.hull && scene.hull->free)) return surface * cost_of_moving_step;
    return surface * (flat ? cost_of_flat_step : hull_held_in_stream(scene) ? cost_of_held_step : 1);
}

double cores(const Scene& scene) {
    if (scene.run.threads > 0) return scene.run.threads;
    return std::max(1u, std::thread::hardware_concurrency());
}

/// By which time steps are predicted [m/s].
double speed_of_water(const Scene& scene) {
    if (scene.has_wave()) return scene.motion.speed + speed_of_crests(scene);  // over the stream
    return scene.motion.kind == Motion::Kind::stream ? scene.motion.speed : 0.1 * default_sound_speed(scene);
}

double steps_of_cells_in_stream(const Scene& scene) {
    // What falls over weirs and runs under gates is faster than the stream that comes.
    const double speed = std::max(speed_of_water(scene), mean_of_fastest * explained_speed(scene));
    return scene.run.duration * (hull_held_in_stream(scene) ? held_steps_per_cell_crossing : steps_per_cell_crossing) *
           speed / finest_cell(scene) * 4 / std::min(scene.fvm.max_courant, scene.fvm.max_alpha_courant) *
           (edge_refinement(scene).edges.empty() ? 1 : steps_of_shedding_edges);
}

}  // namespace

double cores_of_particles(const Scene& scene) { return cores(scene) * (scene.run.threads > 0 ? scene.run.ranks : 1); }

MethodCost predict_particles(const Scene& scene, const Prediction& p, double pace) {
    MethodCost cost;
    const double dp = finest_spacing(scene);
    const bool flat = scene.domain.dimensions == 2;
    double due = 0;  // particles in a step of the finest size
    for (const ParticlesOfSize& size : particles_of_sizes(scene)) due = size.all() + due / 2;
    const double finest_steps =
        scene.run.duration * (scene.sph.c0 + speed_of_water(scene)) / (scene.sph.cfl * scene.sph.h_over_dp * dp);
    cost.steps = finest_steps / std::exp2(sizes_of_particles(scene) - 1);
    // Work grows with the number of neighbours: the throughput above is that of h/dp = 1.5. In two dimensions they are
    // the smaller part of it: measured at h/dp = 1.55 and 2.
    const double h = scene.sph.h_over_dp / 1.5, neighbours = flat ? cost_of_flat_particle * h : h * h * h;
    cost.seconds = pace * ((due + p.wall_particles) * finest_steps * neighbours / particle_steps_per_core_second) /
                   cores_of_particles(scene);
    for (const EffectChoice& e : scene.effects)
        if (e.on && !effect_part(e.name).in_the_throughput) cost.seconds *= 1 + e.cost;
    for (const MovingBody& body : scene.bodies)
        if (body.tyre()) cost.seconds += pace * seconds_of_tyre(*body.tyre(), scene.run.duration, finest_steps);
    cost.seconds += pace * start_of_particles;
    cost.core_seconds = cost.seconds * cores_of_particles(scene);
    if (scene.effect_on("air"))
        cost.steps *=
            std::max(1.0, (scene.sph.air_c0 + speed_of_water(scene)) / (scene.sph.c0 + speed_of_water(scene)));
    const double each = (sizes_of_particles(scene) > 1 ? of_several_sizes : bytes_per_particle) +
                        (scene.run.ranks > 1 ? 0 : bytes_of_copies);  // ranks wait for the one that writes
    cost.bytes =
        p.raster_bytes + (p.most_particles + p.air_particles + p.wall_particles * (p.air_particles > 0 ? 2 : 1)) * each;
    cost.elements = p.particles + p.air_particles;
    cost.with_walls = cost.elements + p.wall_particles;
    cost.most = cost.with_walls + p.most_particles - p.particles;
    cost.in_words = fmt::format("{} particles{} + {} in walls", plain_number(p.particles),
                                p.air_particles > 0 ? " + " + plain_number(p.air_particles) + " of air" : "",
                                plain_number(p.wall_particles));
    cost.lengthened_by = {{"sph.cfl", SphOptions{}.cfl / scene.sph.cfl},
                          {"sph.c0", scene.sph.c0 / default_sound_speed(scene)}};
    return cost;
}

MethodCost predict_cells(const Scene& scene, const Prediction& p, double pace) {
    MethodCost cost;
    const bool held = hull_held_in_stream(scene);
    const bool stream = scene.motion.kind == Motion::Kind::stream;
    // In a tank, and of a held hull, frames are taken at the steps there are.
    if (stream)
        cost.steps = std::max(steps_of_cells_in_stream(scene),
                              held ? 0 : steps_per_frame * scene.run.duration / scene.sampling.interval);
    else
        cost.steps = steps_of_cells_in_tank(scene, 4 * steps_per_cell_crossing);
    const double n = cores(scene), frames = std::min(p.frames, cost.steps);
    const double alone = start_seconds + p.cells * (mesh_seconds_per_cell + frames * seconds_per_cell_of_frame);
    const double shared =
        (p.cells * cost.steps * cost_of_step(scene) / cell_steps_per_core_second + frames * seconds_per_frame) /
        (1 + (n - 1) * parallel_share);
    cost.seconds = pace * (alone + shared);
    cost.core_seconds = pace * (alone + shared * n);  // ranks that wait for others use their cores
    cost.bytes = p.raster_bytes + p.cells * bytes_per_cell + bytes_of_interfoam * n;
    cost.elements = cost.with_walls = cost.most = p.cells;
    cost.in_words = plain_number(p.cells) + " cells";
    cost.lengthened_by = {{"fvm.max_courant", default_courant(scene) / scene.fvm.max_courant},
                          {"sampling.interval", default_interval(scene) / scene.sampling.interval}};
    return cost;
}

Prediction predict_sizes(const Scene& scene) {
    Prediction p;
    const double dp = finest_spacing(scene);
    const bool flat = scene.domain.dimensions == 2;
    for (const ParticlesOfSize& size : particles_of_sizes(scene)) p.particles += size.all();
    const bool runs = sizes_of_particles(scene) > 1 && running_water(scene);
    p.particles_at_start = runs ? all_of(particles_of_sizes(scene, During::start)) : p.particles;
    p.most_particles = runs ? all_of(particles_of_sizes(scene, During::peak)) : p.particles;
    double solid_area = scene.hull ? scene.hull->mass.area / scene.symmetry_factor() : 0;
    for (const Obstacle& o : scene.obstacles) solid_area += mass_properties(o.surface).area;
    for (const MovingBody& b : scene.bodies) solid_area += mass_properties(b.surface).area;
    p.wall_particles = flat ? 0 : wall_layers * solid_area / (dp * dp);
    if (scene.effect_on("air"))
        p.air_particles = air_volume(scene) / (dp * dp * (flat ? scene.domain.box.size().y() : dp));
    p.cells = predicted_cells(scene);
    const Sampling& sampling = scene.sampling;
    p.frames = std::min(1e18, std::floor(scene.run.duration / sampling.interval) + 1);
    p.raster_bytes = voxels(sampling.raster) * (p.frames + bytes_per_open_voxel);
    if (sampling.snapshot_interval > 0) p.snapshots = std::floor(scene.run.duration / sampling.snapshot_interval) + 1;
    return p;
}

void add_cost(Prediction& p, const Scene& scene, const CostOf& method) {
    p.costs.push_back(method.predict(scene, p, method.pace));
    p.costs.back().method = method.method;
}

Prediction predict(const Scene& scene, const std::vector<CostOf>& methods) {
    Prediction p = predict_sizes(scene);
    for (const CostOf& method : methods) add_cost(p, scene, method);
    return p;
}

const MethodCost& Prediction::of(const std::string& method) const {
    const auto cost = std::ranges::find(costs, method, &MethodCost::method);
    if (cost == costs.end()) throw std::logic_error("no cost was predicted of the method " + method);
    return *cost;
}

}  // namespace tw
