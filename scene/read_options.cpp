#include <fmt/format.h>

#include "scene/read.h"

namespace tw {

WaterOptions read_water(Section& s) {
    WaterOptions o;
    Water& w = o.water;
    o.depth = s.number("depth", "m", positive);
    w.density = s.number("density", w.density, "kg/m3", {1, 30000});
    w.kinematic_viscosity = s.number("viscosity", w.kinematic_viscosity, "m2/s", {0, 1});
    w.surface_tension = s.number("surface_tension", w.surface_tension, "N/m", {0, 10});
    w.gravity = s.number("gravity", w.gravity, "m/s2", {0, 1000, true});
    w.air_density = s.number("air_density", w.air_density, "kg/m3", {0, 100, true});
    w.air_kinematic_viscosity = s.number("air_viscosity", w.air_kinematic_viscosity, "m2/s", {0, 1});
    w.atmospheric_pressure = s.number("atmospheric_pressure", w.atmospheric_pressure, "Pa", {0, 1e9});
    w.vapour_pressure = s.number("vapour_pressure", w.vapour_pressure, "Pa", {0, 1e9});
    s.finish();
    return o;
}

Motion read_motion(Section& s, bool has_hull) {
    Motion o;
    const std::string kind = s.choice("kind", has_hull ? "stream" : "none", {"stream", "none", "prescribed", "free"});
    if (kind == "prescribed" || kind == "free")
        s.fail("kind",
               "this version solves a fixed hull only; expected \"stream\" (uniform stream) or \"none\" (still water)");
    if (kind == "stream") {
        o.kind = Motion::Kind::stream;
        const auto speed = s.number("speed", "m/s", {0, 1000});
        if (!speed) s.fail("speed", "missing; a stream needs a speed, e.g. speed = \"8 m/s\"");
        if (*speed == 0)
            s.fail("speed", "a stream of zero speed; give a speed > 0, or kind = \"none\" for still water");
        o.speed = *speed;
        o.ramp = s.number("ramp", -1, "s", not_negative);
    } else {
        for (const char* key : {"speed", "ramp"})
            if (s.has(key))
                s.fail(key, "there is no stream with kind = \"none\"; remove this key or write kind = \"stream\"");
        s.know("speed");
        s.know("ramp");
    }
    s.finish();
    return o;
}

ResolutionOptions read_resolution(Section& s) {
    ResolutionOptions o;
    o.spacing = s.number("spacing", "m", positive);
    o.near_hull = s.number("near_hull", "m", positive);
    if (o.spacing && o.near_hull && *o.near_hull > *o.spacing)
        s.fail("near_hull",
               fmt::format("coarser than spacing = {:.6g} m; near_hull is the finest, spacing the coarsest size",
                           *o.spacing));
    s.finish();
    return o;
}

DomainOptions read_domain(Section& s) {
    DomainOptions o;
    o.ahead = s.number("ahead", "m", positive);
    o.behind = s.number("behind", "m", positive);
    o.side = s.number("side", "m", positive);
    o.below = s.number("below", "m", positive);
    o.above = s.number("above", "m", positive);
    o.x = s.range("x", "m");
    o.y = s.range("y", "m");
    o.z = s.range("z", "m");
    const auto twice = [&](const char* range, std::initializer_list<const char*> distances) {
        for (const char* d : distances)
            if (s.has(range) && s.has(d)) s.fail(d, fmt::format("given twice: also by {}; keep one of the two", range));
    };
    twice("x", {"ahead", "behind"});
    twice("y", {"side"});
    twice("z", {"below", "above"});
    const double dimensions = s.number("dimensions", 3, "-");
    if (dimensions != 2 && dimensions != 3) s.fail("dimensions", "expected 2 (the x-z plane) or 3");
    o.dimensions = static_cast<int>(dimensions);
    s.finish();
    return o;
}

std::optional<Box> read_tank(Section& s) {
    if (!s.present()) return {};
    const auto size = s.vector("size", "m");
    const auto min = s.vector("min", "m"), max = s.vector("max", "m");
    if (size && (min || max)) s.fail("size", "given twice: also by min and max; keep one of the two");
    if (!size && !(min && max)) s.fail("size", "missing; expected size = [length, width, height], or min and max");
    Box box{min.value_or(Vec3::Zero()), max.value_or(Vec3::Zero())};
    if (size) box.max = *size;
    if (!(box.size().array() > 0).all())
        s.fail(size ? "size" : "max", "the tank has no volume; expected every edge > 0");
    s.finish();
    return box;
}

Run read_run(Section& s) {
    Run o;
    o.duration = s.number("duration", o.duration, "s", positive);
    o.methods = s.texts("methods", {"sph", "fvm"}).value_or(std::vector<std::string>{"sph", "fvm"});
    const double threads = s.number("threads", 0, "-", {0, 4096});
    if (threads != static_cast<int>(threads)) s.fail("threads", "expected a whole number; 0 for all cores");
    o.threads = static_cast<int>(threads);
    o.checkpoint = s.number("checkpoint", o.checkpoint, "s", positive);
    s.finish();
    return o;
}

SamplingOptions read_sampling(Section& s, std::vector<Section>& probes) {
    SamplingOptions o;
    o.sampling.interval = s.number("interval", 0, "s", positive);
    o.sampling.mean_from = s.number("mean_from", 0, "s", positive);
    o.sampling.snapshot_interval = s.number("snapshots", 0, "s", not_negative);
    o.raster_spacing = s.number("raster_spacing", "m", positive);
    o.sampling.cuts_x = s.numbers("cuts_x", "m").value_or(std::vector<double>{});
    o.sampling.cuts_y = s.numbers("cuts_y", "m").value_or(std::vector<double>{});
    s.finish();
    for (Section& p : probes) {
        const bool pressure = p.has("pressure");
        if (pressure == p.has("height")) p.fail("pressure", "expected either pressure = [x, y, z] or height = [x, y]");
        if (pressure) {
            const std::string name = p.identifier("name", fmt::format("P{}", o.sampling.pressure.size() + 1));
            o.sampling.pressure.push_back({name, *p.vector("pressure", "m")});
        } else {
            const std::string name = p.identifier("name", fmt::format("H{}", o.sampling.height.size() + 1));
            const auto place = *p.numbers("height", "m", 2);
            o.sampling.height.push_back({name, place[0], place[1]});
        }
        p.finish();
    }
    return o;
}

SphOptions read_sph(Section& s) {
    SphOptions o;
    o.h_over_dp = s.number("h_over_dp", o.h_over_dp, "-", {1.1, 3});
    o.c0 = s.number("c0", o.c0, "m/s", positive);
    o.delta = s.number("delta", o.delta, "-", {0, 1});
    o.alpha = s.number("alpha", o.alpha, "-", {0, 1});
    o.scheme = s.choice("scheme", o.scheme,
                        {"symplectic_euler", "kick_drift_kick", "predictor_corrector", "rk4_frozen_diffusion"});
    o.cfl = s.number("cfl", o.cfl, "-", {0, 1, true});
    o.equation_of_state = s.choice("equation_of_state", o.equation_of_state, {"linear", "tait", "mie_grueneisen"});
    o.gamma = s.number("gamma", o.gamma, "-", {1, 20});
    o.shifting = s.number("shifting", o.shifting, "-", {0, 3});
    o.touch_support = s.number("touch_support", o.touch_support, "-", {0.5, 0.999});
    o.smagorinsky = s.number("smagorinsky", o.smagorinsky, "-", {0, 1});
    o.acoustic_damper = s.number("acoustic_damper", o.acoustic_damper, "-", {0, 2, true});
    o.air_c0 = s.number("air_c0", o.air_c0, "m/s", positive);
    s.finish();
    return o;
}

FvmOptions read_fvm(Section& s) {
    FvmOptions o;
    o.max_courant = s.number("max_courant", o.max_courant, "-", {0, 20, true});
    o.max_alpha_courant = s.number("max_alpha_courant", o.max_alpha_courant, "-", {0, 20, true});
    o.interface_compression = s.number("interface_compression", o.interface_compression, "-", {0, 4});
    const double correctors = s.number("correctors", o.correctors, "-", {1, 10});
    if (correctors != static_cast<int>(correctors)) s.fail("correctors", "expected a whole number");
    o.correctors = static_cast<int>(correctors);
    o.openfoam = s.text("openfoam", o.openfoam);
    s.finish();
    return o;
}

std::vector<Box> read_water_blocks(std::vector<Section>& sections) {
    std::vector<Box> blocks;
    for (Section& s : sections) {
        const auto min = s.vector("min", "m"), max = s.vector("max", "m");
        if (!min || !max) s.fail(min ? "max" : "min", "missing; expected min = [x, y, z] and max = [x, y, z]");
        const Box box{*min, *max};
        if (!(box.size().array() > 0).all())
            s.fail("max", "the block has no volume; expected max > min in every direction");
        blocks.push_back(box);
        s.finish();
    }
    return blocks;
}

}  // namespace tw
