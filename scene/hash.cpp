#include "scene/hash.h"

#include <charconv>

#include "base/sha256.h"

namespace tw {
namespace {

class Lines {
public:
    Lines& add(const std::string& name, std::initializer_list<double> values) {
        text_ += name;
        for (const double v : values) {
            char digits[32];
            const auto end = std::to_chars(digits, digits + sizeof digits, v == 0 ? 0.0 : v).ptr;  // no minus zero
            text_ += ' ';
            text_.append(digits, end);
        }
        text_ += '\n';
        return *this;
    }
    Lines& add(const std::string& name, const std::string& word) {
        text_ += name + ' ' + word + '\n';
        return *this;
    }
    Lines& add(const std::string& name, const Vec3& v) { return add(name, {v.x(), v.y(), v.z()}); }
    Lines& add(const std::string& name, const Box& box) {
        return add(name + ".min", box.min).add(name + ".max", box.max);
    }
    const std::string& text() const { return text_; }

private:
    std::string text_;
};

}  // namespace

std::string canonical_text(const Scene& scene) {
    Lines t;
    t.add("format", {1});
    const Water& w = scene.water;
    t.add("water", {w.density, w.kinematic_viscosity, w.surface_tension, w.gravity, w.depth, w.air_density,
                    w.air_kinematic_viscosity});
    t.add("motion", {static_cast<double>(scene.motion.kind), scene.motion.speed});
    t.add("domain", scene.domain.box).add("dimensions", {static_cast<double>(scene.domain.dimensions)});
    const Domain& d = scene.domain;
    for (const Side side : {d.x_min, d.x_max, d.y_min, d.y_max, d.z_min, d.z_max})
        t.add("side", {static_cast<double>(side)});
    t.add("resolution", {scene.resolution.spacing, scene.resolution.near_hull});
    for (const RefinementBox& r : scene.refinement) t.add("refine", r.box).add("level", {static_cast<double>(r.level)});
    if (scene.hull) t.add("hull", scene.hull->hash).add("half", {scene.hull->half ? 1.0 : 0.0});
    for (const Obstacle& o : scene.obstacles) t.add("obstacle", surface_hash(o.surface));
    for (const Box& block : scene.water_blocks) t.add("block", block);
    const Sampling& s = scene.sampling;
    t.add("sampling", {s.interval, s.mean_from});
    t.add("raster", s.raster.origin).add("voxel", {s.raster.spacing});
    for (const int n : s.raster.count) t.add("count", {static_cast<double>(n)});
    for (const PressureProbe& p : s.pressure) t.add("pressure", p.place);
    for (const HeightProbe& p : s.height) t.add("height", {p.x, p.y});
    for (const double x : s.cuts_x) t.add("cut_x", {x});
    for (const double y : s.cuts_y) t.add("cut_y", {y});
    for (const EffectChoice& e : scene.effects) t.add("effect." + e.name, {e.on ? 1.0 : 0.0});
    if (scene.effect_on("cavitation")) t.add("vapour", {w.atmospheric_pressure, w.vapour_pressure});
    return t.text();
}

std::string scene_hash(const Scene& scene) { return sha256_hex(canonical_text(scene)); }

std::string run_hash(const Scene& scene, const std::string& method) {
    Lines t;
    if (method == "sph") {
        const SphOptions& o = scene.sph;
        t.add("sph", {o.h_over_dp, o.c0, o.delta, o.alpha, o.cfl, o.gamma, o.shifting}).add("eos", o.equation_of_state);
        if (o.touch_support != SphOptions{}.touch_support) t.add("touch_support", {o.touch_support});
        if (o.scheme != SphOptions().scheme) t.add("scheme", o.scheme);
        if (scene.effect_on("turbulence")) t.add("smagorinsky", {o.smagorinsky});
        if (scene.effect_on("acoustic_damping")) t.add("acoustic_damper", {o.acoustic_damper});
        if (scene.effect_on("air")) t.add("air_c0", {o.air_c0});
    } else {
        const FvmOptions& o = scene.fvm;
        t.add("fvm", {o.max_courant, o.max_alpha_courant, o.interface_compression, static_cast<double>(o.correctors)});
    }
    return sha256_hex(canonical_text(scene) + t.text());
}

}  // namespace tw
