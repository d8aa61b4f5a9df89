#include "scene/empty_twin.h"

#include <fmt/format.h>

#include <algorithm>

#include "base/errors.h"
#include "methods/methods.h"
#include "record/empty_twin.h"
#include "scene/hash.h"

namespace tw {

bool has_responses(const Scene& scene) {
    return std::ranges::any_of(scene.bodies, [](const MovingBody& b) { return b.free_and_rigid(); });
}

bool wants_empty_twin(const Scene& scene) {
    const std::string& asked = scene.wave_asked.empty_twin;
    if (!scene.wave || !has_responses(scene) || asked == "off") return false;
    return asked == "on" || scene.domain.dimensions == 2;
}

void leave_bodies_out(Scene& scene) {
    std::map<std::string, std::string> of;
    for (const std::string& method : method_names()) of[method] = run_hash(scene, method);
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
    scene.title += ", without its bodies";
    scene.empty_twin_of = std::move(of);
}

}  // namespace tw
