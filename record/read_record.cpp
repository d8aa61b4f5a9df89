#include <hdf5.h>

#include <algorithm>
#include <new>
#include <stdexcept>

#include <fmt/format.h>

#include "base/atomic_file.h"
#include "base/errors.h"
#include "base/trial.h"
#include "record/check_values.h"
#include "record/checksum_line.h"
#include "record/hdf5_file.h"
#include "record/record_layout.h"
#include "record/run_record.h"

namespace tw {
namespace fs = std::filesystem;

namespace {

[[noreturn]] void refuse_changed(const fs::path& file) {
    throw InputError(file.string() + ": damaged: its bytes do not fit their checksum; copy or run it again");
}

/// Refuses what is no HDF5 file, or is of the older format, which HDF5 does not check, and not as it was written.
Bytes check_bytes(const fs::path& file) {
    if (!fs::exists(file))
        throw InputError(file.string() + ": there is no such run record; a run leaves it as record.h5 in its folder");
    if (fs::is_directory(file)) throw InputError(file.string() + ": is a folder; give the record.h5 in it");
    if (!fs::is_regular_file(file)) throw InputError(file.string() + ": is not a file");
    const std::string bytes = read_text(file);
    static constexpr std::string_view signature("\x89HDF\r\n\x1a\n", 8);
    if (!bytes.starts_with(signature))
        throw InputError(fmt::format("{}: not a run record: not an HDF5 file ({} bytes)", file.string(), bytes.size()));
    const Bytes state = judge_bytes(bytes);
    if (state == Bytes::changed && bytes[signature.size()] < h5::first_checked_format) refuse_changed(file);
    return state;
}

double number(hid_t object, const char* name) { return h5::read_numbers_attribute(object, name).at(0); }

void read_tables(hid_t file, RunRecord& record) {
    const h5::Handle tables = h5::open_group(file, layout::tables);
    for (const std::string& link : h5::member_names(tables)) {
        const h5::Handle group = h5::open_group(tables, link.c_str());
        Table& table = record.table(h5::has_attribute(group, "name") ? h5::read_text_attribute(group, "name") : link);
        table.time = h5::read_vector<double>(group, "time", H5T_NATIVE_DOUBLE);
        for (const std::string& column_link : h5::member_names(group)) {
            if (column_link == "time") continue;
            const h5::Handle set = h5::open_dataset(group, column_link.c_str());
            Column& column =
                table.column(h5::has_attribute(set, "name") ? h5::read_text_attribute(set, "name") : column_link,
                             h5::has_attribute(set, "unit") ? h5::read_text_attribute(set, "unit") : "");
            column.values = h5::read_vector<double>(group, column_link.c_str(), H5T_NATIVE_DOUBLE);
            if (column.values.size() != table.time.size())
                throw h5::Failure{"column " + column.name + " of table " + table.name + " is not as long as its time"};
        }
    }
}

void read_raster(hid_t file, RunRecord& record) {
    const h5::Handle group = h5::open_group(file, layout::raster);
    const auto origin = h5::read_numbers_attribute(group, "origin"), count = h5::read_numbers_attribute(group, "count");
    if (origin.size() != 3 || count.size() != 3) throw h5::Failure{"the raster's origin or count is not three numbers"};
    RasterSpec& spec = record.raster;
    spec.origin = {origin[0], origin[1], origin[2]};
    spec.voxel = number(group, "spacing");
    for (std::size_t k = 0; k < 3; ++k) {
        if (!(count[k] >= 0 && count[k] < 1e6)) throw h5::Failure{"the raster's count is senseless"};
        spec.count[k] = static_cast<int>(count[k]);
    }
    const auto times = h5::read_vector<double>(group, "time", H5T_NATIVE_DOUBLE);
    const auto dims = h5::dimensions(group, "water");
    if (dims.size() != 4 || dims[0] != times.size() || dims[1] != static_cast<hsize_t>(spec.count[2]) ||
        dims[2] != static_cast<hsize_t>(spec.count[1]) || dims[3] != static_cast<hsize_t>(spec.count[0]))
        throw h5::Failure{"raster/water does not have the raster's size"};
    const std::size_t voxels = dims[1] * dims[2] * dims[3];
    std::vector<std::uint8_t> water(voxels * times.size());
    h5::read_array(group, "water", H5T_NATIVE_UINT8, water.data(), water.size());
    for (std::size_t f = 0; f < times.size(); ++f) {
        const auto first = water.begin() + static_cast<std::ptrdiff_t>(f * voxels);
        record.frames.push_back({times[f], {first, first + static_cast<std::ptrdiff_t>(voxels)}});
    }
}

/// `what`: whose surface it is, for messages.
Surface read_triangles(hid_t group, const std::string& what) {
    const auto point_dims = h5::dimensions(group, "points"), triangle_dims = h5::dimensions(group, "triangles");
    if (point_dims.size() != 2 || point_dims[1] != 3 || triangle_dims.size() != 2 || triangle_dims[1] != 3)
        throw h5::Failure{what + ": its points or triangles are not threes"};
    Surface surface;
    std::vector<double> points(point_dims[0] * 3);
    h5::read_array(group, "points", H5T_NATIVE_DOUBLE, points.data(), points.size());
    for (std::size_t i = 0; i < points.size(); i += 3)
        surface.points.emplace_back(points[i], points[i + 1], points[i + 2]);
    surface.triangles.resize(triangle_dims[0]);
    h5::read_array(group, "triangles", H5T_NATIVE_INT, surface.triangles.data(), surface.triangles.size() * 3);
    for (const auto& t : surface.triangles)
        for (const int corner : t)
            if (corner < 0 || static_cast<std::size_t>(corner) >= surface.points.size())
                throw h5::Failure{what + ": a triangle names a point that is not there"};
    return surface;
}

void read_bodies(hid_t file, RunRecord& record) {
    if (!h5::has(file, layout::bodies)) return;  // records had none at first
    const h5::Handle bodies = h5::open_group(file, layout::bodies);
    for (const std::string& link : h5::member_names(bodies)) {
        const h5::Handle group = h5::open_group(bodies, link.c_str());
        const std::string table = h5::read_text_attribute(group, "table");
        const auto centre = h5::read_numbers_attribute(group, "centre");
        if (centre.size() != 3) throw h5::Failure{table + ": its centre of mass is not three numbers"};
        record.bodies.push_back({table, read_triangles(group, table), Vec3(centre.data())});
    }
}

void read_hull(hid_t file, RunRecord& record) {
    const h5::Handle group = h5::open_group(file, layout::hull);
    record.hull = read_triangles(group, "the hull");
    record.hull_pressure = h5::read_vector<float>(group, "pressure", H5T_NATIVE_FLOAT);
    record.hull_wet = h5::read_vector<float>(group, "wet", H5T_NATIVE_FLOAT);
    for (const auto* values : {&record.hull_pressure, &record.hull_wet})
        if (!values->empty() && values->size() != record.hull.triangles.size())
            throw h5::Failure{"the hull's pressure or wetness is not one value per triangle"};
}

void read_cost(hid_t file, RunRecord& record) {
    const h5::Handle group = h5::open_group(file, layout::cost);
    const auto names = h5::read_texts(group, "phase");
    const auto wall = h5::read_vector<double>(group, "wall", H5T_NATIVE_DOUBLE),
               cpu = h5::read_vector<double>(group, "cpu", H5T_NATIVE_DOUBLE);
    if (wall.size() != names.size() || cpu.size() != names.size())
        throw h5::Failure{"the columns of cost differ in length"};
    for (std::size_t i = 0; i < names.size(); ++i) record.phases.push_back({names[i], wall[i], cpu[i]});
    record.peak_memory = number(group, "peak_memory");
    record.elements = number(group, "elements");
    record.steps = number(group, "steps");
}

void read_bounds(hid_t effects, RunRecord& record) {
    if (!h5::has(effects, layout::bounds)) return;  // records had none at first
    const h5::Handle group = h5::open_group(effects, layout::bounds);
    const auto effect = h5::read_texts(group, "effect"), of = h5::read_texts(group, "of"),
               unit = h5::read_texts(group, "unit"), source = h5::read_texts(group, "source"),
               elements = h5::read_texts(group, "elements");
    const auto below = h5::read_vector<double>(group, "below", H5T_NATIVE_DOUBLE),
               above = h5::read_vector<double>(group, "above", H5T_NATIVE_DOUBLE);
    const std::size_t n = effect.size();
    for (const std::size_t size : {of.size(), unit.size(), source.size(), elements.size(), below.size(), above.size()})
        if (size != n) throw h5::Failure{"the columns of the effects' bounds differ in length"};
    for (std::size_t i = 0; i < n; ++i) {
        const auto at = std::ranges::find(record.effects, effect[i], &EffectChoice::name);
        if (at == record.effects.end()) throw h5::Failure{"a bound belongs to no effect: " + effect[i]};
        if (!(below[i] >= 0) || !(above[i] >= 0)) throw h5::Failure{"a bound of " + effect[i] + " is negative"};
        at->bounds.push_back({of[i], below[i], above[i], unit[i], source[i], elements[i]});
    }
}

void read_effects(hid_t file, RunRecord& record) {
    const h5::Handle group = h5::open_group(file, layout::effects);
    const auto name = h5::read_texts(group, "name"), reason = h5::read_texts(group, "reason"),
               influence = h5::read_texts(group, "influence");
    const auto cost = h5::read_vector<double>(group, "cost", H5T_NATIVE_DOUBLE);
    const auto on = h5::read_vector<int>(group, "on", H5T_NATIVE_INT),
               forced = h5::read_vector<int>(group, "forced", H5T_NATIVE_INT);
    const std::size_t n = name.size();
    if (reason.size() != n || influence.size() != n || cost.size() != n || on.size() != n || forced.size() != n)
        throw h5::Failure{"the columns of effects differ in length"};
    for (std::size_t i = 0; i < n; ++i)
        record.effects.push_back({name[i], on[i] != 0, forced[i] != 0, reason[i], influence[i], cost[i], {}});
    read_bounds(group, record);
}

void read_validity_checks(hid_t file, RunRecord& record) {
    if (!h5::has(file, layout::validity_checks)) return;  // records had none at first
    const h5::Handle group = h5::open_group(file, layout::validity_checks);
    const auto name = h5::read_texts(group, "name"), unit = h5::read_texts(group, "unit");
    const auto column = [&](const char* which) { return h5::read_vector<double>(group, which, H5T_NATIVE_DOUBLE); };
    const auto value = column("value"), limit = column("limit"), time = column("time"), x = column("x"),
               y = column("y"), z = column("z");
    const std::size_t n = name.size();
    for (const std::size_t size : {unit.size(), value.size(), limit.size(), time.size(), x.size(), y.size(), z.size()})
        if (size != n) throw h5::Failure{"the columns of certificate differ in length"};
    for (std::size_t i = 0; i < n; ++i)
        record.validity_checks.push_back({name[i], unit[i], value[i], limit[i], time[i], {x[i], y[i], z[i]}});
}

void read_resolution(hid_t file, RunRecord& record) {
    if (!h5::has(file, layout::resolution)) return;  // records had none at first
    const h5::Handle group = h5::open_group(file, layout::resolution);
    const auto size = h5::read_vector<double>(group, "size", H5T_NATIVE_DOUBLE);
    const auto dims = h5::dimensions(group, "box");
    if (dims.size() != 3 || dims[0] != size.size() || dims[1] != 2 || dims[2] != 3)
        throw h5::Failure{"the boxes of resolution are not two corners for each size"};
    std::vector<double> corners(6 * size.size());
    h5::read_array(group, "box", H5T_NATIVE_DOUBLE, corners.data(), corners.size());
    for (std::size_t i = 0; i < size.size(); ++i)
        record.resolution.push_back({size[i], {Vec3(&corners[6 * i]), Vec3(&corners[6 * i + 3])}});
}

RunRecord read_contents(hid_t file) {
    RunRecord record;
    record.state = h5::read_text_attribute(file, "state");
    record.reason = h5::read_text_attribute(file, "reason");
    const auto scene_text = h5::read_texts(file, layout::scene_text);
    if (!scene_text.empty()) record.scene_text = scene_text[0];
    const h5::Handle attributes = h5::open_group(file, layout::attributes),
                     numbers = h5::open_group(file, layout::numbers);
    for (const std::string& name : h5::attribute_names(attributes))
        record.attributes[name] = h5::read_text_attribute(attributes, name.c_str());
    for (const std::string& name : h5::attribute_names(numbers)) record.numbers[name] = number(numbers, name.c_str());
    read_tables(file, record);
    read_raster(file, record);
    read_hull(file, record);
    read_bodies(file, record);
    read_cost(file, record);
    read_effects(file, record);
    read_validity_checks(file, record);
    read_resolution(file, record);
    return record;
}

/// Throws InputError.
RunRecord read_here(const fs::path& file) {
    const h5::Silence silence;
    const h5::Handle h(H5Fopen(file.c_str(), H5F_ACC_RDONLY, H5P_DEFAULT), H5Fclose);
    if (!h.open())
        throw InputError(file.string() +
                         ": cut off or damaged: it begins like HDF5 but cannot be opened; copy or run it again");
    try {
        if (!h5::has_attribute(h, layout::kind_attribute) ||
            h5::read_text_attribute(h, layout::kind_attribute) != layout::kind)
            throw InputError(file.string() + ": an HDF5 file, but not a run record of twinwake");
        const double version = number(h, layout::version_attribute);
        if (!(version >= 1))
            throw InputError(
                fmt::format("{}: damaged: it says format {}, and the first was 1", file.string(), version));
        if (version > RunRecord::format_version)
            throw InputError(
                fmt::format("{}: run record of format {}; this twinwake reads up to format {}: use a newer twinwake",
                            file.string(), version, RunRecord::format_version));
        RunRecord record = read_contents(h);
        check_values(file.string(), record);
        return record;
    } catch (const h5::Failure& f) {
        throw InputError(file.string() + ": cut off or damaged: " + f.what);
    } catch (const std::bad_alloc&) {
        throw InputError(file.string() + ": damaged: an array in it claims more bytes than the memory holds");
    } catch (const std::length_error&) {
        throw InputError(file.string() + ": damaged: the size that an array in it claims is impossible");
    }
}

/// The same in a child, as HDF5 follows what stands in a file. Throws what it throws, and what became of the child.
void try_to_read(const fs::path& file) {
    std::string words;
    try {
        words = answer_of_trial([&]() -> std::string {
            try {
                read_here(file);
            } catch (const InputError& e) { return e.what(); }
            return {};
        });
    } catch (const InputError& e) { words = file.string() + ": damaged: " + e.what(); }
    if (!words.empty()) throw InputError(words);
}

}  // namespace

RunRecord read_record(const fs::path& file) {
    const Bytes bytes = check_bytes(file);
    if (bytes != Bytes::whole) try_to_read(file);
    if (bytes == Bytes::changed) refuse_changed(file);  // though no dataset shows it
    return read_here(file);
}

}  // namespace tw
