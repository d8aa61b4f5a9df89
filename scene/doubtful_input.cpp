#include "scene/doubtful_input.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/gap.h"
#include "meshes/mass_properties.h"
#include "scene/solids/walls_met.h"
#include "scene/water/channel_flow.h"
#include "scene/water/water_blocks.h"
#include "text/plain_number.h"

namespace tw {
namespace {

void warn_of(std::vector<Finding>& findings, const char* name, const std::string& message) {
    findings.push_back({Finding::Level::warning, name, message, Vec3::Zero()});
}

void doubt_water(const Water& w, std::vector<Finding>& findings) {
    const double nu = w.kinematic_viscosity;
    const bool like_water = w.density > 900 && w.density < 1100;
    if (like_water && nu >= 2e-4 && nu <= 2e-3)
        warn_of(findings, "dynamic_viscosity",
                fmt::format(
                    "[water] viscosity is the kinematic one: {} m2/s is {:.0f} times water's. The dynamic viscosity of "
                    "water is about 1e-3 Pa s, which would be {:.3g} m2/s here; leave it as it is where an oil is "
                    "meant",
                    plain_number(nu), nu / 1e-6, nu / w.density));
    if (w.density < 500 || w.density > 2000)
        warn_of(findings, "odd_density",
                fmt::format("[water] density is {} kg/m3: fresh water has 998, sea water 1025 kg/m3",
                            plain_number(w.density)));
    if (w.surface_tension > 1)
        warn_of(findings, "odd_tension",
                fmt::format("[water] surface_tension is {} N/m: water has 0.072 N/m, that is 72 mN/m",
                            plain_number(w.surface_tension)));
}

/// "3600 kg, 1000 times less than the water that ..."
std::string against(double mass, double water, const std::string& unit) {
    const bool less = mass < water;
    return fmt::format("{} {}, {} times {} than", plain_number(mass), unit,
                       plain_number(less ? water / mass : mass / water, 2), less ? "less" : "more");
}

void doubt_masses(const Scene& scene, std::vector<Finding>& findings) {
    const double rho = scene.water.density;
    const std::string unit = scene.spanwise_unit("kg");
    if (scene.hull_is_free()) {
        const double mass = scene.hull->free->motion.mass.mass, water = rho * scene.hull->still.volume;
        if (mass < 0.1 * water || mass > 10 * water)
            warn_of(findings, "odd_mass",
                    fmt::format(
                        "the hull's mass is {} the {} of water that it displaces at its draft; a number is in kg, and "
                        "\"{} t\" in tonnes",
                        against(mass, water, unit), plain_number(water), plain_number(mass)));
    }
    for (const MovingBody& b : scene.bodies) {
        const double mass = b.motion.mass.mass, water = rho * mass_properties(b.surface).volume;
        if (b.elastic || b.motion.law || !(mass > 0) || !(water > 0)) continue;
        if (mass < 0.02 * water || mass > 25 * water)
            warn_of(findings, "odd_mass",
                    fmt::format("the mass of body {} is {} the {} of water that it would displace fully submerged; "
                                "masses are in kg, "
                                "densities in kg/m3, unless a unit is given",
                                b.name, against(mass, water, unit), plain_number(water)));
    }
}

/// How far up the water at the start stands round a body that touches the floor [m]; nothing: it stands dry.
std::optional<double> level_round(const MovingBody& body, const Scene& scene) {
    if (std::ranges::none_of(walls_touched(body, scene), [](const MetWall& w) { return w.axis == 2 && !w.high; }))
        return {};
    const double near = scene.resolution.near_hull;
    const Box at = body.surface.bounds();
    std::optional<double> level;
    for (const Box& block : blocks_of_water(scene))
        if (block.min.z() <= at.min.z() + near && gap_of_boxes(at, block) <= near)
            level = std::max(level.value_or(-HUGE_VAL), block.max.z());
    return level;
}

/// Measured with particles of 10 mm, a block 0.2 m wide in 0.15 m of water: at 1.2 and 1.5 times what lifts it the
/// water's sound opened the gap under it and raised it by up to 14 mm, at 1.8 times and more it stayed (decision 032).
void doubt_standing(const Scene& scene, std::vector<Finding>& findings) {
    constexpr double held_surely = 2;
    for (const MovingBody& b : scene.bodies) {
        const std::optional<double> level = level_round(b, scene);
        if (!level) continue;
        Surface below = b.surface;
        for (Vec3& p : below.points) p.z() -= *level;
        const double lifted = scene.water.density * hydrostatics(below).volume, mass = b.motion.mass.mass;
        if (mass < lifted || mass >= held_surely * lifted) continue;
        warn_of(findings, "hardly_standing",
                fmt::format("body {} stands on the floor and weighs {} times its buoyancy; under a body that weighs "
                            "less than {:g} times its buoyancy, sound waves in the particles' water open the gap and "
                            "may lift it although it should stay: whether and when it rises is not predicted",
                            b.name, plain_number(mass / lifted, 2), held_surely));
    }
}

void doubt_table(const MotionLaw& law, const std::string& whose, double duration, std::vector<Finding>& findings) {
    if (law.kind != MotionLaw::Kind::table || law.times.back() >= duration * (1 - 1e-9)) return;
    const double rate = law.at(law.times.back()).rate;
    if (rate == 0) return;
    warn_of(findings, "table_moves_on",
            fmt::format(
                "the table of {} ends at {} s while it moves at {} {}, and the run lasts {} s: it keeps that velocity, "
                "and its acceleration of {} {} stops there",
                whose, plain_number(law.times.back()), plain_number(rate), law.turns ? "rad/s" : "m/s",
                plain_number(duration),
                plain_number(law.at(law.times.back() - 1e-6 * (law.times.back() - law.times.front())).acceleration),
                law.turns ? "rad/s2" : "m/s2"));
}

void list_warnings(std::string& text, const std::vector<Finding>& findings) {
    for (const Finding& f : findings)
        if (f.level == Finding::Level::warning) text += fmt::format("warning: {}: {}\n", f.name, f.message);
}

}  // namespace

std::vector<Finding> doubtful_input(const Scene& scene) {
    std::vector<Finding> findings;
    doubt_water(scene.water, findings);
    doubt_masses(scene, findings);
    doubt_standing(scene, findings);
    if (scene.tank_motion) doubt_table(scene.tank_motion->law, "the tank's motion", scene.run.duration, findings);
    for (const MovingBody& b : scene.bodies)
        if (b.motion.law) doubt_table(*b.motion.law, "body " + b.name, scene.run.duration, findings);
    for (Finding& f : channel_flow(scene)) findings.push_back(std::move(f));
    return findings;
}

std::string warnings_text(const Scene& scene) {
    std::string text;
    list_warnings(text, doubtful_input(scene));
    if (scene.hull) list_warnings(text, scene.hull->findings);
    for (const MovingBody& b : scene.bodies) list_warnings(text, b.findings);
    return text;
}

}  // namespace tw
