#include "scene/solids/vortex_shedding.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "scene/refined_places.h"
#include "text/plain_number.h"

namespace tw {
namespace {

constexpr double unstable_from = 47, laminar_up_to = 1e5;  ///< Reynolds numbers
constexpr double strouhal_number = 0.2;
constexpr double spacings_in_layer = 5;
constexpr double heights_to_sides = 8;
constexpr double longest_blunt = 2;  ///< length over height: a longer section is streamlined or a plate

}  // namespace

std::optional<Finding> check_vortex_shedding(const Scene& scene) {
    if (!scene.hull || !scene.hull->section || scene.motion.kind != Motion::Kind::stream) return {};
    const Box body = scene.hull->surface.bounds();
    const double height = body.size().z(), speed = scene.motion.speed, nu = scene.water.kinematic_viscosity;
    if (!(body.max.z() < 0) || !(nu > 0) || body.size().x() > longest_blunt * height) return {};
    const double reynolds = speed * height / nu;
    if (reynolds < unstable_from || reynolds > laminar_up_to) return {};

    std::string missing;
    const auto ask = [&](const std::string& what) { missing += (missing.empty() ? "" : "; ") + what; };
    if (!scene.effect_on("viscosity")) ask("[effects] viscosity = \"on\", without which nothing separates by friction");
    const double needed = 1.2 * height / std::sqrt(reynolds) / spacings_in_layer, dp = finest_spacing(scene);
    if (dp > needed)
        ask(fmt::format("particles of {:.2g} m, five in the boundary layer where the stream meets it (here {:.2g} m)",
                        needed, dp));
    const double middle = 0.5 * (body.min.z() + body.max.z()),
                 room = std::min(-middle, middle - scene.domain.box.min.z());
    if (room < heights_to_sides * height)
        ask(fmt::format("floor and still water {:.3g} m from its middle, eight of its heights (here {:.3g} m)",
                        heights_to_sides * height, room));
    const std::string sheds = fmt::format("at Re = {:.3g} on its height it sheds vortices, about one pair in {} s",
                                          reynolds, plain_number(height / (strouhal_number * speed)));
    if (missing.empty()) return Finding{Finding::Level::note, "vortex_shedding", sheds, body.min};
    return Finding{
        Finding::Level::warning, "vortex_shedding",
        sheds + ", and this run is not expected to: drag and wake are no prediction. It takes at least " + missing,
        body.min};
}

}  // namespace tw
