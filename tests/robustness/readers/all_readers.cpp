#include "tests/robustness/readers/all_readers.h"

#include <fstream>

#include "base/errors.h"
#include "compare/uncertainty/read_table.h"
#include "foam_cases/read/field_file.h"
#include "foam_cases/read/hull_patch.h"
#include "foam_cases/read/number_rows.h"
#include "foam_cases/read/step_loads.h"
#include "foam_cases/run/solver_log.h"
#include "import/readers.h"
#include "meshes/read/gzip.h"
#include "meshes/surface.h"
#include "record/checksum_line.h"
#include "record/run_record.h"
#include "record/snapshot.h"
#include "scene/scene.h"
#include "sph_solver/state/checkpoint.h"
#include "spray/extract/read_frames.h"
#include "spray/read_droplets.h"
#include "spray/read_study.h"
#include "structure/read_mesh.h"

namespace tw::readers {
namespace fs = std::filesystem;

fs::path Input::file(const std::string& name, std::string_view content) const {
    const fs::path path = folder_ / name;
    fs::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary).write(content.data(), static_cast<std::streamsize>(content.size()));
    return path;
}

namespace {

/// As it is, and with the checksum line that our own files end in: what lies behind the check is to hold as well.
template <class Read>
void read_signed(const Input& in, const std::string& name, Read read) {
    try {
        read(in.file(name));
    } catch (const InputError&) { read(in.file(name, with_checksum_line(std::string(in.bytes())))); }
}

void read_log(const Input& in) {
    SolverLog log;
    const std::string_view text = in.bytes();
    log.feed(text.substr(0, text.size() / 2));  // a log is read in pieces, as it grows
    log.feed(text.substr(text.size() / 2));
    log.at(0.1);
    log.tail(5);
}

/// The table of forces of openfoam.com and the one of openfoam.org, and any other table.
void read_loads_of_all(const Input& in) {
    for (const char* file : {"com/0/force.dat", "com/0/moment.dat", "org/0/forces.dat"}) in.file(file);
    read_loads(in.file("com/0/p").parent_path().parent_path());
    read_loads(in.file("org/0/p").parent_path().parent_path());
    joined_rows(in.file("org/0/p").parent_path().parent_path(), "p");
}

void read_dualsphysics_forces(const Input& in) {
    Mapping mapping;
    mapping.kind = "dualsphysics";
    mapping.source = in.file("forces.csv");
    mapping.place["source"] = "mapping.toml:3:1: source";
    RunRecord record;
    read_dualsphysics(mapping, record);
}

void read_columns(const Input& in) {
    const CsvColumns csv(std::string(in.bytes()), "table.csv");
    for (std::size_t k = 0; k < csv.headers().size(); ++k) csv.texts(csv.headers()[k]), csv.values(k);
}

void read_patch(const Input& in) {
    for (const char* name : {"hull.vtp", "hull.vtk"}) {
        const fs::path file = in.file(name);
        if (const auto patch = read_hull_patch(file.parent_path())) water_load(*patch, 1000, 1.2, Vec3::Zero());
        fs::remove(file);
    }
}

}  // namespace

const std::vector<Reader>& all_readers() {
    static const std::vector<Reader> all{
        {"stl", [](const Input& in) { read_surface(in.file("hull.stl")); }},
        {"obj", [](const Input& in) { read_surface(in.file("hull.obj")); }},
        {"ply", [](const Input& in) { read_surface(in.file("hull.ply")); }},
        {"vtp", [](const Input& in) { read_surface(in.file("hull.vtp")); }},
        {"gzip", [](const Input& in) { unpacked("hull.stl.gz", std::string(in.bytes()), 1 << 20); }},
        {"inp", [](const Input& in) { structure::read_mesh(in.file("plate.inp")); }},
        {"msh", [](const Input& in) { structure::read_mesh(in.file("plate.msh")); }},
        {"vtu", [](const Input& in) { structure::read_mesh(in.file("plate.vtu")); }},
        {"scene", [](const Input& in) { read_scene(in.file("scene.toml")); }},
        {"mapping", [](const Input& in) { read_mapping(in.file("mapping.toml")); }},
        {"csv", read_columns},
        {"dualsphysics", read_dualsphysics_forces},
        {"refinement_table", [](const Input& in) { read_refinement_table(in.file("table.csv")); }},
        {"droplets", [](const Input& in) { spray::read_droplets(in.file("droplets.csv")); }},
        {"spray_study",
         [](const Input& in) {
             in.file("droplets.csv",
                     "x [m],y [m],z [m],u [m/s],v [m/s],w [m/s],diameter [m],time [s]\n0,0,1,1,2,3,0.001,0\n");
             spray::read_spray_study(in.file("study.toml"));
         }},
        {"foam_log", read_log},
        {"foam_forces", read_loads_of_all},
        {"foam_field", [](const Input& in) { read_field(in.file("U")); }},
        {"foam_surface", read_patch},
        {"record", [](const Input& in) { read_signed(in, "record.h5", read_record); }},
        {"checkpoint",
         [](const Input& in) {
             read_signed(in, "checkpoint.h5", [](const fs::path& file) { read_checkpoint(file, "a scene"); });
         }},
        {"snapshot",
         [](const Input& in) {
             spray::read_particles({0, in.file("particles_0.hdf")});
         }},
        {"series", [](const Input& in) { read_series(in.file("particles.hdf.series")); }},
    };
    return all;
}

std::string feed(const Reader& reader, const Input& input) {
    try {
        reader.read(input);
        return "";
    } catch (const InputError& e) { return e.what(); } catch (const RunError& e) {
        return e.what();
    }
}

}  // namespace tw::readers
