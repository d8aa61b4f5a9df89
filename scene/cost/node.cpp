#include "scene/cost/node.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>
#include <utility>
#include <vector>

#include "base/errors.h"
#include "methods/methods.h"
#include "scene/defaults.h"
#include "scene/water/water_blocks.h"
#include "text/units.h"

namespace tw {

namespace {

constexpr double bytes_of_start = 85;  // of each particle, on the first of several ranks; a prism at beam/20

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

/// Whether ranks share the run; the first one then has all particles while it starts.
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

double bytes_on(const Node& node, const Scene& scene, const MethodCost& cost, double raster_bytes) {
    const double whole = cost.bytes - raster_bytes;
    if (!is_shared(scene, cost)) return whole;
    const double each = whole / scene.run.ranks, first = std::max(each, cost.most * bytes_of_start);
    return first + (node.ranks - 1) * each;
}

void refuse_oversize(const Scene& scene, const Prediction& p, const Node& node) {
    for (const std::string& method : scene.run.methods) {
        if (node.memory) refuse_too_fine(scene, p.of(method), p.raster_bytes, node);
        refuse_too_long(scene, p.of(method));
    }
    refuse_too_many_samples(scene, p, node);
}

}  // namespace tw
