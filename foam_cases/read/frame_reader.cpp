#include "foam_cases/read/frame_reader.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>

#include "base/numbers.h"
#include "foam_cases/read/body_rows.h"
#include "foam_cases/read/field_file.h"
#include "foam_cases/read/level_at_ends.h"
#include "meshes/section.h"
#include "record/raster.h"
#include "record/recorded_checks.h"
#include "record/water_in_box.h"
#include "scene/defaults.h"
#include "scene/new_record.h"
#include "scene/solids/friction_line.h"
#include "scene/water/tailwater.h"

namespace tw {
namespace fs = std::filesystem;

namespace {

using Values = std::initializer_list<std::tuple<const char*, std::string, double>>;  ///< name, unit, value
void append(Table& table, double time, const Values& values) {
    const std::size_t row = table.append(time);
    for (const auto& [name, unit, value] : values) table.set(row, name, unit, value);
}

/// The patch as a surface with one value per triangle; a half model is mirrored to the whole.
void keep_picture(const HullPatch& patch, bool half, RunRecord& record) {
    record.hull = patch.surface;
    record.hull_pressure.clear();
    record.hull_wet.clear();
    for (const int f : patch.face_of_triangle) {
        record.hull_pressure.push_back(static_cast<float>(patch.faces[static_cast<std::size_t>(f)].pressure));
        record.hull_wet.push_back(static_cast<float>(patch.faces[static_cast<std::size_t>(f)].water));
    }
    if (!half) return;
    const int points = static_cast<int>(record.hull.points.size());
    const std::size_t triangles = record.hull.triangles.size();
    for (int i = 0; i < points; ++i) {
        Vec3 p = record.hull.points[static_cast<std::size_t>(i)];
        p.y() = -p.y();
        record.hull.points.push_back(p);
    }
    for (std::size_t t = 0; t < triangles; ++t) {
        const auto a = record.hull.triangles[t];
        record.hull.triangles.push_back({a[0] + points, a[2] + points, a[1] + points});
        record.hull_pressure.push_back(record.hull_pressure[t]);
        record.hull_wet.push_back(record.hull_wet[t]);
    }
}

/// Edges of a cell as the cuboid that it is taken for [m]: of a section's mesh, one cell wide, as long as it is high.
Vec3 edges_of_cell(double volume, const Scene& scene) {
    if (scene.domain.dimensions != 2) return Vec3::Constant(std::cbrt(volume));
    const double edge = std::sqrt(volume / scene.span());
    return {edge, scene.span(), edge};
}

/// Whether the mesh has faces of a patch: constant/polyMesh/boundary lists each as NAME { ... nFaces N; ... }.
bool has_faces(const fs::path& case_folder, const std::string& patch) {
    std::ifstream file(case_folder / "constant/polyMesh/boundary");
    std::string word;
    while (file >> word && word != patch) {}
    while (file >> word && word != "nFaces") {}
    int faces = 0;
    return file >> faces && faces > 0;
}

}  // namespace

Walls read_walls(const CasePlan& plan, const fs::path& case_folder, const std::string& time_name) {
    Walls walls;
    for (const Solid& s : plan.solids)
        walls.push_back(read_hull_patch(
            case_folder / "postProcessing" / (s.is_hull ? "hullSurface" : "bodySurfaces") / time_name, s.name));
    return walls;
}

std::optional<WaterLoad> read_load(const CasePlan& plan, const fs::path& case_folder, const Walls& walls) {
    std::optional<WaterLoad> sum;
    for (std::size_t i = 0; i < walls.size(); ++i) {
        if (!plan.counts_load_on(plan.solids[i])) continue;
        if (!walls[i]) {
            if (has_faces(case_folder, plan.solids[i].name)) return std::nullopt;
            continue;
        }
        const Water& water = plan.scene->water;
        const WaterLoad load = water_load(*walls[i], water.density, water.air_density, moment_reference(*plan.scene));
        if (sum)
            *sum += load;
        else
            sum = load;
    }
    return sum;
}

RecordedCheck continuity_of_held_hull(const Scene& scene, const SolverLog::Step& step) {
    constexpr double limit = 0.3;
    const double passing = scene.hull->length / scene.motion.speed;
    return {"continuity error", "%", 100 * step.continuity / step.step * passing, limit, step.time};
}

FrameReader::FrameReader(const CasePlan& plan, const fs::path& case_folder)
    : plan_(plan), case_(case_folder), folders_(case_folder) {
    for (const fs::path& root : folders_.roots()) parts_.push_back(read_part(root / "0"));
}

FrameReader::Part FrameReader::read_part(const fs::path& folder) {
    const FieldFile centres = read_field(folder / "C"), volumes = read_field(folder / cell_volumes_in(folder));
    Part part;
    const std::size_t n = std::max(centres.uniform ? 0 : centres.cells(), volumes.uniform ? 0 : volumes.cells());
    for (std::size_t i = 0; i < n; ++i) {
        part.centres.push_back(centres.vector(i));
        part.volumes.push_back(volumes.scalar(i));
    }
    return part;
}

std::size_t FrameReader::cells() const {
    std::size_t n = 0;
    for (const Part& p : parts_) n += p.volumes.size();
    return n;
}

void FrameReader::read(const TimeFolders::Moment& moment, const SolverLog& log, RunRecord& record) {
    read_water(moment, log, record);
    const Walls walls = read_walls(plan_, case_, moment.name);
    if (const auto load = read_load(plan_, case_, walls)) {
        keep_load(moment.time, *load, record);
        if (plan_.scene->hull) keep_hull(moment.time, walls.front().value(), *load, record);
    }
    keep_suction(walls, record);
}

/// Whether a write time is the first that belongs to its frame's time, within half a step as OpenFOAM writes.
bool FrameReader::frame_is_due(double time, const SolverLog& log, const RunRecord& record) const {
    if (plan_.raster_every == 1) return true;
    const double interval = plan_.write_interval * plan_.raster_every;
    const auto reached = [&](double t) {
        const SolverLog::Step* step = log.at(t);
        return std::floor((t + (step != nullptr ? step->step / 2 : 0)) / interval + 1e-4);
    };
    return reached(time) > (record.frames.empty() ? 0 : reached(record.frames.back().time));
}

void FrameReader::read_water(const TimeFolders::Moment& moment, const SolverLog& log, RunRecord& record) const {
    const Scene& scene = *plan_.scene;
    const double factor = scene.symmetry_factor() / scene.span(), density = scene.water.density,
                 g = std::abs(scene.water.gravity);
    double volume = 0, kinetic = 0, potential = 0, fastest = 0, too_fast = 0;
    const double limit = plan_.water_speed_limit * plan_.water_speed_limit;
    LevelAtEnds level(scene);
    const bool to_raster = scene.sampling.raster.voxel > 0 && frame_is_due(moment.time, log, record);
    Raster raster(scene.sampling.raster);
    std::vector<double> in_boxes(scene.sampling.volumes.size());  // [m3]
    for (std::size_t k = 0; k < parts_.size(); ++k) {
        const fs::path folder = folders_.roots()[k] / moment.name;
        const FieldFile alpha = read_field(folder / "alpha.water"), speed = read_field(folder / "U");
        const Part moved = !plan_.mesh_moves() ? Part{} : read_part(folder);
        const Part& part = !plan_.mesh_moves() ? parts_[k] : moved;
        for (std::size_t i = 0; i < part.volumes.size(); ++i) {
            const double share = alpha.scalar(i), water = share * part.volumes[i];
            volume += water;
            level.add(part.centres[i], part.volumes[i], water);
            if (to_raster) raster.pour_cell(part.centres[i], part.volumes[i], water);
            if (!in_boxes.empty()) {
                const Vec3 edges = edges_of_cell(part.volumes[i], scene);
                for (std::size_t b = 0; b < in_boxes.size(); ++b)
                    in_boxes[b] += water * share_in_box(scene.sampling.volumes[b].box, part.centres[i], edges);
            }
            if (share <= 1e-6) continue;
            const double v2 = speed.vector(i).squaredNorm();
            kinetic += 0.5 * density * water * v2;
            potential += density * g * water * part.centres[i].z();
            if (share > 0.5) fastest = std::max(fastest, v2);
            if (!(v2 <= limit)) too_fast += water;
        }
    }
    if (to_raster) record.frames.push_back(raster.frame(moment.time));
    const SolverLog::Step* step = log.at(moment.time);
    const double unknown = std::nan("");
    // Through a mesh that moves as a whole water comes and goes: what is in it tells nothing.
    const double keeps_water = plan_.mesh_motion.whole_mesh() ? unknown : 1;
    append(record.table("samples"), moment.time,
           {{"mass", scene.spanwise_unit("kg"), keeps_water * factor * density * volume},
            {"kinetic_energy", scene.spanwise_unit("J"), keeps_water * factor * kinetic},
            {"potential_energy", scene.spanwise_unit("J"), keeps_water * factor * potential},
            {"dt", "s", step != nullptr ? step->step : unknown},
            {"max_courant", "-", step != nullptr ? step->courant : unknown},
            {"max_speed", "m/s", std::sqrt(fastest)},
            {fast_water, "-", volume > 0 ? too_fast / volume : 0},
            {"cells", "-", static_cast<double>(cells())}});
    level.keep(record);
    keep_volumes(moment.time, in_boxes, record);
    // OpenFOAM's step follows its Courant number with a delay; a multiple of the limit is a fault. Places are not
    // known.
    const Vec3 nowhere = RecordedCheck{}.place;
    if (step != nullptr)
        note_worst(record, {"Courant number", "-", step->courant, 2 * scene.fvm.max_courant, moment.time, nowhere});
    if (hull_held_in_stream(scene) && step != nullptr && moment.time >= scene.sampling.mean_from)
        note_worst(record, continuity_of_held_hull(scene, *step));
    if (scene.motion.speed > 0)
        note_worst(record, {"water speed over stream", "-", std::sqrt(fastest) / fastest_stream(scene), 3, moment.time,
                            nowhere});
    // a body or a tank that moves does work on the water
    if (!plan_.mesh_moves() && !scene.tank_motion) watch_energy(record);
}

void FrameReader::keep_volumes(double time, const std::vector<double>& in_boxes, RunRecord& record) const {
    const Scene& scene = *plan_.scene;
    if (in_boxes.empty()) return;
    Table& t = record.table(volume_table);
    const std::size_t row = t.append(time);
    for (std::size_t b = 0; b < in_boxes.size(); ++b)
        t.set(row, scene.sampling.volumes[b].name, scene.spanwise_unit("m3"), in_boxes[b] / scene.span());
}

void FrameReader::keep_load(double time, const WaterLoad& load, RunRecord& record) const {
    const Scene& scene = *plan_.scene;
    const double factor = scene.symmetry_factor() / scene.span();
    // The two halves' side forces cancel.
    const Vec3 whole(factor, scene.symmetry_factor() > 1 ? 0 : factor, factor);
    const std::string N = scene.spanwise_unit("N");
    const Vec3 pressing = load.pressure.cwiseProduct(whole), rubbing = load.viscous.cwiseProduct(whole);
    append(record.table("forces"), time,
           {{"fx", N, pressing.x() + rubbing.x()},
            {"fy", N, pressing.y() + rubbing.y()},
            {"fz", N, pressing.z() + rubbing.z()},
            {"fx_pressure", N, pressing.x()},
            {"fy_pressure", N, pressing.y()},
            {"fz_pressure", N, pressing.z()},
            {"fx_viscous", N, rubbing.x()},
            {"fy_viscous", N, rubbing.y()},
            {"fz_viscous", N, rubbing.z()},
            {"fx_viscous_uncorrected", N, factor * load.viscous_mixture.x()},
            {"fx_air", N, factor * load.air.x()},
            {"fz_air", N, factor * load.air.z()},
            {"my", scene.spanwise_unit("N m"), factor * load.moment.y()}});
}

void FrameReader::keep_hull(double time, const HullPatch& patch, const WaterLoad& load, RunRecord& record) const {
    const Scene& scene = *plan_.scene;
    Table& samples = record.table("samples");
    const auto sample = [&](const char* name, const std::string& unit, double value) {
        samples.set(samples.time.size() - 1, name, unit, value);
    };
    note_mesh_error(time, patch, record);
    const double factor = scene.symmetry_factor() / scene.span();
    sample("wetted_area", scene.spanwise_unit("m2"), factor * load.wetted_area);
    sample("wetted_length", "m", load.wetted_length);
    if (scene.effect_on("friction"))
        sample("friction_line", scene.spanwise_unit("N"),
               friction_by_line(scene, factor * load.wetted_area, load.wetted_length));
    sample("ventilation", "-", load.ventilation);
    picture_hull(patch, record);
}

void FrameReader::note_mesh_error(double time, const HullPatch& patch, RunRecord& record) const {
    if (record.numbers.count("hull_mesh_error") != 0) return;  // once: corners near and below still water
    const Scene& scene = *plan_.scene;
    const Vec3 low = scene.hull->surface.bounds().min;
    const double edge = plan_.finest_cell;
    const Surface all =
        plan_.scene->hull_is_free() ? free_hull_at(plan_, case_ / "postProcessing", time) : scene.hull->surface;
    const Surface hull = scene.hull->section ? with_span(all, scene.span()) : all;
    const double error = mesh_error(patch, hull, scene.symmetry_factor() > 1 ? -1e-6 * edge : low.y(),
                                    std::max(0.0, 0.3 * std::abs(low.z())));
    record.numbers["hull_mesh_error"] = error;
    if (error > 0.15 * edge)
        record.attributes["mesh_warning"] = fmt::format(
            "an edge or corner of the hull's wet part is missed by {:.3g} m, {:.2g} of the finest cell: "
            "the force may be off by much; use a smaller near_hull",
            error, error / edge);
}

void FrameReader::picture_hull(const HullPatch& patch, RunRecord& record) const {
    keep_picture(patch, plan_.scene->symmetry_factor() > 1, record);
    if (plan_.scene->hull->section) record.hull = with_span(record.hull, 1);
}

void FrameReader::show_hull(const TimeFolders::Moment& moment, RunRecord& record) const {
    if (!plan_.scene->hull) return;
    const Walls walls = read_walls(plan_, case_, moment.name);
    if (!walls.front()) return;
    note_mesh_error(moment.time, *walls.front(), record);
    picture_hull(*walls.front(), record);
}

void FrameReader::keep_suction(const Walls& walls, RunRecord& record) const {
    const Scene& scene = *plan_.scene;
    const double factor = scene.symmetry_factor() / scene.span();
    Table& samples = record.table("samples");
    for (std::size_t i = 0; i < walls.size(); ++i) {
        const Solid& s = plan_.solids[i];
        const std::optional<WetWall> wall = walls[i] ? std::optional(wet_wall(*walls[i])) : std::nullopt;
        const auto sample = [&](const std::string& name, const std::string& unit, double value) {
            samples.set(samples.time.size() - 1, name + s.name, unit, value);
        };
        sample("suction_area_", scene.spanwise_unit("m2"), wall ? factor * wall->suction_area() : nan);
        sample("suction_force_", scene.spanwise_unit("N"), wall ? factor * wall->suction_force() : nan);
        if (s.moves && !s.is_hull) sample("leaving_angle_", "deg", wall ? wall->leaving_angle() / degree : nan);
    }
}

}  // namespace tw
