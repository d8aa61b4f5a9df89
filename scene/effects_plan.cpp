#include "scene/effects_plan.h"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>

#include "scene/defaults.h"

namespace tw {
namespace {

/// Area below still water that the stream along x can rub on [m2]: each triangle's wet part, less as it faces the
/// stream.
double friction_area(const Surface& surface) {
    double total = 0;
    for (std::size_t t = 0; t < surface.triangles.size(); ++t) {
        const Vec3 twice = surface.area_vector2(static_cast<int>(t));
        const double area = 0.5 * twice.norm();
        if (area == 0) continue;
        // Corners from the lowest up; the plane z = 0 cuts off a similar triangle below (or above) it.
        std::array<double, 3> z{};
        for (int k = 0; k < 3; ++k) z[static_cast<std::size_t>(k)] = surface.corner(static_cast<int>(t), k).z();
        std::sort(z.begin(), z.end());
        double wet = z[2] <= 0 ? 1 : 0;
        if (z[0] < 0 && z[1] >= 0)
            wet = z[0] * z[0] / ((z[1] - z[0]) * (z[2] - z[0]));
        else if (z[1] < 0 && z[2] > 0)
            wet = 1 - z[2] * z[2] / ((z[2] - z[0]) * (z[2] - z[1]));
        const double normal_x = twice.x() / twice.norm();
        total += wet * area * std::sqrt(std::max(0.0, 1 - normal_x * normal_x));
    }
    return total;
}

/// Length, speed and wetted area that the dimensionless numbers are made of.
struct Scales {
    double length, speed, wetted_area;
};

Scales scales_of(const Scene& scene) {
    const double fall = std::sqrt(2 * scene.water.gravity * water_height(scene));
    const double speed = scene.motion.kind == Motion::Kind::stream ? scene.motion.speed : fall;
    if (!scene.hull) return {water_height(scene), speed, 0};
    return {std::max(scene.hull->still.wet_bounds.size().x(), 1e-9), speed, friction_area(scene.hull->surface)};
}

/// What the decisions are made from.
struct Numbers {
    double length = 0, speed = 0, wetted_area = 0;  ///< [m], [m/s], [m2]
    double head = 0;                                ///< rho U^2/2 [Pa]
    double reynolds = INFINITY, weber = INFINITY, weber_dp = INFINITY, froude = 0, mach = 0, bond = INFINITY;
    double cavitation = INFINITY;  ///< (p_atm + rho g d - p_v) / head at the deepest place
};

Numbers numbers_of(const Scene& scene) {
    const Scales scales = scales_of(scene);
    const Water& w = scene.water;
    Numbers n{scales.length, scales.speed, scales.wetted_area, 0.5 * w.density * scales.speed * scales.speed};
    const double inertia = w.density * n.speed * n.speed;
    if (w.kinematic_viscosity > 0) n.reynolds = n.speed * n.length / w.kinematic_viscosity;
    if (w.surface_tension > 0) {
        n.weber = inertia * n.length / w.surface_tension;
        n.weber_dp = inertia * scene.resolution.near_hull / w.surface_tension;
        n.bond = w.density * w.gravity * n.length * n.length / w.surface_tension;
    }
    n.froude = n.speed / std::sqrt(w.gravity * n.length);
    n.mach = n.speed / scene.sph.c0;
    const double depth = scene.hull ? scene.hull->draft : water_height(scene);
    n.cavitation = (w.atmospheric_pressure + w.density * w.gravity * std::max(0.0, depth) - w.vapour_pressure) / n.head;
    return n;
}

std::string per_cent(double share) { return fmt::format("{:.2g} %", 100 * share); }

/// In the words that every effect uses.
std::string influence(const std::string& drag, const std::string& lift, const std::string& splash,
                      const std::string& remark = "") {
    return fmt::format("drag: {}; lift: {}; splash: {}{}", drag, lift, splash, remark.empty() ? "" : "; " + remark);
}

/// One effect's part of the plan: `asked` is what the scene says, nothing for "auto".
using Asked = std::optional<bool>;
EffectChoice choice(const std::string& name, const Asked& asked, bool automatic) {
    EffectChoice c;
    c.name = name;
    c.forced = asked.has_value();
    c.on = asked.value_or(automatic);
    return c;
}

/// Friction counts for drag; the question is whether the particles can resolve the layer that makes it: laminar
/// boundary layer 5 L / sqrt(Re) at the end of the hull (Blasius 1908) in at least five spacings.
EffectChoice plan_viscosity(const Scene& scene, const Asked& asked, const Numbers& n) {
    const double dp = scene.resolution.near_hull;
    const double layer = std::isfinite(n.reynolds) ? 5 * n.length / std::sqrt(n.reynolds) : 0;
    EffectChoice c = choice("viscosity", asked, layer > 5 * dp);
    const int dimensions = scene.domain.dimensions;
    const double numerical = scene.sph.alpha * scene.sph.h_over_dp * dp * scene.sph.c0 / (2 * (dimensions + 2));
    const double ratio = scene.water.kinematic_viscosity > 0 ? numerical / scene.water.kinematic_viscosity : INFINITY;
    c.reason = fmt::format(
        "Re = {:.3g}: a laminar layer is {:.2g} spacings thick ({}); the particles' numerical viscosity "
        "is {:.2g} times the water's",
        n.reynolds, layer / dp, layer > 5 * dp ? "resolved" : "five would resolve it", ratio);
    if (c.on && ratio > 10) c.reason += ": the friction of the particle side is no prediction";
    if (n.wetted_area > 0) {
        const double cf = std::isfinite(n.reynolds) ? ittc57(n.reynolds) : 0;
        c.influence = influence(
            fmt::format("about {:.3g} N of friction (ITTC 1957, Cf = {:.3g}, {:.3g} m2 wet){}",
                        cf * n.head * n.wetted_area, cf, n.wetted_area, c.on ? "" : ", left out on both sides"),
            "below 1 %", "below 1 %");
    } else {
        c.influence = influence("wall friction", "none", "fronts on dry floors run ahead without it (measured: 14 %)");
    }
    c.cost = 0.20;
    return c;
}

EffectChoice plan_no_slip(const Asked& asked, const EffectChoice& viscosity) {
    EffectChoice c = choice("no_slip", asked, viscosity.on);
    c.reason = viscosity.on ? "follows viscosity: walls hold the water" : "without viscosity walls cannot rub";
    c.influence = influence("all of the friction", "below 1 %", "below 1 %");
    return c;
}

EffectChoice plan_turbulence(const Asked& asked, const EffectChoice& viscosity, const Numbers& n) {
    EffectChoice c = choice("turbulence", asked, viscosity.on && n.reynolds > 5e5);
    c.reason = fmt::format("{} (Re = {:.3g}, 5e5 and above is turbulent){}",
                           viscosity.on ? "follows viscosity" : "follows viscosity, which is off", n.reynolds,
                           c.on ? "; Smagorinsky among particles, k-omega SST in the mesh: the closures differ" : "");
    c.influence = influence("4 % of the pressure drag (measured on a planing hull, air at the transom)",
                            "0.7 % (the same)", "not measured");
    c.cost = 0.37;
    return c;
}

EffectChoice plan_surface_tension(const Scene& scene, const Asked& asked, const Numbers& n) {
    EffectChoice c = choice("surface_tension", asked, n.weber < 100);
    c.reason = fmt::format("We = {:.3g}, Bo = {:.3g}; at the finest size of {:.3g} m We = {:.3g}: {}", n.weber, n.bond,
                           scene.resolution.near_hull, n.weber_dp,
                           n.weber < 100      ? "it acts on the whole flow"
                           : n.weber_dp > 100 ? "inertia rules every resolved scale"
                                              : "it acts on the finest resolved sheets and drops only");
    const std::string share = per_cent(std::min(1.0, 1 / n.weber));
    c.influence = influence(
        share, share,
        fmt::format("drops below {:.2g} m would be held together", 12 * scene.water.surface_tension / (2 * n.head)));
    c.cost = 0.23;
    return c;
}

/// The cushion of air under a flat plate matters below about 3 degrees of deadrise (Verhagen 1967). Among the particles
/// the gas costs its own particles, and its sound sets the time step.
EffectChoice plan_air(const Scene& scene, const Asked& asked, const Numbers& n) {
    EffectChoice c = choice("air", asked, false);
    const double gas = air_volume(scene) / water_volume(scene),
                 steps = std::max(1.0, (scene.sph.air_c0 + n.speed) / (scene.sph.c0 + n.speed));
    c.reason = fmt::format(
        "density ratio {:.2g}: {}; an air cushion matters below 3 deg of deadrise at impact (rho_a/rho U^2 = {:.2g} Pa "
        "here)",
        scene.water.air_density / scene.water.density,
        c.on
            ? fmt::format("among the particles a gas of sound speed {:g} m/s under a lid, in the mesh incompressible "
                          "air; only the water's force is compared",
                          scene.sph.air_c0)
            : "among the particles only on demand, for its cost; the mesh side always carries it, and only the water's "
              "force is compared",
        scene.water.air_density * n.speed * n.speed);
    c.influence = scene.hull ? influence("10 % (measured on dry topsides, shown beside the compared force)",
                                         "3 to 5 % (the same)", "drops are slowed; sheets thinner than a cell hang on")
                             : influence("none", "trapped pockets collapse without it", "not measured");
    c.cost = (1 + gas) * steps - 1;
    return c;
}

EffectChoice plan_compressibility(const Scene& scene, const Numbers& n) {
    EffectChoice c = choice("compressibility", {}, false);
    c.reason = fmt::format(
        "Ma = {:.2g} in real water (1480 m/s); the particle side's artificial Ma is {:.2g} ({} state "
        "equation); structures are rigid, so nothing gives way but the water",
        n.speed / 1480, n.mach, scene.sph.equation_of_state);
    const std::string share = per_cent(n.mach * n.mach);
    c.influence = influence(share, share, share,
                            n.mach > 0.11 ? "density error of the particle side above 1 %: raise [sph] c0"
                                          : "impact peaks shorter than h/c0 are not resolved");
    return c;
}

EffectChoice plan_gravity(const Asked& asked, const Numbers& n) {
    EffectChoice c = choice("gravity", asked, true);
    c.reason = fmt::format("Fr = {:.3g} on the wetted length", n.froude);
    const std::string share = per_cent(1 / (n.froude * n.froude));
    c.influence = influence(share, share, "how far it falls back");
    return c;
}

EffectChoice plan_shifting(const Scene& scene, const Asked& asked) {
    EffectChoice c = choice("shifting", asked, scene.sph.shifting > 0);
    c.reason = c.on
                   ? "keeps particles from lining up along the stream and opening gaps under the hull (numerics of the "
                     "particle side; along a free surface only, not towards it)"
                   : "switched off in the scene";
    c.influence = influence("not measured", "-10 % (measured on a planing hull: without it +10 %)", "not measured");
    c.cost = 0.05;
    return c;
}

EffectChoice plan_tension_control(const Asked& asked) {
    EffectChoice c = choice("tension_control", asked, false);
    c.reason =
        "p_j - p_i in place of p_j + p_i where water inside is under tension (numerics of the particle side): "
        "pairs no longer cancel there, so only on demand";
    c.influence = influence("not measured", "not measured", "none: not near free surfaces");
    return c;
}

EffectChoice plan_acoustic_damping(const Scene& scene, const Asked& asked) {
    EffectChoice c = choice("acoustic_damping", asked, false);
    c.reason = fmt::format(
        "damps sound by a bulk viscosity of {:g} c0 h (particle side only): peaks of impacts fall, so only "
        "on demand",
        scene.sph.acoustic_damper);
    c.influence = influence("none in the mean", "none in the mean", "none", "peak pressures fall, impulses stay");
    c.cost = 0.01;
    return c;
}

EffectChoice plan_cavitation(const Asked& asked, const Numbers& n) {
    EffectChoice c = choice("cavitation", asked, false);
    c.reason = fmt::format("cavitation number {:.3g}: suction stronger than Cp = {:.3g} would cavitate; {}",
                           n.cavitation, -n.cavitation,
                           n.cavitation > 2 ? "none is expected"
                                            : "the mesh side has no cut-off, so neither side has one unless asked for");
    c.influence = n.cavitation > 2
                      ? influence("none", "none", "none")
                      : influence("limits suction behind steps and edges", "the same", "none",
                                  c.on ? "only the particle side solves it" : "see the record's lowest pressure");
    c.cost = 0.01;
    return c;
}

EffectChoice plan_damping_layers(const Scene& scene, const Asked& asked, const Numbers& n) {
    EffectChoice c = choice("damping_layers", asked, false);
    const bool stream = scene.motion.kind == Motion::Kind::stream;
    c.reason = stream
                   ? fmt::format("Fr = {:.3g}: {}", n.froude,
                                 n.froude > 1 ? "waves are swept out before the sides give them back"
                                              : "waves may come back from the sides; the mesh side has no layers, so "
                                                "the domain is widened instead")
                   : "a tank's walls are meant to give waves back";
    c.influence =
        influence("below 1 %", "below 1 %", "waves near the sides", c.on ? "only the particle side solves it" : "");
    c.cost = 0.01;
    return c;
}

}  // namespace

const std::vector<std::string>& effect_names() {
    static const std::vector<std::string> names{
        "viscosity", "no_slip",    "turbulence",     "surface_tension",  "air",      "compressibility",
        "gravity",   "cavitation", "damping_layers", "acoustic_damping", "shifting", "tension_control"};
    return names;
}

std::string effect_needed_by(const std::string& name) {
    return name == "no_slip" || name == "turbulence" ? "viscosity" : "";
}

bool acts_among_particles_only(const std::string& name) {
    static const std::vector<std::string> names{"air",      "cavitation",     "damping_layers", "acoustic_damping",
                                                "shifting", "tension_control"};
    return std::ranges::find(names, name) != names.end();
}

double ittc57(double reynolds) {
    if (reynolds <= 1e4) return 0;
    const double l = std::log10(reynolds) - 2;
    return 0.075 / (l * l);
}

std::vector<EffectChoice> plan_effects(Scene& scene, Section& s) {
    const Numbers n = numbers_of(scene);
    const auto refuse = [&](const std::string& name, const std::string& why) {
        const Asked asked = s.on_off(name);
        if (asked.value_or(false)) s.fail(name, why + "; expected \"off\" or \"auto\"");
        return asked.has_value();
    };
    const auto needs_viscosity = [&](const EffectChoice& c, const EffectChoice& viscosity) {
        if (c.on && !viscosity.on) s.fail(c.name, "needs viscosity = \"on\" beside it");
    };

    std::vector<EffectChoice> plan;
    const EffectChoice viscosity = plan_viscosity(scene, s.on_off("viscosity"), n);
    if (viscosity.on && scene.water.kinematic_viscosity == 0)
        s.fail("viscosity", "the water's viscosity is zero: give [water] viscosity");
    plan.push_back(viscosity);
    plan.push_back(plan_no_slip(s.on_off("no_slip"), viscosity));
    needs_viscosity(plan.back(), viscosity);
    plan.push_back(plan_turbulence(s.on_off("turbulence"), viscosity, n));
    needs_viscosity(plan.back(), viscosity);
    plan.push_back(plan_surface_tension(scene, s.on_off("surface_tension"), n));
    if (plan.back().on && scene.water.surface_tension == 0)
        s.fail("surface_tension", "the water's surface tension is zero: give [water] surface_tension");
    plan.push_back(plan_air(scene, s.on_off("air"), n));
    if (plan.back().on && scene.motion.kind == Motion::Kind::stream)
        s.fail("air",
               "the particle side solves it in tanks alone: in a stream the gas is shut in, and its pressure loads the "
               "hull (measured: a sixth of the lift); expected \"off\" or \"auto\"");
    if (plan.back().on && scene.sph.scheme != "kick_drift_kick" && scene.sph.scheme != "symplectic_euler")
        s.fail("air",
               "needs a time step of one evaluation: [sph] scheme = \"kick_drift_kick\" or \"symplectic_euler\"");
    const bool compressible_said =
        refuse("compressibility", "water is solved as (nearly) incompressible by both methods");
    plan.push_back(plan_compressibility(scene, n));
    plan.back().forced = compressible_said;
    plan.push_back(plan_gravity(s.on_off("gravity"), n));
    plan.push_back(plan_cavitation(s.on_off("cavitation"), n));
    plan.push_back(plan_damping_layers(scene, s.on_off("damping_layers"), n));
    plan.push_back(plan_acoustic_damping(scene, s.on_off("acoustic_damping")));
    const Asked shifting = s.on_off("shifting");
    if (shifting == false) scene.sph.shifting = 0;
    if (shifting == true && scene.sph.shifting == 0) scene.sph.shifting = SphOptions{}.shifting;
    plan.push_back(plan_shifting(scene, shifting));
    plan.push_back(plan_tension_control(s.on_off("tension_control")));
    s.finish();

    for (EffectChoice& c : plan) {
        if (c.name == "gravity" && !c.on) scene.water.gravity = 0;
    }
    return plan;
}

}  // namespace tw
