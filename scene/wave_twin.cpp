#include "scene/wave_twin.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/errors.h"
#include "methods/methods.h"
#include "record/wave_twin.h"
#include "scene/box/oblique_wave.h"
#include "scene/hash.h"
#include "scene/mesh/mesh_cells.h"

namespace tw {
namespace {

bool hull_in_stream(const Scene& scene) { return scene.hull && scene.motion.kind == Motion::Kind::stream; }

/// A height gauge at the place of what is left out, at least one spacing inside the tank's sides.
void put_gauge(Scene& scene, const std::string& name, const Vec3& place) {
    HeightProbe gauge{.name = gauge_of_empty_twin(name), .x = place.x()};
    if (scene.domain.dimensions == 3) {
        const double inside = scene.resolution.near_hull;
        const Box& tank = scene.domain.box;
        gauge.y = std::clamp(place.y(), tank.min.y() + inside, tank.max.y() - inside);
    }
    if (std::ranges::find(scene.sampling.height, gauge.name, &HeightProbe::name) != scene.sampling.height.end())
        throw InputError(
            fmt::format("{}: a height gauge is named {}, as the one that the run without {} has in its place; expected "
                        "another name, "
                        "or [wave] empty_twin = \"off\"",
                        scene.file.string(), gauge.name, name));
    scene.sampling.height.push_back(std::move(gauge));
}

/// Its steps are those of the run with the solids, beside which there may be smaller cells.
void leave_solids_out(Scene& scene) {
    const double cell = finest_cell(scene);
    if (!has_responses(scene)) {
        for (const Obstacle& obstacle : scene.obstacles) {
            const Box bounds = obstacle.surface.bounds();
            put_gauge(scene, obstacle.name, (bounds.min + bounds.max) / 2);
        }
        scene.obstacles.clear();
    }
    for (const MovingBody& body : scene.bodies)
        if (body.free_and_rigid()) put_gauge(scene, body.name, body.motion.mass.centre);
    scene.bodies.clear();
    for (double* courant : {&scene.fvm.max_courant, &scene.fvm.max_alpha_courant})
        *courant *= cell / finest_cell(scene);
}

/// The sides stay walls, as the wave made them, or zones, as an oblique one did.
void leave_wave_out(Scene& scene) {
    if (!runs_obliquely(scene)) scene.zones.sides = "walls";
    scene.wave.reset();
}

}  // namespace

bool has_responses(const Scene& scene) {
    return std::ranges::any_of(scene.bodies, [](const MovingBody& b) { return b.free_and_rigid(); });
}

bool has_empty_twin(const Scene& scene) {
    return has_responses(scene) || (scene.bodies.empty() && !scene.obstacles.empty() && !scene.hull);
}

bool wants_wave_twin(const Scene& scene) {
    const bool of_hull = hull_in_stream(scene);
    if (!scene.wave || !(of_hull || has_empty_twin(scene))) return false;
    const std::string& asked = of_hull ? scene.wave_asked.calm_twin : scene.wave_asked.empty_twin;
    return asked == "on" || (asked == "auto" && scene.domain.dimensions == 2 && (of_hull || has_responses(scene)));
}

std::string left_out_of_twin(const Scene& scene) {
    if (hull_in_stream(scene)) return "the wave";
    return has_responses(scene) ? "its bodies" : "its obstacles";
}

std::string_view folder_of_wave_twin(const Scene& scene) {
    return hull_in_stream(scene) ? calm_twins_folder : empty_twins_folder;
}

void make_wave_twin(Scene& scene) {
    std::map<std::string, std::string> of;
    for (const std::string& method : method_names()) of[method] = run_hash(scene, method);
    scene.title += ", without " + left_out_of_twin(scene);
    hull_in_stream(scene) ? leave_wave_out(scene) : leave_solids_out(scene);
    scene.wave_twin_of = std::move(of);
}

}  // namespace tw
