#include "scene/wave_twin.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/errors.h"
#include "methods/methods.h"
#include "record/wave_twin.h"
#include "scene/hash.h"

namespace tw {
namespace {

bool hull_in_stream(const Scene& scene) { return scene.hull && scene.motion.kind == Motion::Kind::stream; }

void leave_bodies_out(Scene& scene) {
    for (const MovingBody& body : scene.bodies) {
        if (!body.free_and_rigid()) continue;
        HeightProbe gauge{.name = gauge_of_empty_twin(body.name), .x = body.motion.mass.centre.x()};
        gauge.y = scene.domain.dimensions == 2 ? 0 : body.motion.mass.centre.y();
        if (std::ranges::find(scene.sampling.height, gauge.name, &HeightProbe::name) != scene.sampling.height.end())
            throw InputError(fmt::format(
                "{}: a height gauge is named {}, as the one that the run without body {} has in its place; expected "
                "another name, or [wave] empty_twin = \"off\"",
                scene.file.string(), gauge.name, body.name));
        scene.sampling.height.push_back(std::move(gauge));
    }
    scene.bodies.clear();
}

/// The sides stay walls, as the wave made them.
void leave_wave_out(Scene& scene) {
    scene.wave.reset();
    scene.zones.sides = "walls";
}

}  // namespace

bool has_responses(const Scene& scene) {
    return std::ranges::any_of(scene.bodies, [](const MovingBody& b) { return b.free_and_rigid(); });
}

bool wants_wave_twin(const Scene& scene) {
    const bool of_hull = hull_in_stream(scene);
    if (!scene.wave || !(of_hull || has_responses(scene))) return false;
    const std::string& asked = of_hull ? scene.wave_asked.calm_twin : scene.wave_asked.empty_twin;
    return asked == "on" || (asked == "auto" && scene.domain.dimensions == 2);
}

std::string left_out_of_twin(const Scene& scene) { return hull_in_stream(scene) ? "the wave" : "its bodies"; }

std::string_view folder_of_coarser_members(const Scene& scene) {
    return hull_in_stream(scene) ? calm_twins_folder : empty_twins_folder;
}

void make_wave_twin(Scene& scene) {
    std::map<std::string, std::string> of;
    for (const std::string& method : method_names()) of[method] = run_hash(scene, method);
    scene.title += ", without " + left_out_of_twin(scene);
    hull_in_stream(scene) ? leave_wave_out(scene) : leave_bodies_out(scene);
    scene.wave_twin_of = std::move(of);
}

}  // namespace tw
