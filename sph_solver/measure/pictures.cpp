#include "sph_solver/measure/pictures.h"

#include <algorithm>

#include <fmt/format.h>

#include "record/water_surface.h"
#include "sph_solver/all_particles.h"

namespace tw {
namespace fs = std::filesystem;

namespace {

/// Of one material, which has the levels [first, last).
Picture::Cloud cloud_of(const Simulation& simulation, std::size_t first, std::size_t last,
                        const AllParticles& particles, const char* name) {
    Picture::Cloud cloud{name, simulation.level(first).system().time, {}, {}};
    Field velocity{"velocity", 3, {}}, pressure{"pressure", 1, {}}, kind{"kind", 1, {}}, size{"spacing", 1, {}};
    const auto& at_rest = simulation.setup().at_rest;
    std::size_t all = 0;
    for (std::size_t k = first; k < last; ++k) all += particles.of(k).size();
    cloud.places.reserve(all);
    for (Field* field : {&velocity, &pressure, &kind, &size})
        field->values.reserve(all * static_cast<std::size_t>(field->components));
    for (std::size_t k = first; k < last; ++k) {
        const LevelSetup& setup = simulation.level(k).system().setup;
        const Particles& p = particles.of(k);
        for (std::size_t i = 0; i < p.size(); ++i) {
            if (!is_active(p.kind[i])) continue;
            cloud.places.emplace_back(p.x[i], p.y[i], p.z[i]);
            velocity.values.insert(velocity.values.end(), {p.u[i], p.v[i], p.w[i]});
            const double carried = double(setup.state_equation.pressure(setup.rho0, p.drho[i]));
            pressure.values.push_back(static_cast<float>(at_rest ? carried + at_rest->at(p.z[i]) : carried));
            kind.values.push_back(static_cast<float>(p.kind[i]));
            size.values.push_back(static_cast<float>(setup.dp));
        }
    }
    cloud.fields = {std::move(velocity), std::move(pressure), std::move(kind), std::move(size)};
    return cloud;
}

/// What `water_surface` reads of a record, of its last frame alone.
RunRecord water_of_last_frame(const RunRecord& record) {
    RunRecord water;
    if (record.frames.empty()) return water;
    water.attributes = record.attributes;
    water.raster = record.raster;
    water.frames = {record.frames.back()};
    return water;
}

}  // namespace

Picture picture_of(const Simulation& simulation, const RunRecord& record) {
    const AllParticles particles(simulation);
    Picture picture;
    if (!simulation.level(0).system().ranks().first()) return picture;
    picture.time = simulation.time();
    const std::size_t water = simulation.water().size();
    picture.clouds.push_back(cloud_of(simulation, 0, water, particles, "particles"));
    if (simulation.gas()) picture.clouds.push_back(cloud_of(simulation, water, water + 1, particles, "air"));
    picture.water = water_of_last_frame(record);
    const bool has_hull = !record.hull_pressure.empty();  // drawn with its pressure
    const SimulationSetup& s = simulation.setup();
    for (const auto& body : simulation.bodies())
        if (!body->fixed() && !(has_hull && body->is_hull()))  // a section as thick as the water
            picture.surfaces.push_back(
                {body_table(body->name()),
                 body->surface_now(s.dimensions == 2 ? std::optional(s.domain.size().y()) : std::nullopt),
                 {}});
    if (has_hull)
        picture.surfaces.push_back(
            {"hull", record.hull, {{"pressure", 1, record.hull_pressure}, {"wet", 1, record.hull_wet}}});
    return picture;
}

void Pictures::write(const Picture& picture) {
    fs::create_directory(folder_);  // in the run's folder; where that was moved away, nothing is made
    const std::string stamp = fmt::format("{:09.5f}", picture.time);
    for (const Picture::Cloud& cloud : picture.clouds) {
        const std::string file = cloud.name + "_" + stamp + ".hdf";
        write_particles(folder_ / file, cloud.time, cloud.places, cloud.fields);
        note(cloud.name, ".hdf", file, cloud.time);
    }
    write_water(picture.water);
    for (const Picture::OfSurface& one : picture.surfaces) {
        const std::string file = one.name + "_" + stamp + ".vtp";
        write_surface(folder_ / file, one.surface, one.fields);
        note(one.name, ".vtp", file, picture.time);
    }
}

void Pictures::note(const std::string& name, const char* ending, const std::string& file, double time) {
    Series& series = series_[name];
    series.emplace_back(file, time);
    write_series(folder_ / (name + ending + ".series"), series);
}

/// The free surface of a raster frame under its own time; one that is there already is left.
void Pictures::write_water(const RunRecord& record) {
    if (record.frames.empty()) return;
    const RasterFrame& frame = record.frames.back();
    const std::string file = fmt::format("free_surface_{:09.5f}.vtp", frame.time);
    const Series& written = series_["free_surface"];
    if (!written.empty() && written.back().first == file) return;
    const Surface water = water_surface(record, frame);
    if (water.triangles.empty()) return;
    write_surface(folder_ / file, water, {});
    note("free_surface", ".vtp", file, frame.time);
}

void Pictures::find_written(double time) {
    std::error_code none;
    for (const auto& entry : fs::directory_iterator(folder_, none)) {
        const std::string file = entry.path().filename().string();
        if (!file.ends_with(".series") || !entry.is_regular_file(none)) continue;
        Series series = read_series(entry.path());
        std::erase_if(series, [&](const auto& f) { return f.second > time || !fs::exists(folder_ / f.first); });
        series_[file.substr(0, file.find('.'))] = std::move(series);
    }
}

}  // namespace tw
