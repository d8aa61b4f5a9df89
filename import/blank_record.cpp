#include <fmt/format.h>

#include <algorithm>
#include <array>

#include "base/errors.h"
#include "import/readers.h"
#include "record/code_version.h"
#include "record/this_machine.h"
#include "record/water_in_box.h"
#include "scene/new_record.h"

namespace tw {
namespace {

namespace fs = std::filesystem;

/// What an import takes over of a scene's record: the question that was asked. Machine, method, spacing and the rest
/// belong to the run that answered it.
constexpr std::array kept_attributes{"title",       "scene_file",       "scene_hash", "hull_hash",
                                     "hull_source", "moment_reference", "motion"};
constexpr std::array kept_numbers{
    "density",           "kinematic_viscosity", "gravity", "depth", "speed", "duration", "mean_from",
    "sampling_interval", "dimensions",          "length",  "beam",  "trim",  "heel",     "draft",
    "displaced_volume"};

bool is_there(const fs::path& path) {
    std::error_code none;
    return fs::exists(path, none);
}

struct KnownScene {
    RunRecord record;
    std::map<std::string, std::set<std::string>> probes;  ///< of tables pressure, height and volume
};

/// The scene from its file, or from a record of a run of it: a run of other size or speed than the file says
/// (--near-hull, --scale, --speed) is another scene, and its record knows it.
KnownScene known_scene(const Mapping& m) {
    if (!is_there(m.scene))
        throw InputError(
            fmt::format("{}: there is no file {}; expected the scene file of the runs to compare with, or "
                        "the record.h5 of one of them",
                        m.place.at("scene"), m.scene.string()));
    KnownScene known;
    if (m.scene.extension() == ".h5") {
        known.record = read_record(m.scene);
        known.record.hull = {};  // as that method's mesh has it, perhaps one half
        for (const char* table : {"pressure", "height", volume_table})
            if (const auto found = known.record.tables.find(table); found != known.record.tables.end())
                for (const Column& c : found->second.columns) known.probes[table].insert(c.name);
        return known;
    }
    const Scene scene = read_scene(m.scene);
    known.record = new_record(scene, "import");
    for (const PressureProbe& p : scene.sampling.pressure) known.probes["pressure"].insert(p.name);
    for (const HeightProbe& p : scene.sampling.height) known.probes["height"].insert(p.name);
    for (const WaterBox& v : scene.sampling.volumes) known.probes[volume_table].insert(v.name);
    return known;
}

void check_probes(const Mapping& m, const KnownScene& known) {
    for (const ColumnSource& c : m.columns) {
        const bool box = c.table == volume_table;
        if (!box && c.table != "pressure" && c.table != "height") continue;
        const auto found = known.probes.find(c.table);
        if (found != known.probes.end() && found->second.contains(c.name)) continue;
        std::string names;
        if (found != known.probes.end())
            for (const std::string& name : found->second) names += (names.empty() ? "" : ", ") + name;
        const std::string scene = m.scene.filename().string();
        const std::string kind = box ? "box" : c.table + " probe",
                          wanted = box ? "[[volume]] with" : fmt::format("[[probe]] with {} = ... and", c.table);
        throw InputError(names.empty() ? fmt::format("{}: {} has no {}; expected a {} name = \"{}\" there", c.place,
                                                     scene, kind, wanted, c.name)
                                       : fmt::format("{}: {} has no {} of this name; expected one of: {}", c.place,
                                                     scene, kind, names));
    }
}

/// Name of a file or folder without the folders it lies in.
std::string last_name(const fs::path& path) {
    std::error_code none;
    fs::path full = fs::weakly_canonical(path, none);
    if (none) full = path;
    return full.filename().empty() ? full.parent_path().filename().string() : full.filename().string();
}

}  // namespace

RunRecord blank_record(const Mapping& m) {
    if (!is_there(m.source))
        throw InputError(fmt::format("{}: there is no {} {}; expected {}, relative to the mapping file",
                                     m.place.at("source"), m.kind == "openfoam" ? "folder" : "file", m.source.string(),
                                     m.kind == "openfoam" ? "the folder of the case" : "the file to read"));
    KnownScene known = known_scene(m);
    check_probes(m, known);
    if (const bool half_scene = known.record.attributes["symmetry_factor"] == "2";
        m.water && half_scene != m.half_model)
        throw InputError(
            fmt::format("{}: the scene is solved as {} and half_model = {}; expected water of the same part",
                        m.place.at("water"), half_scene ? "one half" : "a whole", m.half_model));
    RunRecord record;
    for (const char* name : kept_attributes)
        if (const auto found = known.record.attributes.find(name); found != known.record.attributes.end())
            record.attributes.insert(*found);
    for (const auto& [name, value] : known.record.numbers)
        if (std::ranges::find(kept_numbers, name) != kept_numbers.end() || name.starts_with("domain_") ||
            name.starts_with("cut_"))
            record.numbers[name] = value;
    record.scene_text = known.record.scene_text;
    record.raster = known.record.raster;  // where voxels are is the scene's; which are wet says read_water
    record.hull = std::move(known.record.hull);
    record.attributes["code_version"] = TWINWAKE_CODE_VERSION;
    record.attributes["method"] = m.name;
    record.attributes["imported"] = utc_now();
    record.attributes["imported_from"] = last_name(m.source);
    record.attributes["import_kind"] = m.kind;
    record.attributes["symmetry_factor"] = m.half_model ? "2" : "1";
    return record;
}

}  // namespace tw
