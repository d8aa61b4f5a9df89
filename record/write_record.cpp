#include <hdf5.h>

#include <algorithm>
#include <fstream>
#include <set>

#include <fmt/format.h>

#include "base/atomic_file.h"
#include "base/errors.h"
#include "record/checksum_line.h"
#include "record/hdf5_file.h"
#include "record/record_layout.h"
#include "record/run_record.h"

namespace tw {
namespace fs = std::filesystem;

namespace {

/// A link name HDF5 and h5py take as one path element; the true name is kept in the attribute "name".
std::string link_name(const std::string& name, std::set<std::string>& taken) {
    std::string link;
    for (const char c : name) link += static_cast<unsigned char>(c) < 0x20 || c == '/' ? '_' : c;
    if (link.empty() || link == "." || link == "..") link = "_" + link;
    std::string unique = link;
    for (int k = 2; !taken.insert(unique).second; ++k) unique = fmt::format("{}#{}", link, k);
    return unique;
}

void write_column(hid_t group, const std::string& link, const Column& column) {
    h5::write_vector(group, link.c_str(), H5T_NATIVE_DOUBLE, column.values);
    const h5::Handle set = h5::open_dataset(group, link.c_str());
    h5::write_attribute(set, "name", column.name);
    h5::write_attribute(set, "unit", column.unit);
}

void write_tables(hid_t file, const RunRecord& record) {
    const h5::Handle tables = h5::create_group(file, layout::tables);
    std::set<std::string> table_links;
    for (const auto& [name, table] : record.tables) {
        const h5::Handle group = h5::create_group(tables, link_name(name, table_links).c_str());
        h5::write_attribute(group, "name", name);
        std::set<std::string> links;
        write_column(group, link_name("time", links), {"time", "s", table.time});
        for (const Column& c : table.columns) {
            if (c.values.size() != table.time.size())
                throw RunError(fmt::format("run record: column {} of table {} has {} values for {} times", c.name, name,
                                           c.values.size(), table.time.size()));
            write_column(group, link_name(c.name, links), c);
        }
    }
}

void write_raster(hid_t file, const RunRecord& record) {
    const h5::Handle group = h5::create_group(file, layout::raster);
    const RasterSpec& spec = record.raster;
    h5::write_attribute(group, "origin", std::span<const double>(spec.origin.data(), 3));
    h5::write_attribute(group, "spacing", spec.voxel);
    const std::array<long long, 3> count{spec.count[0], spec.count[1], spec.count[2]};
    h5::write_attribute(group, "count", count);
    const std::size_t voxels = static_cast<std::size_t>(spec.count[0]) * static_cast<std::size_t>(spec.count[1]) *
                               static_cast<std::size_t>(spec.count[2]);
    std::vector<double> times;
    std::vector<std::uint8_t> water;
    water.reserve(voxels * record.frames.size());
    for (const RasterFrame& f : record.frames) {
        if (f.water.size() != voxels)
            throw RunError(fmt::format("run record: the raster frame of t = {} s has {} voxels, not {}", f.time,
                                       f.water.size(), voxels));
        times.push_back(f.time);
        water.insert(water.end(), f.water.begin(), f.water.end());
    }
    h5::write_vector(group, "time", H5T_NATIVE_DOUBLE, times, false);
    const std::array<hsize_t, 4> dims{times.size(), static_cast<hsize_t>(spec.count[2]),
                                      static_cast<hsize_t>(spec.count[1]), static_cast<hsize_t>(spec.count[0])};
    h5::write_array(group, "water", H5T_NATIVE_UINT8, water.data(), dims, true);
}

void write_triangles(hid_t group, const Surface& surface) {
    std::vector<double> points;
    for (const Vec3& p : surface.points) points.insert(points.end(), p.data(), p.data() + 3);
    const std::array<hsize_t, 2> point_dims{surface.points.size(), 3}, triangle_dims{surface.triangles.size(), 3};
    h5::write_array(group, "points", H5T_NATIVE_DOUBLE, points.data(), point_dims, true);
    h5::write_array(group, "triangles", H5T_NATIVE_INT, surface.triangles.data(), triangle_dims, true);
}

void write_bodies(hid_t file, const RunRecord& record) {
    const h5::Handle bodies = h5::create_group(file, layout::bodies);
    std::set<std::string> links;
    for (const BodyShape& body : record.bodies) {
        const h5::Handle group = h5::create_group(bodies, link_name(body.table, links).c_str());
        h5::write_attribute(group, "table", body.table);
        h5::write_attribute(group, "centre", std::span<const double>(body.centre.data(), 3));
        write_triangles(group, body.surface);
    }
}

void write_hull(hid_t file, const RunRecord& record) {
    const h5::Handle group = h5::create_group(file, layout::hull);
    write_triangles(group, record.hull);
    h5::write_vector(group, "pressure", H5T_NATIVE_FLOAT, record.hull_pressure);
    h5::write_vector(group, "wet", H5T_NATIVE_FLOAT, record.hull_wet);
}

void write_cost(hid_t file, const RunRecord& record) {
    const h5::Handle group = h5::create_group(file, layout::cost);
    std::vector<std::string> names;
    std::vector<double> wall, cpu;
    for (const Phase& p : record.phases) {
        names.push_back(p.name);
        wall.push_back(p.wall);
        cpu.push_back(p.cpu);
    }
    h5::write_texts(group, "phase", names);
    h5::write_vector(group, "wall", H5T_NATIVE_DOUBLE, wall, false);
    h5::write_vector(group, "cpu", H5T_NATIVE_DOUBLE, cpu, false);
    h5::write_attribute(group, "peak_memory", record.peak_memory);
    h5::write_attribute(group, "elements", record.elements);
    h5::write_attribute(group, "steps", record.steps);
}

void write_bounds(hid_t effects, const RunRecord& record) {
    const h5::Handle group = h5::create_group(effects, layout::bounds);
    std::vector<std::string> effect, of, unit, source, elements;
    std::vector<double> below, above;
    for (const EffectChoice& e : record.effects)
        for (const EffectBound& b : e.bounds) {
            effect.push_back(e.name), of.push_back(b.of), unit.push_back(b.unit);
            source.push_back(b.source), elements.push_back(b.elements);
            below.push_back(b.below), above.push_back(b.above);
        }
    for (const auto& [column, texts] : {std::pair{"effect", &effect}, std::pair{"of", &of}, std::pair{"unit", &unit},
                                        std::pair{"source", &source}, std::pair{"elements", &elements}})
        h5::write_texts(group, column, *texts);
    h5::write_vector(group, "below", H5T_NATIVE_DOUBLE, below, false);
    h5::write_vector(group, "above", H5T_NATIVE_DOUBLE, above, false);
}

void write_effects(hid_t file, const RunRecord& record) {
    const h5::Handle group = h5::create_group(file, layout::effects);
    std::vector<std::string> name, reason, influence;
    std::vector<double> cost;
    std::vector<int> on, forced;
    for (const EffectChoice& e : record.effects) {
        name.push_back(e.name);
        reason.push_back(e.reason);
        influence.push_back(e.influence);
        cost.push_back(e.cost);
        on.push_back(e.on);
        forced.push_back(e.forced);
    }
    h5::write_texts(group, "name", name);
    h5::write_texts(group, "reason", reason);
    h5::write_texts(group, "influence", influence);
    h5::write_vector(group, "cost", H5T_NATIVE_DOUBLE, cost, false);
    h5::write_vector(group, "on", H5T_NATIVE_INT, on, false);
    h5::write_vector(group, "forced", H5T_NATIVE_INT, forced, false);
    write_bounds(group, record);
}

void write_validity_checks(hid_t file, const RunRecord& record) {
    const h5::Handle group = h5::create_group(file, layout::validity_checks);
    std::vector<std::string> name, unit;
    std::vector<double> value, limit, time, x, y, z;
    for (const RecordedCheck& l : record.validity_checks) {
        name.push_back(l.name), unit.push_back(l.unit);
        value.push_back(l.value), limit.push_back(l.limit), time.push_back(l.time);
        x.push_back(l.place.x()), y.push_back(l.place.y()), z.push_back(l.place.z());
    }
    h5::write_texts(group, "name", name);
    h5::write_texts(group, "unit", unit);
    for (const auto& [column, values] :
         {std::pair{"value", &value}, std::pair{"limit", &limit}, std::pair{"time", &time}, std::pair{"x", &x},
          std::pair{"y", &y}, std::pair{"z", &z}})
        h5::write_vector(group, column, H5T_NATIVE_DOUBLE, *values, false);
}

void write_resolution(hid_t file, const RunRecord& record) {
    const h5::Handle group = h5::create_group(file, layout::resolution);
    std::vector<double> size, corners;
    for (const ResolvedBox& r : record.resolution) {
        size.push_back(r.size);
        for (const Vec3& corner : {r.box.min, r.box.max})
            corners.insert(corners.end(), corner.data(), corner.data() + 3);
    }
    h5::write_vector(group, "size", H5T_NATIVE_DOUBLE, size, false);
    const std::array<hsize_t, 3> dims{size.size(), 2, 3};
    h5::write_array(group, "box", H5T_NATIVE_DOUBLE, corners.data(), dims, false);
}

std::string record_bytes(const RunRecord& record) {
    const h5::Handle file = h5::create_in_memory();
    h5::write_attribute(file, layout::kind_attribute, layout::kind);
    h5::write_attribute(file, layout::version_attribute, RunRecord::format_version);
    h5::write_attribute(file, "state", record.state);
    h5::write_attribute(file, "reason", record.reason);
    h5::write_texts(file, layout::scene_text, {record.scene_text});
    {
        const h5::Handle group = h5::create_group(file, layout::attributes);
        for (const auto& [name, text] : record.attributes) h5::write_attribute(group, name.c_str(), text);
    }
    {
        const h5::Handle group = h5::create_group(file, layout::numbers);
        for (const auto& [name, value] : record.numbers) h5::write_attribute(group, name.c_str(), value);
    }
    write_tables(file, record);
    write_raster(file, record);
    write_hull(file, record);
    write_bodies(file, record);
    write_cost(file, record);
    write_effects(file, record);
    write_validity_checks(file, record);
    write_resolution(file, record);
    return h5::image(file);
}

}  // namespace

void write_record(const fs::path& file, const RunRecord& record) {
    const h5::Silence silence;
    std::string bytes;
    try {
        bytes = record_bytes(record);
    } catch (const h5::Failure& f) { throw RunError(file.string() + ": cannot be written: HDF5 failed at " + f.what); }
    write_text_atomically(file, with_checksum_line(std::move(bytes)));
}

}  // namespace tw
