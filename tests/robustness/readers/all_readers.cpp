#include "tests/robustness/readers/all_readers.h"

#include <algorithm>
#include <cstdlib>
#include <fstream>

#include "app/campaign/budget.h"
#include "app/cluster/site.h"
#include "app/cluster/slurm.h"
#include "app/pace/machine_pace.h"
#include "app/progress/member_state.h"
#include "app/progress/run_told.h"
#include "app/study/study.h"
#include "base/atomic_file.h"
#include "base/errors.h"
#include "compare/reports/two_reports.h"
#include "compare/uncertainty/refinement_table.h"
#include "foam_cases/cloud/cloud_case.h"
#include "foam_cases/read/field_file.h"
#include "foam_cases/read/hull_patch.h"
#include "foam_cases/read/number_rows.h"
#include "foam_cases/read/solver_log.h"
#include "foam_cases/read/step_loads.h"
#include "import/readers.h"
#include "meshes/read/gzip.h"
#include "meshes/read/solids_of_file.h"
#include "meshes/surface.h"
#include "record/checksum_line.h"
#include "record/run_record.h"
#include "record/snapshot.h"
#include "record/this_machine.h"
#include "scene/scene.h"
#include "sph_solver/state/checkpoint.h"
#include "spray/air/foam_air.h"
#include "spray/extract/read_frames.h"
#include "spray/read_droplets.h"
#include "spray/read_study.h"
#include "structure/read_mesh.h"
#include "test_paths.h"
#include "tests/robustness/readers/edited_hdf5.h"

namespace tw::readers {
namespace fs = std::filesystem;

fs::path Input::file(const std::string& name, std::string_view content) const {
    const fs::path path = folder_ / name;
    fs::create_directories(path.parent_path());
    std::ofstream(path, std::ios::binary).write(content.data(), static_cast<std::streamsize>(content.size()));
    return path;
}

namespace {

/// The input as several files: behind each line "== NAME" the content of that file, if it is one of `names`. The others
/// are empty. Returns their folder, which holds nothing else.
fs::path folder_of_files(const Input& in, const std::vector<std::string>& names) {
    static constexpr std::string_view mark = "== ";
    const fs::path folder = in.file("case/none", "").parent_path();
    for (const std::string& name : names) in.file("case/" + name, "");
    std::string_view rest = in.bytes();
    for (std::size_t at = rest.find(mark); at != std::string_view::npos; at = rest.find(mark)) {
        rest.remove_prefix(at + mark.size());
        const std::size_t line = std::min(rest.find('\n'), rest.size());
        const std::string name(rest.substr(0, line));
        rest.remove_prefix(std::min(line + 1, rest.size()));
        if (std::ranges::find(names, name) != names.end())
            in.file("case/" + name, rest.substr(0, std::min(rest.find(mark), rest.size())));
    }
    return folder;
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

ColumnSource column(const std::string& table, const std::string& name, int number) {
    ColumnSource c;
    c.table = table, c.name = name, c.number = number, c.place = "mapping.toml:8:6: [" + table + "] " + name;
    c.si_unit = table == "forces" ? "N" : table == "height" ? "m" : "s";
    return c;
}

void read_forces_csv(const Input& in) {
    Mapping mapping;
    mapping.kind = "csv";
    mapping.source = in.file("forces.csv");
    mapping.time = column("", "time", 1);
    mapping.columns = {column("forces", "fx", 2), column("height", "H1", 3)};
    RunRecord record;
    read_csv(mapping, record);
}

void read_water_csv(const Input& in) {
    WaterSource water;
    water.source = in.file("water.csv");
    const auto metres = [](int number) { return column("height", "water", number); };
    water.time = column("", "time", 1), water.x = metres(2), water.y = metres(3), water.z = metres(4);
    water.volume = metres(5), water.volume.si_unit = "m3";
    RunRecord record;
    record.raster = {.origin = Vec3::Zero(), .voxel = 0.25, .count = {4, 4, 2}};
    read_water(water, record);
    water.cell = water.volume;
    read_water(water, record);
}

void read_foreign_case(const Input& in) {
    for (const char* file : {"force.dat", "moment.dat"})
        in.file(std::string("foreign/postProcessing/forces/0/") + file);
    Mapping mapping;
    mapping.kind = "openfoam";
    mapping.source = in.file("foreign/none").parent_path();
    mapping.place["source"] = "mapping.toml:3:1: source";
    RunRecord record;
    read_openfoam(mapping, record);
}

/// A mesh and its fields: as air, whose velocity is asked for inside and outside, and as cells that hold water.
void read_foam_case(const Input& in) {
    const fs::path folder = folder_of_files(
        in, {"system/controlDict", "constant/polyMesh/points", "constant/polyMesh/faces", "constant/polyMesh/owner",
             "constant/polyMesh/neighbour", "constant/polyMesh/boundary", "0/C", "0/V", "1/alpha.water", "1/U"});
    const spray::FoamAir air(folder, 1, {});
    for (const double x : {-1.0, 0.3, 1.5, 4.0}) {
        spray::AirState state;
        air.at({x, 0.4, 0.6}, state);
    }
    double left_out = 0;
    spray::read_cells({1, folder / "1"}, 0.5, left_out);
}

/// The seed of a reader of HDF5 with other values, and the checksum line that makes it one of our own again.
fs::path edited_seed(const Input& in, const std::string& reader) {
    const fs::path seed = fs::path(TWINWAKE_SOURCE) / "tests/robustness/readers/corpus" / reader / "seed";
    const fs::path file = in.file("edited.h5", read_text(seed));
    edit_hdf5(file, in.bytes());
    return in.file("signed.h5", with_checksum_line(read_text(file)));
}

void read_parcels(const Input& in) {
    const std::string cloud = "0.5/lagrangian/kinematicCloud/";
    read_cloud(folder_of_files(in, {cloud + "positions", cloud + "U", cloud + "age", cloud + "origId"}));
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

/// The folder of results in which the input is that file.
fs::path results_with(const Input& in, const std::string& name) {
    const fs::path out = in.file("results/none", "").parent_path();
    in.file("results/" + name);
    return out;
}

/// As the file of this user and of this machine; learned from, and so written, as well.
void read_pace(const Input& in) {
    const fs::path cache = in.file("cache/none", "").parent_path();
    std::string text(in.bytes());
    static constexpr std::string_view machine = "MACHINE";
    if (const std::size_t at = text.find(machine); at != text.npos) text.replace(at, machine.size(), cpu_model());
    in.file("cache/twinwake/pace.json", text);
    const char* before = std::getenv("XDG_CACHE_HOME");
    const std::string old = before ? before : "";
    setenv("XDG_CACHE_HOME", cache.c_str(), 1);
    app::machine_pace("sph");
    app::learn_pace("sph", 20, 30, true);
    const double learned = app::machine_pace("sph");
    before ? setenv("XDG_CACHE_HOME", old.c_str(), 1) : unsetenv("XDG_CACHE_HOME");
    if (!(learned > 0 && learned <= 100)) throw std::logic_error("a pace that no machine has");
}

void read_member(const Input& in) {
    const app::MemberState s = app::read_member_state(in.file("0.json"));
    if (!(s.share >= 0 && s.share <= 1 && s.left >= 0)) throw std::logic_error("a share that nothing can be done to");
}

void read_told(const Input& in) {
    const app::RunTold t = app::read_run_told(in.file("progress.json").parent_path());
    if (!(t.share() >= 0 && t.share() <= 1 && t.left >= 0))
        throw std::logic_error("a share that nothing can be done to");
}

/// Drawings where they can be read: the library for them is built where Open CASCADE is found.
std::vector<Reader> with_drawings(std::vector<Reader> all) {
    if (fs::exists(fs::path(TWINWAKE_PROGRAM).parent_path() / "meshes/libtwinwake_drawings.so")) {
        all.push_back({"step", [](const Input& in) { read_surface(in.file("hull.step")); }});
        all.push_back({"step_names", [](const Input& in) { solids_of_file(in.file("hull.step")); }});
        all.push_back({"iges", [](const Input& in) { read_surface(in.file("hull.igs")); }});
    }
    return all;
}

}  // namespace

const std::vector<Reader>& all_readers() {
    static const std::vector<Reader> all = with_drawings({
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
        {"forces_csv", read_forces_csv},
        {"water_csv", read_water_csv},
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
        {"foam_import", read_foreign_case},
        {"foam_case", read_foam_case},
        {"foam_cloud", read_parcels},
        {"record", [](const Input& in) { read_record(in.file("record.h5")); }},
        {"checkpoint", [](const Input& in) { read_checkpoint(in.file("checkpoint.h5"), "a scene"); }},
        {"record_values", [](const Input& in) { read_record(edited_seed(in, "record")); }},
        {"checkpoint_values", [](const Input& in) { read_checkpoint(edited_seed(in, "checkpoint"), "a scene"); }},
        {"snapshot_values",
         [](const Input& in) {
             spray::read_particles({0, edited_seed(in, "snapshot")});
         }},
        {"snapshot",
         [](const Input& in) {
             spray::read_particles({0, in.file("particles_0.hdf")});
         }},
        {"series", [](const Input& in) { read_series(in.file("particles.hdf.series")); }},
        {"study", [](const Input& in) { app::read_study(results_with(in, "study/study.json")); }},
        {"member", read_member},
        {"run_told", read_told},
        {"runs_list", [](const Input& in) { app::read_runs_list(in.file("runs.json").parent_path()); }},
        {"jobs", [](const Input& in) { app::read_jobs(results_with(in, "study/jobs.json")); }},
        {"sizes", [](const Input& in) { app::remembered_sizes(results_with(in, "sizes.json"), 600); }},
        {"pace", read_pace},
        {"report", [](const Input& in) { read_report(in.file("report.json")); }},
        {"site", [](const Input& in) { app::completed({}, in.file("site.toml")); }},
    });
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
