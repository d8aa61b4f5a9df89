#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <thread>

#include "base/errors.h"
#include "scene/box/tank_wave.h"
#include "scene/defaults.h"
#include "scene/effects/registry.h"
#include "scene/elastic/tyre_steps.h"
#include "scene/mesh/edge_refinement.h"
#include "scene/mesh/mesh_cells.h"
#include "scene/particles/cores_of_particles.h"
#include "scene/particles/particles_of_sizes.h"
#include "scene/refined_places.h"
#include "scene/scene.h"
#include "scene/water/running_water.h"
#include "scene/water/water_blocks.h"
#include "structure/solid/solid.h"
#include "text/plain_number.h"
#include "text/units.h"

namespace tw {
namespace {

// Throughput, measured on AVX-512 server cores of about 3 GHz; one place for all of them.
constexpr double particle_steps_per_core_second = 1.1e6;            // delta-SPH with renormalised diffusion, h/dp = 1.5
constexpr double bytes_per_particle = 240, of_several_sizes = 420;  // the prism at beam/20
constexpr double bytes_of_copies = 50;      // written beside the steps (sph_solver/run_files.h); 47 were measured
constexpr double bytes_per_open_voxel = 8;  // while a frame is filled; afterwards it keeps one byte
constexpr double wall_layers = 4;
constexpr double steps_of_shedding_edges = 1.45;      // half a prism with cells halved along chine and transom
constexpr double cell_steps_per_core_second = 235e3;  // interFoam, three pressure correctors
constexpr double cost_of_geometric_capture = 4;       // interIsoFoam's step beside interFoam's, in three dimensions
constexpr double bytes_per_cell = 2.5e3, bytes_of_interfoam = 115e6;
constexpr double steps_per_cell_crossing = 0.63;  // at Courant number 4: 240 steps/s at 21 mm and 8 m/s
constexpr double steps_per_frame = 4;             // interFoam hits every sampling time and then regains its step slowly
// A hull held in a stream (decision 015): the demo's members, whose snapped cells set the steps; its settings.
constexpr double held_steps_per_cell_crossing = 1.2, cost_of_held_step = 0.67;
constexpr double start_seconds = 5;                    // self-test, and starting the programs of a case
constexpr double mesh_seconds_per_cell = 20.0 / 74e3;  // blockMesh, features, snappyHexMesh, renumber
constexpr double seconds_per_element_step = 1e-6;      // of a tyre's hexahedra
constexpr double parallel_share = 0.8;                 // of each further core (1.58 times on two)

/// Of a run of so many steps: its sub-steps, in each half of a step, on one core.
double seconds_of_tyre(const ElasticTyre& tyre, double duration, double steps) {
    const TyreSteps cut = steps_of(tyre, solid_of(tyre));
    return 2 * steps * std::ceil(duration / steps / 2 / cut.longest()) * cut.elements * seconds_per_element_step;
}

double cores(const Scene& scene) {
    if (scene.run.threads > 0) return scene.run.threads;
    return std::max(1u, std::thread::hardware_concurrency());
}

/// By which time steps are predicted [m/s].
double speed_of_water(const Scene& scene) {
    if (scene.wave)  // of the water in its crest, over the stream
        return scene.motion.speed + std::numbers::pi * scene.wave->height / scene.wave->period_in_water() /
                                        std::tanh(scene.wave->k() * scene.wave->depth);
    if (scene.sea) {
        const WaveScales wave = wave_scales(scene);
        const double kd = 2 * std::numbers::pi / wave.length * scene.sea->depth();
        return 2 * std::numbers::pi * wave.crest / wave.period / std::tanh(kd);
    }
    return scene.motion.kind == Motion::Kind::stream ? scene.motion.speed : 0.1 * default_sound_speed(scene);
}

}  // namespace

double cores_of_particles(const Scene& scene) { return cores(scene) * (scene.run.threads > 0 ? scene.run.ranks : 1); }

MethodCost predict_particles(const Scene& scene, const Prediction& p, double pace) {
    MethodCost cost;
    const double dp = finest_spacing(scene);
    const bool flat = scene.domain.dimensions == 2;
    double steps_of_finest = 0;  // of as many particles as are due in a step of the finest size
    for (const ParticlesOfSize& size : particles_of_sizes(scene)) steps_of_finest = size.all() + steps_of_finest / 2;
    cost.steps =
        scene.run.duration * (scene.sph.c0 + speed_of_water(scene)) / (scene.sph.cfl * scene.sph.h_over_dp * dp);
    // Work grows with the number of neighbours: the throughput above is that of h/dp = 1.5.
    const double neighbours = std::pow(scene.sph.h_over_dp / 1.5, flat ? 2 : 3) * (flat ? 0.3 : 1);
    cost.seconds = pace * (steps_of_finest + p.wall_particles) * cost.steps * neighbours /
                   (particle_steps_per_core_second * cores_of_particles(scene));
    for (const EffectChoice& e : scene.effects)
        if (e.on && !effect_part(e.name).in_the_throughput) cost.seconds *= 1 + e.cost;
    for (const MovingBody& body : scene.bodies)
        if (body.tyre()) cost.seconds += pace * seconds_of_tyre(*body.tyre(), scene.run.duration, cost.steps);
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
    const double courant_rate = (held ? held_steps_per_cell_crossing : steps_per_cell_crossing) *
                                speed_of_water(scene) / finest_spacing(scene) * 4 /
                                std::min(scene.fvm.max_courant, scene.fvm.max_alpha_courant) *
                                (edge_refinement(scene).edges.empty() ? 1 : steps_of_shedding_edges);
    // A held hull's frames are taken at the steps there are.
    const double frame_rate = held ? 0 : steps_per_frame / scene.sampling.interval;
    cost.steps = scene.run.duration * std::max(courant_rate, frame_rate);
    const double n = cores(scene);
    const bool dearer = scene.fvm.captures_geometrically() && scene.domain.dimensions == 3;  // decision 066
    const double of_a_step = dearer ? cost_of_geometric_capture : held ? cost_of_held_step : 1;
    cost.seconds =
        pace * (start_seconds + p.cells * mesh_seconds_per_cell +
                p.cells * cost.steps * of_a_step / (cell_steps_per_core_second * (1 + (n - 1) * parallel_share)));
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
