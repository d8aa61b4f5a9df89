#include "scene/doubtful_input.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

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
                    fmt::format(
                        "the mass of body {} is {} the {} of water that it would displace drowned; masses are in kg, "
                        "densities in kg/m3, unless a unit is given",
                        b.name, against(mass, water, unit), plain_number(water)));
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
    if (scene.tank_motion) doubt_table(scene.tank_motion->law, "the tank's motion", scene.run.duration, findings);
    for (const MovingBody& b : scene.bodies)
        if (b.motion.law) doubt_table(*b.motion.law, "body " + b.name, scene.run.duration, findings);
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
