#include <fmt/format.h>

#include <cmath>
#include <set>

#include "base/read_file.h"
#include "base/errors.h"
#include "scene/attitude.h"
#include "scene/check_scene.h"
#include "scene/defaults.h"
#include "scene/domain.h"
#include "scene/effects/plan.h"
#include "scene/effects/registry.h"
#include "scene/hash.h"
#include "scene/particle_levels.h"
#include "scene/quiet_layer.h"
#include "scene/read.h"
#include "scene/refined_places.h"
#include "scene/vortex_shedding.h"

namespace tw {
namespace {

/// Puts a command line option into the document as if it stood in the file; its messages name the option.
void override_key(TextValue& document, const std::string& section, const std::string& key, const std::string& option,
                  TextValue value) {
    TextValue* table = document.find(section);
    if (!table) {
        TextValue empty;
        empty.kind = TextValue::Kind::table;
        document.members.push_back({section, empty});
        table = &document.members.back().second;
    }
    value.option = option;
    std::erase_if(table->members, [&](const auto& m) { return m.first == key; });
    table->members.push_back({key, std::move(value)});
}

TextValue number_value(double number) {
    TextValue v;
    v.kind = TextValue::Kind::number;
    v.number = number;
    v.text = fmt::format("{:.10g}", number);
    return v;
}

void apply(const SceneOverrides& o, TextValue& document) {
    if (o.hull_file) {
        // Only what says how the hull stands in the water outlives a swap; a shape's own parameters would be unknown
        // keys.
        if (TextValue* hull = document.find("hull"))
            std::erase_if(hull->members, [](const auto& m) {
                static const std::set<std::string> kept{"trim",   "heel", "draft",          "position", "half",
                                                        "repair", "unit", "axes",           "free",     "mass",
                                                        "lcg",    "vcg",  "pitch_gyradius", "release"};
                return !kept.contains(m.first);
            });
        TextValue file;
        file.kind = TextValue::Kind::text;
        file.text = o.hull_file->string();
        override_key(document, "hull", "file", "--hull", file);
    }
    if (o.speed) override_key(document, "motion", "speed", "--speed", number_value(*o.speed));
    if (o.spacing) override_key(document, "resolution", "spacing", "--spacing", number_value(*o.spacing));
    if (o.near_hull) override_key(document, "resolution", "near_hull", "--near-hull", number_value(*o.near_hull));
    if (o.duration) override_key(document, "run", "duration", "--duration", number_value(*o.duration));
    if (o.trim) override_key(document, "hull", "trim", "--trim", number_value(*o.trim));
    for (const auto& [name, on] : o.effects) {
        TextValue value;
        value.kind = TextValue::Kind::text;
        value.text = on ? "on" : "off";
        override_key(document, "effects", name, "--effect " + name, value);
    }
}

void note_places(const Sections& s, Scene& scene) {
    const auto note = [&](const SceneSection& section) {
        for (const SceneKey& key : scene_keys())
            if (key.section == section.name() && section.has(key.name))
                scene.places[key.section + "." + key.name] = section.where(key.name);
    };
    for (const SceneSection* section :
         {&s.hull, &s.water, &s.motion, &s.resolution, &s.domain, &s.run, &s.sampling, &s.tank})
        note(*section);
    for (const auto& [method, section] : s.numerics) note(section);
}

template <class List>
void refuse_same_names(const List& items, std::vector<SceneSection>& sections) {
    std::set<std::string> taken;
    for (std::size_t i = 0; i < items.size(); ++i)
        if (!taken.insert(items[i].name).second)
            sections[i].fail("name", fmt::format("'{}' is taken already; give every one its own name", items[i].name));
}

}  // namespace

Sections split_sections(const std::filesystem::path& file, const TextValue& document) {
    SceneSection root(file, "", &document);
    const auto one = [&](const std::string& name) { return SceneSection(root.section(name)); };
    const auto many = [&](const std::string& name) {
        std::vector<SceneSection> all;
        for (Section& section : root.sections(name)) all.emplace_back(std::move(section));
        return all;
    };
    Sections s{root,
               one("hull"),
               one("water"),
               one("motion"),
               one("resolution"),
               one("domain"),
               one("run"),
               one("sampling"),
               one("tank"),
               one("effects"),
               {},
               many("obstacle"),
               many("body"),
               many("probe"),
               many("water_block"),
               many("refine"),
               many("ply"),
               many("gauge")};
    for (const std::string& method : method_names()) s.numerics.emplace(method, one(method));
    s.root = root;
    s.root.know("title");
    s.root.finish();
    return s;
}

Scene read_scene(const std::filesystem::path& file, const SceneOverrides& overrides) {
    Scene scene;
    scene.file = file;
    scene.text = read_text_within(file, largest_document);
    TextValue document = parse_document(scene.text, file);
    apply(overrides, document);
    Sections s = split_sections(file, document);
    const SceneSection& particles = s.numerics.at("sph");
    scene.title = s.root.text("title", file.stem().string());

    note_places(s, scene);
    const std::optional<double> depth = read_water(s.water, scene),
                                ramp = read_motion(s.motion, scene, s.hull.present()),
                                voxel = read_sampling(s.sampling, s.probes, scene);
    const auto read_all = [&](SceneSection& section) {
        section.read_into(scene);
        section.finish();
    };
    read_all(s.run);
    for (auto& [method, section] : s.numerics) read_all(section);
    const ResolutionOptions resolution = read_resolution(s.resolution);
    const DomainOptions domain = read_domain(s.domain);
    scene.tank_motion = read_tank_motion(s.tank, domain.dimensions);
    const std::optional<Box> tank = read_tank(s.tank);
    scene.water_blocks = read_water_blocks(s.water_blocks);
    for (std::size_t i = 0; i < s.obstacles.size(); ++i)
        scene.obstacles.push_back(read_obstacle(s.obstacles[i], i + 1));
    refuse_same_names(scene.obstacles, s.obstacles);
    std::vector<std::optional<ElasticPart>> elastic =
        read_elastic(s.bodies, s.plies, s.gauges, domain.dimensions, scene.water.gravity);
    for (std::size_t i = 0; i < s.bodies.size(); ++i) {
        const double filter = s.bodies[i].number("filter", 0);
        scene.bodies.push_back(!elastic[i] ? read_body(s.bodies[i], i + 1, domain.dimensions)
                               : std::holds_alternative<ElasticTyre>(*elastic[i])
                                   ? tyre_body(s.bodies[i], i + 1, std::get<ElasticTyre>(std::move(*elastic[i])))
                                   : elastic_body(s.bodies[i], i + 1, std::get<ElasticPlate>(std::move(*elastic[i]))));
        scene.bodies.back().filter = filter;
    }
    refuse_same_names(scene.bodies, s.bodies);

    std::optional<HullOptions> hull;
    if (s.hull.present()) {
        hull = read_hull(s.hull);
        hull->hull.section = domain.dimensions == 2;
        if (hull->hull.section && hull->hull.half)
            s.hull.fail("half", "two dimensions are the plane y = 0 and have no halves; remove this key");
        const auto measure = [&] {
            const Vec3 size = hull->hull.surface.bounds().size();
            hull->hull.length = size.x();
            hull->hull.beam = size.y();
        };
        measure();
        scene.resolution = resolution_of(resolution, &hull->hull, s.resolution, overrides.scale_resolution.value_or(1));
        check_health(*hull, scene.resolution.near_hull, s.hull);
        if (hull->hull.section) take_section(*hull, s.hull);
        measure();
        check_sizes(scene.resolution, {hull->hull.length, hull->hull.section ? hull->hull.length : hull->hull.beam},
                    "the hull", s.resolution);
        if (hull->hull.half) make_halves_alike(hull->hull, scene.resolution, s.hull);
        hull->hull.hash = surface_hash(hull->hull.surface);
        hull->hull.mass = mass_properties(hull->hull.surface);
        hull->hull.still = hydrostatics(hull->hull.surface);
        if (hull->free) stand_free_hull(*hull, scene.water.density);
        scene.hull = hull->hull;
    } else {
        scene.resolution = resolution_of(resolution, nullptr, s.resolution, overrides.scale_resolution.value_or(1));
    }
    for (std::size_t i = 0; i < scene.bodies.size(); ++i)
        if (scene.bodies[i].plate()) stand_elastic(scene.bodies[i], scene.resolution.near_hull, s.bodies[i]);
    // A stream without a hull has no length to settle over: its ramp is the domain's, so the domain comes first.
    const auto make_domain = [&] { scene.domain = domain_of(domain, tank, scene, s, depth); };
    const bool free_hull = scene.hull_is_free();
    if ((resolution.spacing || is_refined_unasked(scene)) && !scene.tank_motion && !particles.has("levels") &&
        !s.effects.on_off("air").value_or(false))
        follow_spacing(scene, make_domain);
    else
        make_domain();
    if (scene.hull) {
        check_hull_place(scene, s, hull->key);
        for (Finding& f : check_attitude(scene)) scene.hull->findings.push_back(std::move(f));
    }
    if (scene.motion.kind == Motion::Kind::stream && !scene.water_blocks.empty())
        s.water_blocks[0].fail(
            "min", "a stream fills all below z = 0 with water; water blocks belong to still scenes (kind = \"none\")");
    if (!(scene.domain.box.min.z() < 0) && scene.water_blocks.empty())
        s.domain.fail("z",
                      "there is no water: still water is z = 0, and the domain begins above it; expected a floor below "
                      "z = 0, or [[water_block]]");
    check_places(scene, s);
    check_bodies(scene, s);

    const double gravity = scene.water.gravity;  // what is planned is a scene without it, where it is off
    if (scene.motion.kind == Motion::Kind::stream && !s.effects.on_off("gravity").value_or(true))
        scene.water.gravity = 0;
    scene.motion.ramp = ramp.value_or(default_ramp(scene));
    if (free_hull) scene.hull->free->motion.release = hull->free->release.value_or(scene.motion.ramp);
    fill_times(scene);
    check_free_hull(scene, s);
    if (!overrides.interface.empty()) scene.fvm.interface = overrides.interface;
    // Measured with the entry of a body (docs/decisions/034-moving-bodies-in-interfoam.md).
    if (scene.fvm.max_alpha_courant == 0 && !scene.bodies.empty()) scene.fvm.max_alpha_courant = 0.5;
    if (scene.fvm.max_alpha_courant == 0 && scene.fvm.captures_geometrically())
        scene.fvm.max_alpha_courant = std::min(2.0, default_courant(scene));
    for (double* courant : {&scene.fvm.max_courant, &scene.fvm.max_alpha_courant})
        if (*courant == 0) *courant = default_courant(scene);
    if (scene.sph.c0 == 0) scene.sph.c0 = default_sound_speed(scene);
    check_sound_speed(scene);
    scene.water.gravity = gravity;
    if (overrides.box_factor != 1)  // only now: the sound speed follows from the box that the scene asks for
        scene.domain = domain_of(domain, tank, scene, s, depth, overrides.box_factor);
    scene.water.depth = water_height(scene) + (scene.domain.as_asked.min.z() - scene.domain.box.min.z());
    if (!overrides.device.empty()) scene.run.device = overrides.device;
    scene.sph.cfl *= overrides.time_step_factor;
    scene.fvm.max_courant *= overrides.courant_factor;
    scene.fvm.max_alpha_courant *= overrides.courant_factor;
    scene.refined = read_refined(s.refined, scene);
    refuse_same_names(scene.refined, s.refined);
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
    scene.sph.c0 *= overrides.sound_speed_factor;
    check_elastic(scene, s);
    warn_of_slow_bodies(scene);
    check_gate(scene, particles);
    check_tank_motion(scene, s);
    if (const auto shedding = check_vortex_shedding(scene)) scene.hull->findings.push_back(*shedding);
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
