#include "scene/new_record.h"

#include <fmt/format.h>
#include <Eigen/Geometry>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <stdexcept>

#include "methods/methods.h"
#include "methods/names.h"
#include "record/code_version.h"
#include "record/event_threshold.h"
#include "record/hull_motion.h"
#include "record/recorded_checks.h"
#include "record/solid_at_rest.h"
#include "record/this_machine.h"
#include "record/wave_twin.h"
#include "scene/box/box_walls.h"
#include "scene/box/oblique_wave.h"
#include "scene/doubtful_input.h"
#include "scene/hash.h"
#include "scene/particles/particle_levels.h"
#include "scene/refined_places.h"
#include "scene/solids/hull_motion.h"
#include "scene/solids/sea_wall.h"
#include "scene/solids/thin_jet.h"
#include "scene/water/capillary.h"
#include "scene/water/dry_floor.h"
#include "scene/water/tailwater.h"

namespace tw {

Vec3 moment_reference(const Scene& scene) {
    if (!scene.hull) return Vec3::Zero();
    const Box b = scene.hull->surface.bounds();
    return {0.5 * (b.min.x() + b.max.x()), 0.5 * (b.min.y() + b.max.y()), 0};
}

void note_prediction(RunRecord& record, const RunOptions& options) {
    if (!options.command.empty()) record.attributes["command"] = options.command;
    if (!(options.predicted_seconds > 0)) return;
    record.numbers["predicted_seconds"] = options.predicted_seconds;
    if (options.predicted_core_seconds > 0) record.numbers["predicted_core_seconds"] = options.predicted_core_seconds;
    record.numbers["predicted_elements"] = options.predicted_elements;
    record.numbers["predicted_memory"] = options.predicted_bytes;
    record.numbers["predicted_steps"] = options.predicted_steps;
}

namespace {

/// Cells of the mesh where still water, z = 0, crosses it: "cell x_min x_max y_min y_max" [m] of every refinement box
/// that it crosses, one after another. Elsewhere cells have the number `spacing`.
std::string surface_cells(const Scene& scene) {
    std::string text;
    for (const RefinementBox& r : scene.refinement)
        if (r.box.min.z() <= 0 && r.box.max.z() >= 0)
            text +=
                fmt::format("{}{} {} {} {} {}", text.empty() ? "" : " ", scene.resolution.spacing / std::exp2(r.level),
                            r.box.min.x(), r.box.max.x(), r.box.min.y(), r.box.max.y());
    return text.empty() ? "none" : text;
}

/// As set up: the mesh's boxes, or the particles' zones.
std::vector<ResolvedBox> resolution_of(const Scene& scene, const std::string& method) {
    std::vector<ResolvedBox> finer;
    double largest = scene.resolution.spacing;
    const std::string elements = elements_of(method);
    if (elements == "cells") {
        for (const RefinementBox& r : scene.refinement) finer.push_back({largest / std::exp2(r.level), r.box});
    } else if (elements == "particles") {
        const std::vector<Zone> zones = particle_zones(scene);
        double size = largest = std::ldexp(finest_spacing(scene), static_cast<int>(zones.size()));
        for (const Zone& zone : zones) {
            size /= 2;
            for (const Box& box : zone.sliced()) finer.push_back({size, box});
        }
    } else {
        throw std::logic_error(method + " solves on " + elements +
                               ": new_record.cpp does not say where they are finer");
    }
    return resolution_within({largest, scene.domain.box}, finer);
}

/// A sum of waves as the gauges meet it: what it is by linear theory, and of a focused one at each gauge its crest to
/// first and second order.
void note_sea(RunRecord& record, const Scene& scene) {
    const Sea& sea = *scene.sea;
    record.attributes["sea"] = scene.wave_asked.spectrum;
    record.numbers["sea_significant_height"] = sea.significant_height;
    record.numbers["sea_peak_period"] = sea.peak_period_met();
    record.numbers["sea_repeat_period"] = sea.repeat_period;
    record.numbers["sea_left_out"] = left_out_by_first_order(sea).both();
    record.numbers["wave_direction"] = sea.waves.direction;
    std::string components;  // frequency met [1/s], wave number [1/m], amplitude [m], phase [rad]
    for (int n = 0; n < sea.waves.count; ++n)
        components += fmt::format("{:.17g} {:.17g} {:.17g} {:.17g}\n", sea.met(n) / (2 * std::numbers::pi),
                                  sea.waves.k[n], sea.waves.height[n], sea.waves.phase[n]);
    record.attributes["sea_components"] = components;
    if (sea.kind != Sea::Kind::focused) return;
    record.numbers["sea_focus_place"] = sea.focus_place;
    record.numbers["sea_focus_time"] = sea.focus_time;
    for (const HeightProbe& p : scene.sampling.height)
        for (const bool second : {false, true}) {
            const double near = 2 * sea.peak_period_met();
            const Crest crest = highest_crest(sea, p.x, sea.focus_time - near, sea.focus_time + near, second);
            const std::string order = second ? "second" : "first";
            record.numbers["sea_crest_" + order + "_" + p.name] = crest.height;
            record.numbers["sea_crest_time_" + order + "_" + p.name] = crest.time;
        }
}

void note_free_hull(RunRecord& record, const Hull& hull) {
    const RigidBodySetup& motion = hull.free->motion;
    record.attributes["hull_free"] = motion.free.along[2] ? motion.free.about[1] ? "heave pitch" : "heave" : "pitch";
    record.numbers["hull_mass"] = motion.mass.mass;
    record.numbers["release"] = motion.release;
    const Vec3 arm = Eigen::AngleAxisd(-hull.trim, Vec3::UnitY()) * (motion.mass.centre - hull.free->transom_keel);
    record.numbers["hull_lcg"] = -arm.x();  // ahead of the transom's keel, along the hull's own axis
    record.numbers["hull_vcg"] = arm.z();   // above it
    const std::optional<RestingHull> rest = resting_hull(hull);
    if (!rest) return;
    record.numbers["rest_z"] = rest->z;
    record.numbers["rest_trim_deg"] = rest->trim_deg;
    record.numbers["rest_transom_draft"] = rest->transom_draft;
}

/// What is solved, with what program, on which machine.
std::map<std::string, std::string> provenance(const Scene& scene, const std::string& method) {
    const Vec3 reference = moment_reference(scene);
    return {
        {"method", method},
        {"title", scene.title},
        {"scene_file", scene.file.filename().string()},
        {"scene_hash", scene.hash},
        {"run_hash", run_hash(scene, method)},
        {"family_hash", family_hash(scene, method)},
        {"code_version", TWINWAKE_CODE_VERSION},
        {"compiler", TWINWAKE_COMPILER},
        {"machine", cpu_model()},
        {"isa", instruction_set()},
        {"started", utc_now()},
        {"symmetry_factor", std::to_string(scene.symmetry_factor())},
        {"moment_reference", fmt::format("{} {} {}", reference.x(), reference.y(), reference.z())},
        {"motion", scene.motion.kind == Motion::Kind::stream ? "stream" : "none"},
        {"surface_cells", surface_cells(scene)},
    };
}

std::map<std::string, double> numbers_of(const Scene& scene) {
    return {
        {"spacing", scene.resolution.spacing},
        {"near_hull", scene.resolution.near_hull},
        {"size_scale", scene.resolution.scale},  // of --scale or --budget: how many times the scene's sizes
        {"density", scene.water.density},
        {"kinematic_viscosity", scene.water.kinematic_viscosity},
        {"gravity", scene.water.gravity},
        {"depth", scene.water.depth},
        {"speed", scene.motion.speed},
        {"ramp", scene.motion.ramp},
        {"duration", scene.run.duration},
        {"mean_from", scene.sampling.mean_from},
        {"sampling_interval", scene.sampling.interval},
        {"dimensions", scene.domain.dimensions},
    };
}

void note_domain(RunRecord& record, const Scene& scene) {
    const auto note = [&](const std::string& name, const Box& box, const std::string& axes) {
        for (std::size_t k = 0; k < axes.size(); ++k) {
            record.numbers[name + "_" + axes[k] + "_min"] = box.min[static_cast<Eigen::Index>(k)];
            record.numbers[name + "_" + axes[k] + "_max"] = box.max[static_cast<Eigen::Index>(k)];
        }
    };
    note("domain", scene.domain.box, "xyz");
    if (scene.effect_on("forcing_zones") && scene.motion.kind == Motion::Kind::stream)
        note("undamped", scene.domain.undamped, "xy");
}

/// Water that is released by a gate or meets a lower level behind the hull, and the energy of its surface.
void note_water_at_start(RunRecord& record, const Scene& scene) {
    if (scene.motion.kind != Motion::Kind::stream)
        if (const double height = released_height(scene); height > 0) record.numbers["released_height"] = height;
    if (tailwater(scene)) record.numbers["fastest_stream"] = fastest_stream(scene);
    if (scene.effect_on("surface_tension"))
        record.numbers[energy_of_surface] = surface_energy(scene) / (scene.domain.dimensions == 2 ? scene.span() : 1.0);
}

/// The filters of peaks, what is an event, and where the surface is cut.
void note_sampling(RunRecord& record, const Scene& scene) {
    const auto add_filter = [&](const std::string& table, const std::string& name, double filter) {
        if (filter > 0) record.numbers[peak_filter(table, name)] = filter;
    };
    for (const PressureProbe& p : scene.sampling.pressure) add_filter("pressure", p.name, p.filter);
    for (const HeightProbe& p : scene.sampling.height) add_filter("height", p.name, p.filter);
    for (const MovingBody& b : scene.bodies) add_filter("body", b.name, b.filter);
    for (const PressureProbe& p : scene.sampling.pressure)
        if (p.slam > 0) record.numbers[event_threshold("pressure", p.name)] = p.slam;
    for (const HeightProbe& p : scene.sampling.height)
        if (std::isfinite(p.deck)) record.numbers[event_threshold("height", p.name)] = p.deck;
    if (scene.hull && scene.sampling.cuts_x.empty() && scene.sampling.cuts_y.empty()) {
        // from the scene's hull: that of a mesh ends elsewhere at each size
        const Box hull = scene.hull->surface.bounds();
        record.numbers["cut_x_0"] = hull.max.x() + 0.5 * hull.size().x();
        record.numbers["cut_y_0"] = 0.75 * scene.hull->beam;
    }
    for (std::size_t k = 0; k < scene.sampling.cuts_x.size(); ++k)
        record.numbers[fmt::format("cut_x_{}", k)] = scene.sampling.cuts_x[k];
    for (std::size_t k = 0; k < scene.sampling.cuts_y.size(); ++k)
        record.numbers[fmt::format("cut_y_{}", k)] = scene.sampling.cuts_y[k];
}

void note_waves(RunRecord& record, const Scene& scene) {
    if (scene.wave) {
        const RegularWave& wave = *scene.wave;
        record.numbers["wave_height"] = wave.height;
        record.numbers["wave_length"] = wave.length;
        record.numbers["wave_period"] = wave.encounter_period();
        record.numbers["wave_crest"] = wave.crest;
        record.numbers["wave_trough"] = wave.trough;
        // as it is met: a following wave that the hull overtakes comes from ahead
        record.numbers["wave_direction"] = wave.sum.speed > 0 ? wave.sum.direction : -wave.sum.direction;
        if (runs_obliquely(scene)) {  // cosine and sine; a gauge then needs both its coordinates
            record.numbers["wave_across"] = wave.sum.across;
            for (const HeightProbe& p : scene.sampling.height) record.numbers["height_y_" + p.name] = p.y;
        }
    }
    if (scene.sea) note_sea(record, scene);
    if (!scene.has_wave()) return;
    const auto note_range = [&](const std::string& kind, const std::string& name, const Surface& surface) {
        const Box at = surface.bounds();
        record.numbers[kind + "_x_min_" + name] = at.min.x();
        record.numbers[kind + "_x_max_" + name] = at.max.x();
    };
    for (const MovingBody& b : scene.bodies)
        if (!b.motion.law) note_range("body", b.name, b.surface);
    for (const Obstacle& o : scene.obstacles) {
        note_range("obstacle", o.name, o.surface);
        if (const auto wall = sea_wall_of(scene, o)) {
            record.numbers["slope_crest_" + o.name] = wall->freeboard;
            record.numbers["slope_cot_" + o.name] = wall->cot_slope;
            record.numbers["slope_depth_" + o.name] = wall->depth;
            record.numbers["slope_plane_" + o.name] = wall->plane;
        }
    }
    for (const HeightProbe& p : scene.sampling.height) record.numbers["height_x_" + p.name] = p.x;
    for (const WaterBox& v : scene.sampling.volumes) {
        const auto wall = sea_wall_before(scene, v.box);
        if (!wall) continue;
        const Box& all = scene.domain.box;
        record.numbers["wall_freeboard_" + v.name] = wall->freeboard;
        record.numbers["wall_cot_slope_" + v.name] = wall->cot_slope;
        record.numbers["wall_depth_" + v.name] = wall->depth;
        record.numbers["wall_width_" + v.name] =  // of what the table gives
            scene.domain.dimensions == 2 ? 1
                                         : std::min(v.box.max.y(), all.max.y()) - std::max(v.box.min.y(), all.min.y());
    }
}

/// What this method alone is set to, and the finer places of its solution.
void note_method(RunRecord& record, const Scene& scene, const std::string& method) {
    if (const auto of = scene.wave_twin_of.find(method); of != scene.wave_twin_of.end())
        record.attributes[std::string(wave_twin_of_run)] = of->second;
    if (method == sph_method) {
        record.numbers["h_over_dp"] = scene.sph.h_over_dp;
        record.numbers["c0"] = scene.sph.c0;
        record.numbers["alpha"] = scene.sph.alpha;
        record.numbers["cfl"] = scene.sph.cfl;
        record.numbers["delta"] = scene.sph.delta;
        record.numbers["shifting"] = scene.sph.shifting;
        record.attributes["equation_of_state"] = scene.sph.equation_of_state;
        record.attributes["time_scheme"] = scene.sph.scheme;
    }
    if (method == fvm_method) {
        record.numbers["max_courant_limit"] = scene.fvm.max_courant;
        record.attributes["interface"] = scene.fvm.interface;
        record.numbers["interface_compression"] = scene.fvm.interface_compression;
    }
    if (find_method(method)) record.resolution = resolution_of(scene, method);  // a table that is imported has none
}

/// Each as "name: message", under `prefix` and its place in the list.
void note_findings(RunRecord& record, const std::string& prefix, const std::vector<Finding>& findings) {
    for (std::size_t k = 0; k < findings.size(); ++k)
        record.attributes[fmt::format("{}_{:02}", prefix, k)] = findings[k].name + ": " + findings[k].message;
}

void note_hull(RunRecord& record, const Scene& scene) {
    const Hull& hull = *scene.hull;
    record.attributes["hull_hash"] = hull.hash;
    record.attributes["hull_source"] = hull.source;
    record.numbers["length"] = hull.length;
    record.numbers["beam"] = hull.beam;
    record.numbers["trim"] = hull.trim;
    record.numbers["heel"] = hull.heel;
    record.numbers["draft"] = hull.draft;
    record.numbers["displaced_volume"] = hull.still.volume;
    if (const std::string walls = wall_warning(scene); !walls.empty()) record.attributes["box_walls"] = walls;
    if (const std::string channel = channel_text(scene); !channel.empty()) record.attributes["channel"] = channel;
    if (const std::optional<SprayJet> jet = thin_jet(scene)) {
        record.numbers["jet_thickness"] = jet->thickness;
        record.numbers["jet_spacing"] = jet->size;
    }
    if (hull.free) {
        note_free_hull(record, hull);
        record.bodies.push_back({hull_motion_table, hull.surface, hull.free->motion.mass.centre});
    }
    record.hull = hull.surface;
    note_findings(record, "hull_finding", hull.findings);
    for (std::size_t k = 0; k < hull.repairs.size(); ++k)
        record.attributes[fmt::format("hull_repair_{:02}", k)] = hull.repairs[k];
}

/// An elastic body bends in runs of particles; a mesh solves the water around it as if it were rigid.
void note_body(RunRecord& record, const MovingBody& b, const std::string& method) {
    const bool bends = b.elastic && method == sph_method;
    record.numbers["mass_" + b.name] = b.motion.mass.mass;
    if (!bends) record.bodies.push_back({body_table(b.name), b.surface, b.motion.mass.centre});
    note_findings(record, "finding_" + b.name, b.findings);
    if (!b.elastic) return;
    record.attributes["structure"] = bends ? "elastic" : "rigid";
    record.attributes["compliance"] =
        "body " + b.name +
        (bends ? " bends here" : " is rigid here: a difference from a run in which it bends contains its compliance");
}

}  // namespace

RunRecord new_record(const Scene& scene, const std::string& method) {
    RunRecord record;
    record.attributes = provenance(scene, method);
    record.numbers = numbers_of(scene);
    record.scene_text = scene.text;
    record.raster = scene.sampling.raster;
    record.effects = scene.effects;
    note_domain(record, scene);
    note_water_at_start(record, scene);
    note_sampling(record, scene);
    note_waves(record, scene);
    note_method(record, scene, method);
    if (scene.hull) note_hull(record, scene);
    for (const Obstacle& o : scene.obstacles)
        record.bodies.push_back({obstacle_table(o.name), o.surface, Vec3::Zero()});
    for (const MovingBody& b : scene.bodies) note_body(record, b, method);
    if (scene.tank_motion) record.attributes["tank_moves"] = "yes";
    for (const MeasuredValue& m : scene.measured) note_measured(record, m);
    note_findings(record, "scene_finding", doubtful_input(scene));
    return record;
}

}  // namespace tw
