#include <cmath>
#include <set>

#include <fmt/format.h>

#include "scene/read/read.h"

namespace tw {

std::optional<double> read_water(SceneSection& s, Scene& scene) {
    const auto depth = s.number("depth");
    s.read_into(scene);
    s.finish();
    return depth;
}

std::optional<double> read_motion(SceneSection& s, Scene& scene, bool has_hull) {
    const std::string asked = s.text("kind", "");
    if (asked == "prescribed" || asked == "free")
        s.fail("kind",
               "this version solves a fixed hull only; expected \"stream\" (uniform stream) or \"none\" (still water; "
               "solids "
               "that move are [[body]])");
    const bool stream = s.choice("kind").value_or(has_hull ? "stream" : "none") == "stream";
    scene.motion.kind = stream ? Motion::Kind::stream : Motion::Kind::none;
    if (!stream)
        for (const char* key : {"speed", "ramp"})
            if (s.has(key))
                s.fail(key, "there is no stream with kind = \"none\"; remove this key or write kind = \"stream\"");
    const auto ramp = s.number("ramp");
    s.read_into(scene);
    if (stream && !s.has("speed")) s.fail("speed", "missing; a stream needs a speed, e.g. speed = \"8 m/s\"");
    s.finish();
    return ramp;
}

ResolutionOptions read_resolution(SceneSection& s) {
    ResolutionOptions o;
    o.spacing = s.number("spacing");
    o.near_hull = s.number("near_hull");
    if (o.spacing && o.near_hull && *o.near_hull > *o.spacing)
        s.fail("near_hull",
               fmt::format("coarser than spacing = {:.6g} m; near_hull is the finest, spacing the coarsest size",
                           *o.spacing));
    s.finish();
    return o;
}

DomainOptions read_domain(SceneSection& s) {
    DomainOptions o;
    o.ahead = s.number("ahead");
    o.behind = s.number("behind");
    o.side = s.number("side");
    o.below = s.number("below");
    o.above = s.number("above");
    o.x = s.range("x");
    o.y = s.range("y");
    o.z = s.range("z");
    const auto twice = [&](const char* range, std::initializer_list<const char*> distances) {
        for (const char* d : distances)
            if (s.has(range) && s.has(d)) s.fail(d, fmt::format("given twice: also by {}; keep one of the two", range));
    };
    twice("x", {"ahead", "behind"});
    twice("y", {"side"});
    twice("z", {"below", "above"});
    o.dimensions = s.whole("dimensions").value_or(o.dimensions);
    s.finish();
    return o;
}

std::optional<Box> read_tank(SceneSection& s) {
    if (!s.present()) return {};
    const auto size = s.vector("size");
    const auto min = s.vector("min"), max = s.vector("max");
    if (size && (min || max)) s.fail("size", "given twice: also by min and max; keep one of the two");
    if (!size && !(min && max)) s.fail("size", "missing; expected size = [length, width, height], or min and max");
    Box box{min.value_or(Vec3::Zero()), max.value_or(Vec3::Zero())};
    if (size) box.max = *size;
    if (!(box.size().array() > 0).all())
        s.fail(size ? "size" : "max", "the tank has no volume; expected every edge > 0");
    s.finish();
    return box;
}

std::optional<double> read_sampling(SceneSection& s, std::vector<SceneSection>& probes, Scene& scene) {
    const auto raster_spacing = s.number("raster_spacing");
    s.read_into(scene);
    s.finish();
    Sampling& sampling = scene.sampling;
    std::set<std::string> of_pressures, of_heights;
    const auto take = [](std::set<std::string>& taken, const std::string& name, const SceneSection& p) {
        if (!taken.insert(name).second)
            p.fail("name", fmt::format("the name {} is taken; give every probe its own", name));
    };
    for (SceneSection& p : probes) {
        const auto pressure = p.vector("pressure");
        const auto height = p.numbers("height");
        if (pressure.has_value() == height.has_value())
            p.fail("pressure", "expected either pressure = [x, y, z] or height = [x, y]");
        const Sampling of_keys = p.entry().sampling;
        const double filter = of_keys.pressure.front().filter;
        if (pressure) {
            if (p.has("deck"))
                p.fail("deck", "a deck is a level of a height; expected slam, a pressure, or remove this key");
            const std::string name = p.identifier("name", fmt::format("P{}", sampling.pressure.size() + 1));
            take(of_pressures, name, p);
            sampling.pressure.push_back({name, *pressure, filter, of_keys.pressure.front().slam});
        } else {
            if (p.has("slam"))
                p.fail("slam", "a slam is a peak of a pressure; expected deck, a level, or remove this key");
            const std::string name = p.identifier("name", fmt::format("H{}", sampling.height.size() + 1));
            take(of_heights, name, p);
            sampling.height.push_back({name, (*height)[0], (*height)[1], filter, of_keys.height.front().deck});
        }
        p.finish();
    }
    return raster_spacing;
}

std::vector<WaterBox> read_volumes(std::vector<SceneSection>& sections) {
    std::vector<WaterBox> all;
    std::set<std::string> taken;
    for (SceneSection& s : sections) {
        const std::string name = s.identifier("name", fmt::format("V{}", all.size() + 1));
        if (!taken.insert(name).second)
            s.fail("name", fmt::format("the name {} is taken; give every box its own", name));
        all.push_back({name, read_box(s)});
        s.finish();
    }
    return all;
}

Box read_box(SceneSection& s) {
    const auto min = s.vector("min"), max = s.vector("max");
    if (!min || !max) s.fail(min ? "max" : "min", "missing; expected min = [x, y, z] and max = [x, y, z]");
    const Box box{*min, *max};
    if (!(box.size().array() > 0).all()) s.fail("max", "the box has no volume; expected max > min in every direction");
    return box;
}

std::vector<Box> read_water_blocks(std::vector<SceneSection>& sections) {
    constexpr std::size_t most = 2000;
    std::vector<Box> blocks;
    for (SceneSection& s : sections) {
        blocks.push_back(read_box(s));
        if (blocks.size() > most)
            s.fail("min", fmt::format("{} blocks of water; expected at most {}: join those that make one box",
                                      sections.size(), most));
        s.finish();
    }
    return blocks;
}

}  // namespace tw
