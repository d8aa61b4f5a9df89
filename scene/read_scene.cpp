#include <fmt/format.h>

#include <cmath>

#include "base/atomic_file.h"
#include "base/errors.h"
#include "meshes/symmetric.h"
#include "scene/attitude.h"
#include "scene/defaults.h"
#include "scene/effects/plan.h"
#include "scene/effects/registry.h"
#include "scene/hash.h"
#include "scene/read.h"

namespace tw {
namespace {

/// Puts a command line option into the document as if it stood in the file; its messages name the option.
void override_key(SceneValue& document, const std::string& section, const std::string& key, const std::string& option,
                  SceneValue value) {
    SceneValue* table = document.find(section);
    if (!table) {
        SceneValue empty;
        empty.kind = SceneValue::Kind::table;
        document.members.emplace_back(section, empty);
        table = &document.members.back().second;
    }
    value.option = option;
    std::erase_if(table->members, [&](const auto& m) { return m.first == key; });
    table->members.emplace_back(key, std::move(value));
}

SceneValue number_value(double number) {
    SceneValue v;
    v.kind = SceneValue::Kind::number;
    v.number = number;
    v.text = fmt::format("{:.10g}", number);
    return v;
}

void apply(const SceneOverrides& o, SceneValue& document) {
    if (o.hull_file) {
        // Only what says how the hull stands in the water outlives a swap; a shape's own parameters would be unknown
        // keys.
        if (SceneValue* hull = document.find("hull"))
            std::erase_if(hull->members, [](const auto& m) {
                static const std::set<std::string> kept{"trim", "heel",   "draft", "position",
                                                        "half", "repair", "unit",  "axes"};
                return !kept.contains(m.first);
            });
        SceneValue file;
        file.kind = SceneValue::Kind::text;
        file.text = o.hull_file->string();
        override_key(document, "hull", "file", "--hull", file);
    }
    if (o.speed) override_key(document, "motion", "speed", "--speed", number_value(*o.speed));
    if (o.spacing) override_key(document, "resolution", "spacing", "--spacing", number_value(*o.spacing));
    if (o.near_hull) override_key(document, "resolution", "near_hull", "--near-hull", number_value(*o.near_hull));
    if (o.duration) override_key(document, "run", "duration", "--duration", number_value(*o.duration));
    if (o.trim) override_key(document, "hull", "trim", "--trim", number_value(*o.trim));
    for (const auto& [name, on] : o.effects) {
        SceneValue value;
        value.kind = SceneValue::Kind::text;
        value.text = on ? "on" : "off";
        override_key(document, "effects", name, "--effect " + name, value);
    }
}

/// Particle spacing and largest cell: as written, else from the hull; the ratio is always a power of two.
Resolution resolution_of(const ResolutionOptions& o, const Hull* hull, Section& s, double scale) {
    Resolution r;
    if (!o.near_hull && !o.spacing && !hull)
        s.fail("near_hull", "missing; a scene without a hull needs its particle spacing, e.g. near_hull = \"0.02 m\"");
    if (o.near_hull)
        r.near_hull = *o.near_hull;
    else
        r.near_hull = hull ? default_near_hull(*hull) : *o.spacing;
    if (!o.near_hull && o.spacing) r.near_hull = std::min(r.near_hull, *o.spacing);
    r.spacing = o.spacing ? snapped_spacing(*o.spacing, r.near_hull) : default_spacing(r.near_hull, hull);
    r.near_hull *= scale;
    r.spacing *= scale;
    r.scale = scale;
    return r;
}

/// A particle that the smallest of `lengths` cannot hold twice, or a cell larger than all of them, is refused here,
/// before anything else follows from the sizes.
void check_sizes(const Resolution& r, std::initializer_list<double> lengths, const char* of_what, Section& s) {
    const auto refuse = [&](const std::string& key, double size, double length, double most) {
        s.fail(key, fmt::format(
                        "too coarse: {:.4g} m{}, but {} is only {:.4g} m wide or long; expected at most {:.3g} m", size,
                        r.scale == 1 ? "" : fmt::format(" with --scale {:g}", r.scale), of_what, length, most));
    };
    const double shortest = std::min(lengths), longest = std::max(lengths);
    if (r.near_hull > 0.5 * shortest)
        refuse(s.has("near_hull") || !s.has("spacing") ? "near_hull" : "spacing", r.near_hull, shortest,
               0.5 * shortest);
    if (r.spacing > longest) refuse("spacing", r.spacing, longest, longest);
}

/// A face that the user gave goes to the nearest multiple of the particle spacing, one that follows from the hull
/// outward to a multiple of the largest cell. Still water, z = 0, is a multiple of both.
double snapped_face(double face, bool given, bool high, const Resolution& r) {
    if (given) return std::round(face / r.near_hull) * r.near_hull;
    return (high ? std::ceil(face / r.spacing - 1e-6) : std::floor(face / r.spacing + 1e-6)) * r.spacing;
}

/// The run would be stopped as soon as the water moves faster than its sound.
void check_sound_speed(const Scene& scene) {
    const double fastest = 0.1 * default_sound_speed(scene);
    if (scene.sph.c0 <= fastest)
        throw InputError(
            fmt::format("{}: not above the speed of the water, {:.4g} m/s; expected about {:.4g} m/s, ten "
                        "times that speed",
                        scene.place_of("sph.c0"), fastest, 10 * fastest));
}

/// The box as asked and as it is solved; the rest of the domain is left at its defaults.
Domain stream_domain(const DomainOptions& o, const Scene& scene, std::optional<double> water_depth) {
    Box box;
    bool floor_given = o.z || o.below;
    if (scene.hull) {
        const Box hull = scene.hull->surface.bounds();
        const Margins m = default_margins(*scene.hull, scene.motion.speed, scene.water.gravity);
        const double side = o.side.value_or(m.side);
        const double below = o.below.value_or(std::min(water_depth.value_or(m.below), m.below));
        floor_given = floor_given || (water_depth && *water_depth <= m.below);
        box.min = {hull.min.x() - o.ahead.value_or(m.ahead), -side, -below};
        box.max = {hull.max.x() + o.behind.value_or(m.behind), side, o.above.value_or(m.above)};
    }
    if (o.x) std::tie(box.min.x(), box.max.x()) = *o.x;
    if (o.y) std::tie(box.min.y(), box.max.y()) = *o.y;
    if (o.z) std::tie(box.min.z(), box.max.z()) = *o.z;
    if (scene.hull && scene.hull->half) box.min.y() = 0;
    Domain d;
    d.as_asked = box;
    const bool low_given[] = {o.x || o.ahead, o.y || o.side, floor_given};
    const bool high_given[] = {o.x || o.behind, o.y || o.side, o.z || o.above};
    for (int axis = 0; axis < 3; ++axis) {
        box.min[axis] = snapped_face(box.min[axis], low_given[axis], false, scene.resolution);
        box.max[axis] = snapped_face(box.max[axis], high_given[axis], true, scene.resolution);
    }
    d.box = box;
    return d;
}

/// Of a half model the part at y > 0 is solved.
void check_half_range(double low, double high, Section& s, const std::string& key) {
    if (!(high > 0) || (low != 0 && low != -high))
        s.fail(key,
               fmt::format("a half model is solved from y = 0 on, and here y runs from {:.6g} to {:.6g} m; expected y "
                           "from 0, or the same distance to both sides",
                           low, high));
}

Domain domain_of(const DomainOptions& o, const std::optional<Box>& tank, Scene& scene, Sections& s,
                 std::optional<double> depth) {
    Domain d;
    const bool stream = scene.motion.kind == Motion::Kind::stream;
    if (tank) {
        if (stream)
            s.tank.fail("size",
                        "a tank has walls all round and no stream; use [domain] for a stream, or kind = \"none\"");
        if (!o.empty()) s.domain.fail("x", "[tank] already says how large the domain is; keep one of the two");
        d.box = *tank;
        if (scene.hull && scene.hull->half) {
            check_half_range(d.box.min.y(), d.box.max.y(), s.tank, s.tank.has("size") ? "size" : "min");
            d.box.min.y() = 0;
        }
        d.as_asked = d.box;
    } else {
        if (scene.hull && scene.hull->half && o.y) check_half_range(o.y->first, o.y->second, s.domain, "y");
        if (!scene.hull && !(o.x && o.z && (o.y || o.dimensions == 2)))
            s.domain.fail(stream ? "x" : "size",
                          "missing; a scene without a hull needs [domain] x, y and z ranges, or a [tank]");
        d = stream_domain(o, scene, depth);
    }
    d.dimensions = o.dimensions;
    if (!scene.hull) {
        const Vec3 size = d.as_asked.size();
        check_sizes(scene.resolution, {size.x(), o.dimensions == 2 ? size.x() : size.y(), size.z()},
                    tank ? "the tank" : "the domain", s.resolution);
    }
    if (o.dimensions == 2) {
        if (scene.hull) s.domain.fail("dimensions", "a hull needs 3 dimensions in this version");
        d.box.max.y() = 0.5 * scene.resolution.near_hull;  // one particle thick, round the plane y = 0
        d.box.min.y() = -d.box.max.y();
        d.as_asked.min.y() = d.as_asked.max.y() = 0;
    }
    if (stream) {
        d.x_min = Side::inlet;
        d.x_max = Side::outlet;
    }
    if (scene.hull && scene.hull->half) d.y_min = Side::symmetry;
    if (o.dimensions == 2) d.y_min = d.y_max = Side::symmetry;
    return d;
}

void check_hull_place(const Scene& scene, Sections& s, const std::string& key) {
    const Hull& hull = *scene.hull;
    const Box bounds = hull.surface.bounds();
    if (hull.still.volume <= 0)
        s.hull.fail(
            "draft",
            fmt::format("the hull displaces no water at draft {:.6g} m; expected it to reach below z = 0", hull.draft));
    const Box& domain = scene.domain.box;
    const double room = 4 * scene.resolution.near_hull;
    static constexpr const char* axis_names[] = {"x", "y", "z"};
    static constexpr const char* low_keys[] = {"ahead", "side", "below"};
    static constexpr const char* high_keys[] = {"behind", "side", "above"};
    for (int axis = 0; axis < 3; ++axis) {
        const bool mirrored = axis == 1 && hull.half;
        const bool low = !mirrored && bounds.min[axis] < domain.min[axis] + room;
        if (!low && bounds.max[axis] <= domain.max[axis] - room) continue;
        const auto a = static_cast<std::size_t>(axis);
        const bool beyond = bounds.max[axis] > domain.max[axis] || (!mirrored && bounds.min[axis] < domain.min[axis]);
        const std::string message = fmt::format(
            "the hull {} the domain: in {} it spans {:.6g} to {:.6g} m, the domain {:.6g} to {:.6g} m; "
            "expected at least {:.3g} m (four particles) between them",
            beyond ? "is larger than" : "comes too close to a side of", axis_names[a], bounds.min[axis],
            bounds.max[axis], domain.min[axis], domain.max[axis], room);
        if (s.tank.present()) s.tank.fail(s.tank.has("size") ? "size" : "max", message);
        const std::string nearest = s.domain.has(axis_names[a]) ? axis_names[a] : low ? low_keys[a] : high_keys[a];
        if (s.domain.has(nearest)) s.domain.fail(nearest, message);
        if (axis == 2 && low && s.water.has("depth")) s.water.fail("depth", message);
        s.hull.fail(key, message);
    }
}

/// A half model is solved at y > 0 and reported twice. Sides that differ by more than rounding, but by less than the
/// particles can tell (a tenth of their spacing, at the scale that the scene was written for), are made alike.
void make_halves_alike(Hull& hull, const Resolution& resolution, Section& s) {
    const Asymmetry off = asymmetry(hull.surface);
    const double rounding = 1e-6 * hull.length;
    if (off.distance <= rounding) return;
    const double limit = std::max(0.1 * resolution.near_hull / resolution.scale, 1e-3 * hull.beam);
    const std::string where = fmt::format("near ({:.4g}, {:.4g}, {:.4g}) m the two sides differ by {:.3g} m",
                                          off.place.x(), off.place.y(), off.place.z(), off.distance);
    if (off.distance <= limit) {
        Surface alike = made_symmetric(hull.surface, off.distance);
        if (usable(check_surface(alike))) {
            hull.surface = std::move(alike);
            hull.findings.push_back(
                {Finding::Level::note, "made_symmetric",
                 where + ", less than a tenth of near_hull or a thousandth of the beam; both sides were "
                         "made from the side at y > 0",
                 off.place});
            return;
        }
    }
    s.fail("half", "the hull is not symmetric about y = 0: " + where + "; set half = false");
}

void check_health(HullOptions& o, double particle_spacing, Section& s) {
    Hull& hull = o.hull;
    hull.findings = check_surface(o.as_read, particle_spacing);
    if (o.repair) {
        Repaired repaired = repair_surface(o.as_read);
        hull.repairs = std::move(repaired.done);
        o.as_read = std::move(repaired.surface);
        hull.surface = posed(o.as_read, o.pose);
        hull.findings = check_surface(o.as_read, particle_spacing);
    }
    for (const Finding& f : hull.findings)
        if (f.level == Finding::Level::error)
            s.fail(o.key, fmt::format("{}: {}{}", f.name, f.message,
                                      o.repair     ? " (repair = true could not repair it)"
                                      : f.mendable ? "; repair = true repairs it"
                                                   : ""));
}

void check_places(Scene& scene, Sections& s) {
    const Box& box = scene.domain.box;
    const auto outside = [&](const Vec3& p, double slack) {
        return !Box{(box.min.array() - slack).matrix(), (box.max.array() + slack).matrix()}.contains(p);
    };
    const std::string range = fmt::format("the domain spans ({:.6g}, {:.6g}, {:.6g}) to ({:.6g}, {:.6g}, {:.6g}) m",
                                          box.min.x(), box.min.y(), box.min.z(), box.max.x(), box.max.y(), box.max.z());
    const double slack = 1e-6 * box.size().maxCoeff();
    for (std::size_t i = 0; i < scene.water_blocks.size(); ++i) {
        Box& block = scene.water_blocks[i];
        if (scene.domain.dimensions == 2) {
            block.min.y() = box.min.y();
            block.max.y() = box.max.y();
        }
        for (const char* key : {"min", "max"})
            if (outside(key == std::string("min") ? block.min : block.max, slack))
                s.water_blocks[i].fail(key, "outside the domain; " + range);
    }
    for (std::size_t i = 0; i < scene.obstacles.size(); ++i) {
        Obstacle& o = scene.obstacles[i];
        if (scene.domain.dimensions == 2 && s.obstacles[i].has("min")) {  // a box reaches through the whole thickness
            const double high = o.surface.bounds().max.y();
            for (Vec3& p : o.surface.points) p.y() = p.y() == high ? box.max.y() : box.min.y();
        }
        const Box at = o.surface.bounds();
        if (((at.max - box.min).array() <= 0).any() || ((box.max - at.min).array() <= 0).any())
            s.obstacles[i].fail(s.obstacles[i].has("min") ? "min" : "position",
                                "the obstacle lies outside the domain; " + range);
    }
    std::size_t pressure = 0, height = 0;
    for (Section& probe : s.probes) {
        if (probe.has("pressure")) {
            Vec3& place = scene.sampling.pressure[pressure++].place;
            if (scene.domain.dimensions == 2) place.y() = 0.5 * (box.min.y() + box.max.y());
            if (outside(place, slack)) probe.fail("pressure", "outside the domain; " + range);
        } else {
            HeightProbe& place = scene.sampling.height[height++];
            if (scene.domain.dimensions == 2) place.y = 0.5 * (box.min.y() + box.max.y());
            if (outside({place.x, place.y, box.min.z()}, slack)) probe.fail("height", "outside the domain; " + range);
        }
    }
}

void note_places(const Sections& s, Scene& scene) {
    for (const Section* section :
         {&s.hull, &s.water, &s.motion, &s.resolution, &s.domain, &s.run, &s.sampling, &s.tank, &s.sph, &s.fvm})
        for (const SceneKey& key : scene_keys())
            if (key.section == section->name() && section->has(key.name))
                scene.places[key.section + "." + key.name] = section->where(key.name);
}

template <class List>
void refuse_same_names(const List& items, std::vector<Section>& sections) {
    for (std::size_t i = 0; i < items.size(); ++i)
        for (std::size_t j = 0; j < i; ++j)
            if (items[i].name == items[j].name)
                sections[i].fail("name",
                                 fmt::format("'{}' is taken already; give every one its own name", items[i].name));
}

}  // namespace

Sections split_sections(const std::filesystem::path& file, const SceneValue& document) {
    Section root(file, "", &document);
    const auto one = [&](const std::string& name) {
        root.know(name);
        const SceneValue* table = document.find(name);
        if (table && table->kind != SceneValue::Kind::table) root.fail(name, "expected a section [" + name + "]");
        return Section(file, name, table);
    };
    const auto many = [&](const std::string& name) {
        root.know(name);
        std::vector<Section> all;
        const SceneValue* list = document.find(name);
        if (!list) return all;
        if (list->kind != SceneValue::Kind::list) root.fail(name, "expected a list of sections [[" + name + "]]");
        for (const SceneValue& item : list->list) {
            if (item.kind != SceneValue::Kind::table) root.fail(name, "expected a list of sections [[" + name + "]]");
            all.emplace_back(file, "[" + name + "]", &item);
        }
        return all;
    };
    Sections s{root,          one("hull"),    one("water"),     one("motion"), one("resolution"),
               one("domain"), one("run"),     one("sampling"),  one("tank"),   one("sph"),
               one("fvm"),    one("effects"), many("obstacle"), many("probe"), many("water_block")};
    s.root = root;
    s.root.know("title");
    s.root.finish();
    return s;
}

Scene read_scene(const std::filesystem::path& file, const SceneOverrides& overrides) {
    Scene scene;
    scene.file = file;
    scene.text = read_text(file);
    SceneValue document = parse_document(scene.text, file);
    apply(overrides, document);
    Sections s = split_sections(file, document);
    scene.title = s.root.text("title", file.stem().string());

    note_places(s, scene);
    const std::optional<double> depth = read_water(s.water, scene),
                                ramp = read_motion(s.motion, scene, s.hull.present()),
                                voxel = read_sampling(s.sampling, s.probes, scene);
    for (Section* section : {&s.run, &s.sph, &s.fvm}) {
        section->read_into(scene);
        section->finish();
    }
    const ResolutionOptions resolution = read_resolution(s.resolution);
    const DomainOptions domain = read_domain(s.domain);
    const std::optional<Box> tank = read_tank(s.tank);
    scene.water_blocks = read_water_blocks(s.water_blocks);
    for (std::size_t i = 0; i < s.obstacles.size(); ++i)
        scene.obstacles.push_back(read_obstacle(s.obstacles[i], i + 1));
    refuse_same_names(scene.obstacles, s.obstacles);

    std::optional<HullOptions> hull;
    if (s.hull.present()) {
        hull = read_hull(s.hull);
        const auto measure = [&] {
            const Vec3 size = hull->hull.surface.bounds().size();
            hull->hull.length = size.x();
            hull->hull.beam = size.y();
        };
        measure();
        scene.resolution = resolution_of(resolution, &hull->hull, s.resolution, overrides.scale_resolution.value_or(1));
        check_health(*hull, scene.resolution.near_hull, s.hull);
        measure();
        check_sizes(scene.resolution, {hull->hull.length, hull->hull.beam}, "the hull", s.resolution);
        if (hull->hull.half) make_halves_alike(hull->hull, scene.resolution, s.hull);
        hull->hull.hash = surface_hash(hull->hull.surface);
        hull->hull.mass = mass_properties(hull->hull.surface);
        hull->hull.still = hydrostatics(hull->hull.surface);
        scene.hull = hull->hull;
    } else {
        scene.resolution = resolution_of(resolution, nullptr, s.resolution, overrides.scale_resolution.value_or(1));
    }
    // A stream without a hull has no length to settle over: its ramp is the domain's, so the domain comes first.
    scene.domain = domain_of(domain, tank, scene, s, depth);
    if (scene.hull) {
        check_hull_place(scene, s, hull->key);
        for (Finding& f : check_attitude(*scene.hull, scene.resolution.near_hull))
            scene.hull->findings.push_back(std::move(f));
    }
    if (scene.motion.kind == Motion::Kind::stream && !scene.water_blocks.empty())
        s.water_blocks[0].fail(
            "min", "a stream fills all below z = 0 with water; water blocks belong to still scenes (kind = \"none\")");
    if (!(scene.domain.box.min.z() < 0) && scene.water_blocks.empty())
        s.domain.fail("z",
                      "there is no water: still water is z = 0, and the domain begins above it; expected a floor below "
                      "z = 0, or [[water_block]]");
    check_places(scene, s);

    scene.water.depth = water_height(scene) + (scene.domain.as_asked.min.z() - scene.domain.box.min.z());
    scene.motion.ramp = ramp.value_or(default_ramp(scene));
    fill_times(scene);
    for (double* courant : {&scene.fvm.max_courant, &scene.fvm.max_alpha_courant})
        if (*courant == 0) *courant = default_courant(scene);
    if (scene.sph.c0 == 0) scene.sph.c0 = default_sound_speed(scene);
    check_sound_speed(scene);
    scene.sph.c0 *= overrides.sound_speed_factor;
    scene.sph.cfl *= overrides.time_step_factor;
    scene.fvm.max_courant *= overrides.courant_factor;
    scene.fvm.max_alpha_courant *= overrides.courant_factor;
    scene.refinement = default_refinement(scene);
    const double two_particles = (scene.domain.dimensions == 2 ? 1 : 2) * scene.resolution.near_hull;
    scene.sampling.raster = default_raster(scene, voxel.value_or(two_particles));
    scene.sampling.raster.chosen = voxel.has_value();
    if (voxel && voxels(scene.sampling.raster) > most_voxels)
        s.sampling.fail(
            "raster_spacing",
            fmt::format("makes a raster of more than {:.0e} voxels; expected about {:.3g} m, twice near_hull",
                        most_voxels, two_particles));
    scene.effects = plan_effects(scene, s.effects);
    scene.hash = scene_hash(scene);
    return scene;
}

std::string Scene::place_of(const std::string& key) const {
    const auto found = places.find(key);
    if (found != places.end()) return found->second;
    const std::size_t dot = key.find('.');
    return fmt::format("{}: [{}] {}", file.string(), key.substr(0, dot), key.substr(dot + 1));
}

bool Scene::effect_on(const std::string& name) const {
    const std::string& known = effect_part(name).name;
    for (const EffectChoice& e : effects)
        if (e.name == known) return e.on;
    return false;
}

}  // namespace tw
