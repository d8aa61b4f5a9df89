#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <stdexcept>
#include <thread>

#include "base/errors.h"
#include "scene/cores_of_particles.h"
#include "scene/defaults.h"
#include "scene/edge_refinement.h"
#include "scene/effects/registry.h"
#include "scene/mesh_cells.h"
#include "scene/node.h"
#include "scene/particles_of_sizes.h"
#include "scene/refined_places.h"
#include "scene/running_water.h"
#include "scene/scene.h"
#include "scene/tyre_steps.h"
#include "scene/water_blocks.h"
#include "structure/solid/solid.h"
#include "text/plain_number.h"
#include "text/units.h"

namespace tw {
namespace {

// Throughput, measured on AVX-512 server cores of about 3 GHz; one place for all of them.
constexpr double particle_steps_per_core_second = 1.1e6;            // delta-SPH with renormalised diffusion, h/dp = 1.5
constexpr double bytes_per_particle = 240, of_several_sizes = 420;  // the prism at beam/20
constexpr double bytes_of_copies = 50;      // written beside the steps (sph_solver/run_files.h); 47 were measured
constexpr double bytes_of_start = 85;       // of each particle, on each of several ranks; the same prism
constexpr double bytes_per_open_voxel = 8;  // while a frame is filled; afterwards it keeps one byte
constexpr double wall_layers = 4;
constexpr double steps_of_shedding_edges = 1.45;      // half a prism with cells halved along chine and transom
constexpr double cell_steps_per_core_second = 235e3;  // interFoam, three pressure correctors
constexpr double cost_of_geometric_capture = 4;       // interIsoFoam's step beside interFoam's, in three dimensions
constexpr double bytes_per_cell = 2.5e3, bytes_of_interfoam = 115e6;
constexpr double steps_per_cell_crossing = 0.63;  // at Courant number 4: 240 steps/s at 21 mm and 8 m/s
constexpr double steps_per_frame = 4;             // interFoam hits every sampling time and then regains its step slowly
constexpr double start_seconds = 5;               // self-test, and starting the programs of a case
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
    return scene.motion.kind == Motion::Kind::stream ? scene.motion.speed : 0.1 * default_sound_speed(scene);
}

/// The first of these keys that the scene gives; else what their defaults follow from, its hull or tank.
std::string given_of(const Scene& scene, std::vector<std::string> keys) {
    const std::string first = keys.front();
    keys.insert(keys.end(), {"hull.shape", "hull.file", "tank.size", "tank.max"});
    const auto given = std::ranges::find_if(keys, [&](const auto& key) { return scene.places.contains(key); });
    return given == keys.end() ? first : *given;
}

/// The key that made the domain's longest edge.
std::string key_of_domain(const Scene& scene) {
    static const std::array<std::vector<std::string>, 3> keys{
        {{"domain.x", "domain.ahead", "domain.behind", "tank.size"},
         {"domain.y", "domain.side", "tank.size"},
         {"domain.z", "domain.below", "domain.above", "tank.size"}}};
    Eigen::Index longest = 0;
    scene.domain.box.size().maxCoeff(&longest);
    return given_of(scene, keys[static_cast<std::size_t>(longest)]);
}

/// Whether ranks share the run; each then has all particles while it starts.
bool is_shared(const Scene& scene, const MethodCost& cost) {
    return scene.run.ranks > 1 && elements_of(cost.method) == "particles";
}

void refuse_too_fine(const Scene& scene, const MethodCost& cost, double raster_bytes, const Node& node) {
    const double memory = 0.9 * *node.memory, bytes = bytes_on(node, scene, cost, raster_bytes);
    if (bytes <= memory) return;
    const std::string need =
        fmt::format("{:.3g} {} need {:.3g} GB of memory{}, and {:.3g} GB are available", cost.most,
                    elements_of(cost.method), bytes / 1e9,
                    is_shared(scene, cost) ? fmt::format(" where {} of {} ranks are", node.ranks, scene.run.ranks) : "",
                    memory / 1e9);
    const double enough = scene.resolution.near_hull * std::cbrt(bytes / memory) * 1.01;
    if (scene.hull && std::isfinite(enough) && enough > coarsest_particles(*scene.hull)) {
        const Vec3 size = scene.domain.box.size();
        throw InputError(fmt::format("{}: the domain of {:.3g} x {:.3g} x {:.3g} m is too large for this machine: {}",
                                     scene.place_of(key_of_domain(scene)), size.x(), size.y(), size.z(), need));
    }
    throw InputError(fmt::format(
        "{}: too fine for this machine: {}{}", scene.place_of(given_of(scene, {"resolution.near_hull"})), need,
        std::isfinite(enough) ? fmt::format("; expected at least near_hull = {:.3g} m", enough) : ""));
}

/// The key that departs most from its default towards a long run, among those that were given.
std::string reason_of_length(const Scene& scene, const MethodCost& cost) {
    const double near = scene.hull ? default_near_hull(*scene.hull) : water_height(scene) / 40;
    std::vector<std::pair<std::string, double>> departures{
        {"resolution.near_hull", std::pow(near / scene.resolution.near_hull, 4)},
        {"run.duration", scene.run.duration / default_duration(scene)}};
    departures.insert(departures.end(), cost.lengthened_by.begin(), cost.lengthened_by.end());
    std::erase_if(departures, [&](const auto& d) { return !scene.places.contains(d.first); });
    if (departures.empty()) return given_of(scene, {"resolution.near_hull"});
    return std::ranges::max_element(departures, {}, [](const auto& d) { return d.second; })->first;
}

void refuse_too_long(const Scene& scene, const MethodCost& cost) {
    if (cost.seconds <= longest_run) return;
    throw InputError(fmt::format(
        "{}: the {} run would take about {} here ({:.3g} {}, {:.3g} time steps), and runs longer than {:.0f} days are "
        "refused; choose a coarser size, a shorter duration, larger time steps or more threads",
        scene.place_of(reason_of_length(scene, cost)), cost.method, time_in_words(cost.seconds), cost.with_walls,
        elements_of(cost.method), cost.steps, longest_run / 86400));
}

void refuse_too_many_samples(const Scene& scene, const Prediction& p, const Node& node) {
    const auto refuse = [&](const char* key, const std::string& what, double expected, const char* unit) {
        throw InputError(fmt::format("{}: {}; expected at least {:.3g} {}", scene.place_of(given_of(scene, {key})),
                                     what, expected, unit));
    };
    const double duration = scene.run.duration;
    if (p.snapshots > most_snapshots)
        refuse("sampling.snapshots", fmt::format("{:.3g} snapshots would be written", p.snapshots),
               duration / most_snapshots, "s");
    if (duration / scene.run.checkpoint > most_snapshots)
        refuse("run.checkpoint", fmt::format("{:.3g} states would be saved", duration / scene.run.checkpoint),
               duration / most_snapshots, "s");
    if (p.frames > most_frames)
        refuse("sampling.interval", fmt::format("{:.3g} samples would be taken", p.frames), duration / most_frames,
               "s");
    if (!node.memory) return;
    const double memory = 0.9 * *node.memory, excess = p.raster_bytes / (0.5 * memory);
    if (excess <= 1) return;
    const Sampling& sampling = scene.sampling;
    const std::string what = fmt::format(
        "the water raster of {:.3g} voxels in {:.0f} frames needs {:.3g} GB of memory, and it may take half of the "
        "{:.3g} "
        "GB that are available",
        voxels(sampling.raster), p.frames, p.raster_bytes / 1e9, memory / 1e9);
    const double finer = std::pow(2 * scene.resolution.near_hull / sampling.raster.voxel, 3),
                 oftener = default_interval(scene) / sampling.interval;
    if (oftener > finer)
        refuse("sampling.interval", what, sampling.interval * excess * 1.01, "s");
    else
        refuse("sampling.raster_spacing", what, sampling.raster.voxel * std::cbrt(excess) * 1.01, "m");
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
    const double courant_rate = steps_per_cell_crossing * speed_of_water(scene) / finest_spacing(scene) * 4 /
                                std::min(scene.fvm.max_courant, scene.fvm.max_alpha_courant) *
                                (edge_refinement(scene).edges.empty() ? 1 : steps_of_shedding_edges);
    cost.steps = scene.run.duration * std::max(courant_rate, steps_per_frame / scene.sampling.interval);
    const double n = cores(scene);
    const bool dearer = scene.fvm.captures_geometrically() && scene.domain.dimensions == 3;  // decision 066
    cost.seconds = pace * (start_seconds + p.cells * mesh_seconds_per_cell +
                           p.cells * cost.steps * (dearer ? cost_of_geometric_capture : 1) /
                               (cell_steps_per_core_second * (1 + (n - 1) * parallel_share)));
    cost.bytes = p.raster_bytes + p.cells * bytes_per_cell + bytes_of_interfoam * n;
    cost.elements = cost.with_walls = cost.most = p.cells;
    cost.in_words = plain_number(p.cells) + " cells";
    cost.lengthened_by = {{"fvm.max_courant", default_courant(scene) / scene.fvm.max_courant},
                          {"sampling.interval", default_interval(scene) / scene.sampling.interval}};
    return cost;
}

Prediction predict(const Scene& scene, const std::vector<CostOf>& methods) {
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
    for (const CostOf& method : methods) {
        p.costs.push_back(method.predict(scene, p, method.pace));
        p.costs.back().method = method.method;
    }
    return p;
}

const MethodCost& Prediction::of(const std::string& method) const {
    const auto cost = std::ranges::find(costs, method, &MethodCost::method);
    if (cost == costs.end()) throw std::logic_error("no cost was predicted of the method " + method);
    return *cost;
}

double bytes_on(const Node& node, const Scene& scene, const MethodCost& cost, double raster_bytes) {
    const double whole = cost.bytes - raster_bytes;
    if (!is_shared(scene, cost)) return whole;
    return node.ranks * std::max(whole / scene.run.ranks, cost.most * bytes_of_start);
}

void refuse_oversize(const Scene& scene, const Prediction& p) { refuse_oversize(scene, p, {}); }

void refuse_oversize(const Scene& scene, const Prediction& p, const Node& node) {
    for (const std::string& method : scene.run.methods) {
        if (node.memory) refuse_too_fine(scene, p.of(method), p.raster_bytes, node);
        refuse_too_long(scene, p.of(method));
    }
    refuse_too_many_samples(scene, p, node);
}

}  // namespace tw
