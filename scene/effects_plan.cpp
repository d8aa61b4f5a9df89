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

void refuse(Section& s, const std::string& name, const std::string& why) {
    if (s.on_off(name).value_or(false)) s.fail(name, why + "; expected \"off\" or \"auto\"");
}

bool said(Section& s, const std::string& name) { return s.on_off(name).has_value(); }

}  // namespace

double ittc57(double reynolds) {
    if (reynolds <= 1e4) return 0;
    const double l = std::log10(reynolds) - 2;
    return 0.075 / (l * l);
}

std::vector<EffectChoice> plan_effects(Scene& scene, Section& s) {
    const Scales scales = scales_of(scene);
    const Water& w = scene.water;
    const double dp = scene.resolution.near_hull;
    const double head = 0.5 * w.density * scales.speed * scales.speed;
    std::vector<EffectChoice> plan;

    refuse(s, "viscosity", "this version's particle side has no physical viscosity, so only one method could solve it");
    const double reynolds = w.kinematic_viscosity > 0 ? scales.speed * scales.length / w.kinematic_viscosity : INFINITY;
    const double cf = std::isfinite(reynolds) ? ittc57(reynolds) : 0;
    EffectChoice viscosity{"viscosity", false, said(s, "viscosity"), "", "", 0};
    viscosity.reason = fmt::format(
        "Re = {:.3g}: the particle side solves no physical viscosity, so both sides are inviscid with slip walls",
        reynolds);
    viscosity.influence =
        scales.wetted_area > 0
            ? fmt::format(
                  "friction left out on both sides: about {:.3g} N of drag (ITTC 1957, Cf = {:.3g}, {:.3g} m2 wet)",
                  cf * head * scales.wetted_area, cf, scales.wetted_area)
            : std::string("wall friction left out on both sides; thin films near the front run slightly ahead");
    plan.push_back(viscosity);

    refuse(s, "turbulence", "turbulence follows viscosity, which this version leaves out on both sides");
    plan.push_back({"turbulence", false, said(s, "turbulence"),
                    fmt::format("follows viscosity, which is off (Re = {:.3g})", reynolds),
                    "measured on a planing hull: lift 0.7 %, pressure drag 4 % (air at the transom)", 0});

    refuse(s, "surface_tension",
           "this version's particle side has no surface tension, so only one method could solve it");
    const double weber =
        w.surface_tension > 0 ? w.density * scales.speed * scales.speed * dp / w.surface_tension : INFINITY;
    plan.push_back(
        {"surface_tension", false, said(s, "surface_tension"),
         fmt::format("We = {:.3g} at the finest size of {:.3g} m: {}", weber, dp,
                     weber > 100 ? "inertia rules every resolved scale"
                                 : "it would act on the finest resolved scales, and the particle side cannot solve it"),
         "drag and lift: none; droplets smaller than the resolution are not described either way", 0});

    refuse(s, "air",
           "the particle side solves no air; the mesh side always carries it and reports its share of the force apart");
    plan.push_back({"air", false, said(s, "air"),
                    fmt::format("density ratio {:.2g}: the particle side has no air; the mesh side carries it, and "
                                "only the water's force is compared",
                                w.air_density / w.density),
                    scene.hull ? "measured on a planing hull: dry topsides feel 3-5 % of lift and 10 % of drag, shown "
                                 "beside the compared force"
                               : "trapped air pockets collapse on the particle side",
                    0});

    refuse(s, "compressibility", "water is solved as (nearly) incompressible by both methods");
    plan.push_back(
        {"compressibility", false, said(s, "compressibility"),
         fmt::format("Ma = {:.2g} in real water (1480 m/s); the particle side's artificial Ma is {:.2g}",
                     scales.speed / 1480, scales.speed / scene.sph.c0),
         scales.speed / scene.sph.c0 > 0.11
             ? "density error of the particle side above 1 %: raise [sph] c0"
             : "density error of the particle side about 1 % or less; impact peaks shorter than h/c0 are not resolved",
         0});

    const auto shifting = s.on_off("shifting");
    if (shifting == false) scene.sph.shifting = 0;
    if (shifting == true && scene.sph.shifting == 0) scene.sph.shifting = SphOptions{}.shifting;
    const bool on = scene.sph.shifting > 0;
    plan.push_back({"shifting", on, shifting.has_value(),
                    on ? "keeps particles from lining up along the stream and opening gaps under the hull (numerics of "
                         "the particle side)"
                       : "switched off in the scene",
                    "measured on a planing hull without it: lift +10 %, pressure at the hull 1.8 times the pair force",
                    on ? 0.05 : 0});
    s.finish();
    return plan;
}

}  // namespace tw
