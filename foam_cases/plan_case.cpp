#include "foam_cases/plan_case.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <limits>
#include <numbers>
#include <set>

#include "base/errors.h"
#include "foam_cases/axis_cells.h"
#include "foam_cases/files/case_files.h"
#include "foam_cases/one_way.h"
#include "foam_cases/own_openfoam.h"
#include "foam_cases/release.h"
#include "foam_cases/viscous_steps.h"
#include "meshes/query.h"
#include "meshes/section.h"
#include "scene/box/tank_walls.h"
#include "scene/defaults.h"
#include "scene/mesh/mesh_cells.h"
#include "scene/mesh/step_limits.h"
#include "scene/water/tailwater.h"
#include "scene/water/water_blocks.h"

namespace tw {
namespace {

Patch patch(Side side, const char* wall_name, bool empty) {
    switch (side) {
        case Side::inlet: return {"inlet", side, false, false};
        case Side::outlet: return {"outlet", side, false, false};
        case Side::atmosphere: return {"atmosphere", side, false, false};
        case Side::symmetry: return {"midPlane", side, empty, false};
        case Side::slip_wall: break;
    }
    return {wall_name, side, empty, false};
}

std::array<Patch, 6> patches_of(const Domain& d) {
    const bool flat = d.dimensions == 2;
    std::array<Patch, 6> p{patch(d.x_min, "left", false),   patch(d.x_max, "right", false),
                           patch(d.y_min, "front", flat),   patch(d.y_max, flat ? "back" : "side", flat),
                           patch(d.z_min, "bottom", false), patch(d.z_max, "top", false)};
    // Two sides of one kind would share a patch name: the later one gets its axis behind it.
    std::set<std::string> seen;
    static constexpr const char* axis[] = {"X", "X", "Y", "Y", "Z", "Z"};
    for (std::size_t i = 0; i < 6; ++i)
        while (!seen.insert(p[i].name).second) p[i].name += axis[i];
    return p;
}

/// Every corner lies in a corner of the bounding box: its faces can be cell faces of the background mesh.
bool is_aligned_box(const Surface& s) {
    const Box b = s.bounds();
    const double eps = 1e-9 * b.size().norm();
    for (const Vec3& p : s.points)
        for (int a = 0; a < 3; ++a)
            if (std::abs(p[a] - b.min[a]) > eps && std::abs(p[a] - b.max[a]) > eps) return false;
    return true;
}

/// In two dimensions a solid that reaches the plane's front or back is drawn out beyond it: its ends would lie in the
/// mesh's own sides, and snappyHexMesh would snap to either.
Surface through_plane(Surface surface, const Domain& domain) {
    if (domain.dimensions == 3) return surface;
    const double low = domain.box.min.y(), high = domain.box.max.y(), thickness = high - low;
    for (Vec3& p : surface.points) {
        if (p.y() >= high - 0.01 * thickness)
            p.y() += thickness;
        else if (p.y() <= low + 0.01 * thickness)
            p.y() -= thickness;
    }
    return surface;
}

Vec3 find_point_in_fluid(const CasePlan& plan) {
    const Box& b = plan.scene->domain.box;
    std::vector<SurfaceQuery> solids;
    for (const Solid& s : plan.solids) solids.emplace_back(s.surface);
    // Odd fractions of the background cell: never on a face of any refinement level. Far corners first, then inwards.
    const double h = plan.background_cell;
    for (int inward = 0; inward < 40; ++inward)
        for (const int corner : {6, 4, 2, 0, 7, 5, 3, 1}) {
            const Vec3 step(0.1234 * h + inward * h,
                            (plan.scene->domain.dimensions == 2 ? 0.317 * b.size().y() : 0.317 * h + inward * h),
                            0.2143 * h + inward * h);
            Vec3 p;
            const bool high[3] = {(corner & 1) != 0, (corner & 2) != 0, (corner & 4) == 0};
            // In the floor's corners of the inlet's side first (bits: x, y, not z).
            p.x() = high[0] ? b.max.x() - step.x() : b.min.x() + step.x();
            p.y() = high[1] ? b.max.y() - step.y() : b.min.y() + step.y();
            p.z() = high[2] ? b.max.z() - step.z() : b.min.z() + step.z();
            if (!b.contains(p)) continue;
            bool free = true;
            for (const SurfaceQuery& s : solids) free = free && !s.inside(p) && s.nearest(p).distance > 0.5 * h;
            if (free) return p;
        }
    throw InputError("the solids fill the domain: no place for water was found in " + std::to_string(b.size().x()) +
                     " x " + std::to_string(b.size().y()) + " x " + std::to_string(b.size().z()) +
                     " m; enlarge the domain");
}

/// Moves a probe off walls and solids, so that it surely lies in a cell.
Vec3 into_fluid(const CasePlan& plan, const std::vector<SurfaceQuery>& solids, Vec3 p) {
    const double gap = 0.05 * plan.finest_cell;
    for (const SurfaceQuery& s : solids) {
        const auto near = s.nearest(p, plan.finest_cell);
        if (near.triangle >= 0 && near.distance < gap) p = near.point + gap * near.normal;
    }
    const Box& b = plan.scene->domain.box;
    for (int a = 0; a < 3; ++a) p[a] = std::clamp(p[a], b.min[a] + gap, b.max[a] - gap);
    if (plan.scene->domain.dimensions == 2) p.y() = 0.5 * (b.min.y() + b.max.y());
    return p;
}

void plan_probes(CasePlan& plan) {
    const Scene& scene = *plan.scene;
    if (scene.sampling.pressure.empty() && scene.sampling.height.empty()) return;
    std::vector<SurfaceQuery> solids;
    for (const Solid& s : plan.solids) solids.emplace_back(s.surface);
    for (const PressureProbe& probe : scene.sampling.pressure)
        plan.pressure_places.push_back(into_fluid(plan, solids, probe.place));
    const Box& b = scene.domain.box;
    const int split = std::max(1, static_cast<int>(std::lround(plan.background_cell / plan.finest_cell)));
    for (const HeightProbe& probe : scene.sampling.height) {
        std::vector<CasePlan::ColumnPoint> column;
        const Vec3 foot = into_fluid(plan, {}, {probe.x, probe.y, b.min.z()});
        const AxisCells& z = plan.axes[2];
        for (std::size_t block = 0; block < z.cells.size(); ++block) {
            const int points = z.cells[block] * split;
            const double step = (z.planes[block + 1] - z.planes[block]) / points;
            for (int k = 0; k < points; ++k)
                column.push_back({Vec3(foot.x(), foot.y(), z.planes[block] + (k + 0.5) * step), step});
        }
        plan.height_columns.push_back(column);
    }
}

void plan_refinement(CasePlan& plan) {
    const Scene& scene = *plan.scene;
    if (scene.domain.dimensions == 2) {  // cells of one size, but at the hull: its edges need more
        // snappyHexMesh halves the slab across as well, and its time to move a mesh with `empty` sides grows with the
        // square of the cells (docs/decisions/028-shedding-edges.md)
        plan.extrude = !plan.solids.empty();
        if (!scene.hull && !plan.mesh_moves()) return;
        plan.surface_level = plan.feature_level = section_levels;
        plan.finest_cell = plan.background_cell / std::pow(2.0, plan.surface_level);
        return;
    }
    plan.wet_level = finest_halvings(scene);
    int reached = 0;
    std::set<std::string> names;
    for (const Solid& s : plan.solids) names.insert(s.name);
    for (RefinementBox box : scene.refinement) {
        if (box.level <= 0) continue;
        box.name = word_from(box.name, "refined");
        while (!names.insert(box.name).second) box.name += "_";
        reached = std::max(reached, box.level);
        plan.boxes.push_back(box);
    }
    // The wet bottom is refined by boxes; the surface itself may then be two levels coarser, so that dry topsides stay
    // cheap (measured: the force does not change). Without such boxes the whole surface gets the finest level.
    plan.surface_level = reached >= plan.wet_level ? std::max(0, plan.wet_level - 2) : plan.wet_level;
    plan.feature_level = std::max(plan.surface_level, plan.wet_level - 1);
    for (RefinementBox near : boxes_round_bodies(scene)) {
        near.name = word_from("near_" + near.name, "near");
        while (!names.insert(near.name).second) near.name += "_";
        reached = std::max(reached, near.level);
        plan.boxes.push_back(near);
    }
    plan.finest_cell =
        plan.background_cell / std::pow(2.0, std::max(reached, plan.solids.empty() ? 0 : plan.surface_level));
    plan.shedding = edge_refinement(scene);
    if (plan.shedding.edges.empty()) return;
    plan.ribbon = "shedding_edges";
    while (!names.insert(plan.ribbon).second) plan.ribbon += "_";
}

void plan_times(CasePlan& plan) {
    const Scene& scene = *plan.scene;
    const double g = std::abs(scene.water.gravity), height = scene.domain.box.size().z();
    const double interval = scene.sampling.interval > 0 ? scene.sampling.interval : scene.run.duration / 100;
    if (scene.hull && plan.stream) {
        // Forces of the water need the hull's pressures: forty times per hull length of travel resolves their settling.
        const double wanted = scene.hull->length / scene.motion.speed / 40;
        plan.raster_every = std::max(1, static_cast<int>(std::ceil(interval / wanted - 1e-9)));
    }
    plan.write_interval = interval / plan.raster_every;
    plan.writes_at_steps = !plan.stream || hull_held_in_stream(scene);
    if (scene.sampling.snapshot_interval > 0)
        plan.snapshot_every =
            std::max(1, static_cast<int>(std::lround(scene.sampling.snapshot_interval / plan.write_interval)));
    double driven = std::sqrt(2 * g * height) + fastest_wall(scene);
    for (const BodyInMesh& b : plan.bodies) driven = std::max(driven, b.body.fastest(g));
    // Ripples as long as two cells: all that moves where nothing falls.
    if (scene.effect_on("surface_tension"))
        driven = std::max(driven, std::sqrt(std::numbers::pi * scene.water.surface_tension /
                                            (scene.water.density * plan.finest_cell)));
    plan.first_step = 0.05 * plan.finest_cell / std::max({scene.motion.speed, driven, 1e-6});
    plan.first_step = std::min(plan.first_step, 0.1 * plan.write_interval);
    plan.largest_step = g > 0 ? longest_step_of_still_water(plan.finest_cell, g) : plan.write_interval;
    const double length = scene.hull ? scene.hull->length : height;
    const double explained = scene.motion.speed + std::sqrt(g * length) + driven;
    plan.water_speed_limit = plan.air_speed_limit = std::numeric_limits<double>::infinity();
    if (!(explained > 0)) return;
    plan.water_speed_limit = 10 * explained;
    const auto longest_of = [&](const Vec3& size) {  // a section is drawn out across its plane
        return scene.domain.dimensions == 2 ? size.x() : std::max(size.x(), size.y());
    };
    double longest = plan.solids.empty() ? longest_of(scene.domain.box.size()) : 0;
    for (const Solid& s : plan.solids) longest = std::max(longest, longest_of(s.surface.bounds().size()));
    plan.air_speed_limit = std::max(plan.water_speed_limit, 3 * explained * longest / (2 * plan.finest_cell));
}

void need_motion(const Flavour& flavour, const char* what) {
    if (flavour.moves_bodies_and_tanks()) return;
    throw InputError(fmt::format(
        "{} that move are written for OpenFOAM of openfoam.com and for openfoam.org from 11, and this is {} {}; use "
        "the particle method, or name another installation in [fvm] openfoam",
        what, flavour.vendor_name(), flavour.version_name()));
}

void plan_body(CasePlan& plan, std::set<std::string>& names) {
    const Scene& scene = *plan.scene;
    plan.mesh_motion = mesh_motion(scene);
    const std::vector<MovingBody> followed = followed_by_mesh(scene);
    if (followed.empty()) return;
    need_motion(plan.flavour, "bodies");
    if (plan.scene->hull_is_free()) {
        plan.bodies.push_back({plan.solids.front().name, followed.front()});
        plan.solids.front().moves = true;
    } else {
        for (const MovingBody& body : followed) {
            std::string patch = word_from(body.name, "body");
            while (!names.insert(patch).second) patch += "_";
            const bool flat = scene.domain.dimensions == 2;
            plan.solids.push_back(
                {patch, flat ? with_span(body.surface, endless_span(body.surface)) : body.surface, false, true});
            plan.bodies.push_back({patch, body});
        }
    }
    for (Patch& p : plan.sides) {
        if (p.empty || p.side == Side::symmetry) continue;
        if (plan.mesh_motion.kind == MeshMotion::Kind::open_water)
            p.open = Patch::Open::water_and_air, p.holds = false;
        else if (plan.mesh_motion.kind == MeshMotion::Kind::sliding && &p == &plan.sides[4])
            p.open = Patch::Open::resting_water, p.holds = false;
    }
    if (plan.moving().motion.law) {
        plan.outer_correctors = 2;
        return;
    }
    plan_coupling(plan);
}

/// A mesh that comes down with its body needs air above the tank's top for that way: cells that grow to four times
/// their size.
void grow_upwards(CasePlan& plan) {
    const double below = plan.moving().surface.bounds().min.z() - plan.scene->domain.box.min.z();
    const double more = std::min(plan.mesh_motion.down, below);
    AxisCells& z = plan.axes[2];
    if (more < plan.background_cell) return;
    z.planes.push_back(z.planes.back() + more);
    z.grows.push_back(std::clamp(more / plan.background_cell, 1.0, 4.0));
    const double mean = z.grows.back() > 1.01 ? (z.grows.back() - 1) / std::log(z.grows.back()) : 1;
    z.cells.push_back(std::max(1, static_cast<int>(std::lround(more / (mean * plan.background_cell)))));
}

}  // namespace

CasePlan plan_case(const Scene& scene, const Flavour& flavour) {
    CasePlan plan;
    plan.scene = &scene;
    plan.flavour = flavour;
    plan.stream = scene.motion.kind == Motion::Kind::stream;
    const ForcingZones zones = forcing_zones(scene);
    plan.zones = {Vec3(zones.speed, 0, 0), zones.zones};
    plan.inlet_wave = inlet_wave(scene);
    if (scene.wave) plan.zones.wave = scene.wave->sum;
    if (scene.sea) plan.zones.sea = scene.sea->waves;
    plan.viscous = scene.effect_on("viscosity");
    plan.no_slip = scene.effect_on("no_slip");
    plan.turbulent = scene.effect_on("turbulence");
    plan.sides = patches_of(scene.domain);
    for (Patch& p : plan.sides) p.holds = tank_holds_water(scene) && p.side == Side::slip_wall && !p.empty;
    const Box& box = scene.domain.box;
    if (!box.min.allFinite() || !box.max.allFinite() || !(box.size().minCoeff() > 0) ||
        !(scene.resolution.spacing > 0) || !(scene.resolution.near_hull > 0) || !(scene.run.duration > 0))
        throw InputError(
            "the scene's domain, spacings and duration must be positive numbers before a case can be written");

    if (scene.hull) {
        const Surface& hull = scene.hull->surface;
        plan.solids.push_back({"hull", scene.hull->section ? with_span(hull, endless_span(hull)) : hull, true});
    }
    std::set<std::string> names{"hull"};
    for (const Patch& p : plan.sides) names.insert(p.name);
    for (const Obstacle& o : scene.obstacles) {
        std::string name = word_from(o.name, "obstacle");
        while (!names.insert(name).second) name += "_";
        plan.solids.push_back({name, through_plane(o.surface, scene.domain), false});
    }

    if (scene.tank_motion) need_motion(flavour, "tanks");
    plan_body(plan, names);
    plan.background_cell = plan.finest_cell = background_cell(scene);
    plan_refinement(plan);
    plan.snappy = !plan.solids.empty() || !plan.boxes.empty();
    plan.half_space = scene.water_blocks.empty() && !tailwater(scene);

    // Of blocks that touch the faces of the water that they are together: one within it takes a plane from its level.
    const std::vector<Box> water = plan.half_space ? std::vector<Box>{} : blocks_of_water(scene);
    for (int a = 0; a < 3; ++a) {
        std::vector<double> wanted;
        if (a == 2 && plan.half_space) wanted.push_back(0);
        for (const Box& b : water) wanted.insert(wanted.end(), {b.min[a], b.max[a]});
        for (const Obstacle& o : scene.obstacles)
            if (is_aligned_box(o.surface))
                wanted.insert(wanted.end(), {o.surface.bounds().min[a], o.surface.bounds().max[a]});
        plan.axes[static_cast<std::size_t>(a)] = axis_with_zones(scene, a, plan.background_cell, wanted);
    }
    if (plan.mesh_motion.whole_mesh()) grow_upwards(plan);
    if (scene.domain.dimensions == 2) plan.axes[1] = {{box.min.y(), box.max.y()}, {1}, {1}};
    if (plan.snappy) plan.point_in_fluid = find_point_in_fluid(plan);

    const double length = scene.hull ? scene.hull->length : box.size().x();
    const double speed = plan.stream ? scene.motion.speed
                                     : std::sqrt(std::abs(scene.water.gravity) * box.size().z()) + fastest_wall(scene);
    plan.inlet_omega =
        5 * speed / length;  // a clean stream; the force does not react to it (measured over a factor 10)
    plan.inlet_k = 10 * scene.water.kinematic_viscosity * plan.inlet_omega;

    plan_times(plan);
    plan_viscous_steps(plan);
    if (!plan.bodies.empty() && !plan.scene->hull_is_free() && plan.moving().plate()) {
        plan.plate_interval = plan.moving().plate()->first_period() / pressures_per_period;
        plan.largest_step = std::min(plan.largest_step, plan.plate_interval);  // or there would be no pressures at it
    }
    plan_release(plan);
    plan_probes(plan);
    return plan;
}

namespace {

/// A library that was built before waves could enter has zones alone, an older one lets regular waves in.
bool lets_waves_in(const std::filesystem::path& library, const std::string& type) {
    std::ifstream file(library, std::ios::binary);
    const std::string bytes{std::istreambuf_iterator<char>(file), {}};
    return bytes.find(type) != std::string::npos;
}

/// Without the library waves and the level would come back from the ends, and no result would say so; or OpenFOAM would
/// not know the inlet.
void take_zone_library(CasePlan& plan, const OpenFoam& openfoam) {
    if (plan.zones.zones.empty() && !plan.inlet_wave) return;
    if (!plan.inlet_wave || lets_waves_in(openfoam.zone_library, inlet_wave_type(plan, "waveInletFraction")))
        plan.zone_library = openfoam.zone_library.string();
    if (!plan.zone_library.empty()) return;
    const std::string remedy =
        !plan.flavour.has_forcing_zones() ? "they are written for openfoam.com and for openfoam.org from 12"
        : !openfoam.prefix.empty()
            ? setup_script("build_openfoam_walls.sh").string() +
                  ", started behind TWINWAKE_OPENFOAM_PREFIX, builds it; its folder has to have the same path there"
        : openfoam.solver.parent_path() == openfoam.bin
            ? setup_command() + " builds it in the environment of that release"
            : setup_command() + " builds it";
    const char *has = plan.inlet_wave
                          ? "waves that enter with the stream"
                          : "forcing zones, which absorb the waves that the ends of the water would reflect",
               *instead = plan.inlet_wave ? "use the particle method"
                                          : "switch them off by forcing_zones = \"off\" in [effects], and drag and "
                                            "level depend on the size of the box";
    throw InputError(fmt::format("this scene has {}, and {} {} ({}) has no library of them that works: {}; or {}", has,
                                 openfoam.vendor, openfoam.version, openfoam.command(), remedy, instead));
}

/// Without the library, or a release, a hull is free at once.
void take_hold_library(CasePlan& plan, const OpenFoam& openfoam) {
    if (!plan.scene->hull_is_free()) return;
    if (!(plan.moving().motion.release > 0)) {
        plan.hull_release = "the hull is free at once: its release is the start";
    } else if (openfoam.hold_library.empty()) {
        plan.hull_release =
            "the hull is free at once: this OpenFOAM lacks the library that holds it until its release (" +
            setup_command() + " builds it)";
    } else {
        plan.hull_release = "the hull is held until its release";
        plan.hold_library = openfoam.hold_library.string();
    }
}

}  // namespace

CasePlan plan_case(const Scene& scene, const OpenFoam& openfoam) {
    CasePlan plan = plan_case(scene, Flavour::from_version(openfoam.vendor, openfoam.version));
    // In a tank that is closed all round no volume can come in.
    const bool open = std::any_of(plan.sides.begin(), plan.sides.end(), [](const Patch& p) {
        return p.side == Side::atmosphere || p.open == Patch::Open::water_and_air;
    });
    if (!scene.effect_on("ventilation"))
        plan.walls = "hold water under tension: the effect ventilation is off";
    else if (!open)
        plan.walls = "hold water under tension: the domain is closed, no air can enter";
    else if (openfoam.wall_library.empty())
        plan.walls = "hold water under tension: this OpenFOAM lacks the library for separation at ambient pressure (" +
                     setup_command() + " builds it)";
    else
        plan.walls = "allow separation at ambient pressure where air can reach them",
        plan.wall_library = openfoam.wall_library.string();
    take_zone_library(plan, openfoam);
    take_hold_library(plan, openfoam);
    return plan;
}

}  // namespace tw
