#include <fmt/format.h>

#include <cmath>
#include <set>

#include "base/errors.h"
#include "base/read_file.h"
#include "methods/names.h"
#include "scene/defaults.h"
#include "scene/effects/plan.h"
#include "scene/hash.h"
#include "scene/mesh/courant_number.h"
#include "scene/particles/particle_levels.h"
#include "scene/read/check_scene.h"
#include "scene/read/domain.h"
#include "scene/read/overrides.h"
#include "scene/read/read.h"
#include "scene/read/uncertain.h"
#include "scene/solids/attitude.h"
#include "scene/solids/vortex_shedding.h"
#include "scene/water/quiet_layer.h"
#include "scene/water/tailwater.h"
#include "scene/water/water_blocks.h"
#include "scene/wave_twin.h"

namespace tw {
namespace {

void note_places(const Sections& s, Scene& scene) {
    const auto note = [&](const SceneSection& section) {
        for (const SceneKey& key : scene_keys())
            if (key.section == section.name() && section.has(key.name))
                scene.places[key.section + "." + key.name] = section.where(key.name);
    };
    for (const SceneSection* section :
         {&s.hull, &s.water, &s.motion, &s.wave, &s.resolution, &s.domain, &s.run, &s.sampling, &s.tank})
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

/// A scene between its text and its defaults: what the sections say that is still to be worked out.
struct Reading {
    Sections sections;
    const SceneOverrides& overrides;
    Scene scene = {};
    /// Of the place [m]; of the stream [s]; edge of the raster's voxels [m].
    std::optional<double> depth = {}, ramp = {}, voxel = {};
    ResolutionOptions resolution = {};
    DomainOptions domain = {};
    std::optional<Box> tank = {};
    std::vector<MeasuredRow> measured = {};
    std::optional<HullOptions> hull = {};
};

void read_sections(Reading& r) {
    Scene& scene = r.scene;
    Sections& s = r.sections;
    scene.title = s.root.text("title", scene.file.stem().string());
    note_places(s, scene);
    r.depth = read_water(s.water, scene);
    r.ramp = read_motion(s.motion, scene, s.hull.present());
    s.wave.read_into(scene);
    s.wave.finish();
    r.voxel = read_sampling(s.sampling, s.probes, scene);
    scene.sampling.volumes = read_volumes(s.volumes);
    r.measured = read_measured(s.measured, scene);
    const auto read_all = [&](SceneSection& section) {
        section.read_into(scene);
        section.finish();
    };
    read_all(s.run);
    for (auto& [method, section] : s.numerics) read_all(section);
    r.resolution = read_resolution(s.resolution);
    s.domain.read_into(scene);
    r.domain = read_domain(s.domain);
    s.tank.read_into(scene);
    scene.tank_motion = read_tank_motion(s.tank, r.domain.dimensions);
    r.tank = read_tank(s.tank);
    scene.water_blocks = read_water_blocks(s.water_blocks);
}

void read_solids(Reading& r) {
    Scene& scene = r.scene;
    Sections& s = r.sections;
    const int dimensions = r.domain.dimensions;
    for (std::size_t i = 0; i < s.obstacles.size(); ++i)
        scene.obstacles.push_back(read_obstacle(s.obstacles[i], i + 1));
    refuse_same_names(scene.obstacles, s.obstacles);
    std::vector<std::optional<ElasticPart>> elastic =
        read_elastic(s.bodies, s.plies, s.gauges, dimensions, scene.water.gravity);
    for (std::size_t i = 0; i < s.bodies.size(); ++i) {
        SceneSection& of = s.bodies[i];
        if (elastic[i] && of.has("friction"))
            of.fail("friction", "is for free rigid bodies, and this one is elastic; remove this key");
        MovingBody body = std::move(of.entry().bodies.front());
        body.name = of.identifier("name", fmt::format("body{}", i + 1));
        if (!elastic[i])
            read_body(of, body, dimensions);
        else if (auto* tyre = std::get_if<ElasticTyre>(&*elastic[i]))
            read_tyre_body(of, body, std::move(*tyre));
        else
            read_plate_body(of, body, std::get<ElasticPlate>(std::move(*elastic[i])));
        scene.bodies.push_back(std::move(body));
    }
    refuse_same_names(scene.bodies, s.bodies);
    if (s.hull.present()) r.hull = read_hull(s.hull);
}

/// The hull as it is solved: its section in two dimensions, both halves alike, with its mass and hydrostatics. The
/// resolution may follow from its size, and its health is judged by the resolution.
void settle_hull(Reading& r) {
    SceneSection &s = r.sections.hull, &of_sizes = r.sections.resolution;
    HullOptions& options = *r.hull;
    Hull& hull = options.hull;
    hull.section = r.domain.dimensions == 2;
    if (hull.section && hull.half)
        s.fail("half", "two dimensions are the plane y = 0 and have no halves; remove this key");
    const auto measure = [&] {
        const Vec3 size = hull.surface.bounds().size();
        hull.length = size.x();
        hull.beam = size.y();
    };
    measure();
    Resolution& resolution = r.scene.resolution;
    resolution = resolution_of(r.resolution, &hull, of_sizes, r.overrides.scale_resolution.value_or(1));
    check_health(options, resolution.near_hull, s);
    if (hull.section) take_section(options, s);
    measure();
    check_sizes(resolution, {hull.length, hull.section ? hull.length : hull.beam}, "the hull", of_sizes);
    if (hull.half) make_halves_alike(hull, resolution, s);
    hull.hash = surface_hash(hull.surface);
    hull.mass = mass_properties(hull.surface);
    hull.still = hydrostatics(hull.surface);
    if (options.free) stand_free_hull(options, r.scene.water.density);
    r.scene.hull = hull;
}

void settle_sizes(Reading& r) {
    Scene& scene = r.scene;
    if (r.hull)
        settle_hull(r);
    else
        scene.resolution =
            resolution_of(r.resolution, nullptr, r.sections.resolution, r.overrides.scale_resolution.value_or(1));
    for (std::size_t i = 0; i < scene.bodies.size(); ++i)
        if (scene.bodies[i].plate()) stand_elastic(scene.bodies[i], scene.resolution.near_hull, r.sections.bodies[i]);
}

void settle_domain(Reading& r) {
    Scene& scene = r.scene;
    Sections& s = r.sections;
    const auto make_domain = [&] {
        const auto of = [&] { return domain_of(r.domain, r.tank, scene, s, r.depth); };
        scene.domain = of();
        if (scene.motion.kind != Motion::Kind::stream || !s.wave.present() || !(scene.domain.as_asked.min.z() < 0))
            return;
        settle_wave(scene, s);  // its depth is the box's, and the zones outside the box follow from its length
        scene.domain = of();
    };
    const bool unasked = is_refined_unasked(scene) && !s.wave.present();
    if ((r.resolution.spacing || unasked) && !scene.tank_motion && !s.numerics.at(sph_method).has("levels") &&
        !s.effects.on_off("air").value_or(false))
        follow_spacing(scene, make_domain);
    else
        make_domain();
    if (scene.hull) {
        check_hull_place(scene, s, r.hull->key);
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
    if (!scene.has_wave()) settle_wave(scene, s);
}

/// What ends the run. Once its hull and bodies are known, and before its duration is filled in.
void settle_end(Scene& scene, SceneSection& s) {
    Run& run = scene.run;
    const bool settles = loads_settle(scene);
    if (run.stop == "settled" && !settles)
        s.fail("stop",
               "only the loads on a hull that is held in a stream settle; a free hull, bodies that move, waves and "
               "tanks are run to their end: remove this key, or write stop = \"duration\"");
    if (run.stop == "auto") run.stop = settles && run.duration == 0 ? "settled" : "duration";
    if (run.stops_when_settled()) run.wave_period = start_up_period(scene);
}

void settle_courant_numbers(Scene& scene) {
    // Measured with the entry of a body (docs/decisions/032-rigid-bodies.md).
    if (scene.fvm.max_alpha_courant == 0 && !scene.bodies.empty()) scene.fvm.max_alpha_courant = 0.5;
    if (scene.fvm.max_alpha_courant == 0 && scene.fvm.captures_geometrically())
        scene.fvm.max_alpha_courant = std::min(2.0, default_courant(scene));
    for (double* courant : {&scene.fvm.max_courant, &scene.fvm.max_alpha_courant})
        if (*courant == 0) *courant = default_courant(scene);
}

/// Times, Courant numbers and sound speed. They are those of a scene without gravity, where that effect is off; what a
/// stream without a hull settles over is its domain's length, so the domain comes first.
void settle_times(Reading& r) {
    Scene& scene = r.scene;
    Sections& s = r.sections;
    const double gravity = scene.water.gravity;
    if (scene.motion.kind == Motion::Kind::stream && !s.effects.on_off("gravity").value_or(true))
        scene.water.gravity = 0;
    scene.motion.ramp = r.ramp.value_or(default_ramp(scene));
    if (scene.hull_is_free()) scene.hull->free->motion.release = r.hull->free->release.value_or(scene.motion.ramp);
    settle_end(scene, s.run);
    fill_times(scene);
    check_free_hull(scene, s);
    if (!r.overrides.interface.empty()) scene.fvm.interface = r.overrides.interface;
    settle_courant_numbers(scene);
    if (scene.sph.c0 == 0) scene.sph.c0 = default_sound_speed(scene);
    check_sound_speed(scene);
    scene.water.gravity = gravity;
}

/// What the command line asks of a run beside the scene's own words. A larger box comes only now: the sound speed
/// follows from the box that the scene asks for.
void apply_to_run(Reading& r) {
    Scene& scene = r.scene;
    const SceneOverrides& o = r.overrides;
    if (o.box_factor != 1) scene.domain = domain_of(r.domain, r.tank, scene, r.sections, r.depth, o.box_factor);
    scene.water.depth = water_height(scene) + (scene.domain.as_asked.min.z() - scene.domain.box.min.z());
    if (!o.device.empty()) scene.run.device = o.device;
    scene.sph.cfl *= o.time_step_factor;
    scene.fvm.max_courant *= o.courant_factor;
    scene.fvm.max_alpha_courant *= o.courant_factor;
}

void settle_places(Reading& r) {
    Scene& scene = r.scene;
    Sections& s = r.sections;
    scene.refined = read_refined(s.refined, scene);
    refuse_same_names(scene.refined, s.refined);
    scene.refinement = default_refinement(scene);
    const double two_particles = (scene.domain.dimensions == 2 ? 1 : 2) * scene.resolution.near_hull;
    scene.sampling.raster = default_raster(scene, r.voxel.value_or(two_particles));
    scene.sampling.raster.chosen = r.voxel.has_value();
    if (r.voxel && voxels(scene.sampling.raster) > most_voxels)
        s.sampling.fail(
            "raster_spacing",
            fmt::format("makes a raster of more than {:.0e} voxels; expected about {:.3g} m, twice near_hull",
                        most_voxels, two_particles));
}

/// Effects, and what can be judged only with them.
void settle_effects(Reading& r) {
    Scene& scene = r.scene;
    Sections& s = r.sections;
    scene.effects = plan_effects(scene, s.effects, [&](const std::string& effect) { return s.effects.on_off(effect); });
    if (!scene.places.contains("fvm.correctors")) scene.fvm.correctors = default_correctors(scene);
    scene.sph.c0 *= r.overrides.sound_speed_factor;
    check_elastic(scene, s);
    warn_of_slow_bodies(scene);
    check_gate(scene, s.numerics.at(sph_method));
    check_tank_motion(scene, s);
    check_tailwater(scene);
    if (const auto shedding = check_vortex_shedding(scene)) scene.hull->findings.push_back(*shedding);
}

}  // namespace

Scene read_scene(const std::filesystem::path& file, const SceneOverrides& overrides) {
    return read_scene(file, overrides, {});
}

Scene read_scene(const std::filesystem::path& file, const SceneOverrides& overrides, const ChangedNumbers& changed) {
    std::string text = read_text_within(file, largest_document);
    TextValue document = parse_document(text, file);
    forget_auto_duration(document);
    apply_overrides(overrides, document);
    if (const TextValue* uncertain = document.find("uncertain")) {
        if (uncertain->kind != TextValue::Kind::table)
            throw InputError(fmt::format("{}:{}:{}: uncertain: expected a section [uncertain]", file.string(),
                                         uncertain->place.line, uncertain->place.column));
        uncertain_numbers_of({file, *uncertain}, document);  // refused here, although only studies use them
    }
    change_numbers(document, changed, file);
    Reading r{.sections = split_sections(file, document), .overrides = overrides};
    r.scene.file = file;
    r.scene.text = std::move(text);
    read_sections(r);
    read_solids(r);
    settle_sizes(r);
    settle_domain(r);
    settle_times(r);
    apply_to_run(r);
    settle_places(r);
    settle_effects(r);
    check_wave(r.scene, r.sections);
    take_measured(std::move(r.measured), overrides, r.scene);
    if (overrides.wave_twin) make_wave_twin(r.scene);
    r.scene.hash = scene_hash(r.scene);
    return std::move(r.scene);
}

}  // namespace tw
