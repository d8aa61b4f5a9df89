#include "foam_cases/mesh/make_mesh.h"

#include <cmath>
#include <numeric>

#include "base/atomic_file.h"
#include "base/errors.h"
#include "foam_cases/files/case_files.h"
#include "foam_cases/mesh/edge_cells.h"
#include "foam_cases/mesh/wave_fields.h"
#include "foam_cases/read/field_file.h"
#include "foam_cases/read/number_rows.h"
#include "foam_cases/read/time_folders.h"
#include "scene/box/tank_wave.h"
#include "scene/mesh/mesh_cells.h"

namespace tw {
namespace fs = std::filesystem;

namespace {

/// Whatever an earlier, unfinished try left: mesh, times, decomposition, results.
void clear_results(const fs::path& folder) {
    std::vector<fs::path> old{folder / "constant/polyMesh", folder / "postProcessing", folder / "0",
                              folder / "log.solver"};
    for (const auto& e : fs::directory_iterator(folder)) {
        const std::string name = e.path().filename().string();
        if (e.is_directory() && (time_of(name) || name.rfind("processor", 0) == 0)) old.push_back(e.path());
    }
    for (const fs::path& p : old) fs::remove_all(p);
}

/// What checkMesh says: the number of cells and the lines it marks with ***.
void read_check(const std::string& text, MeshOutcome& out) {
    for (std::size_t at = 0; at < text.size();) {
        const std::size_t end = std::min(text.find('\n', at), text.size());
        const std::string line = text.substr(at, end - at);
        if (line.rfind("    cells:", 0) == 0) out.cells = numbers_in(line).empty() ? 0 : numbers_in(line).front();
        if (line.find("***") != std::string::npos) out.check += line.substr(line.find_first_not_of(" *")) + "; ";
        at = end + 1;
    }
    out.clean = text.find("Mesh OK") != std::string::npos;
}

/// A whole cell along shedding edges: its size along x and its largest size [m], its volume [m3].
struct EdgeCell {
    double along_x, size, whole;
};
EdgeCell edge_cell(const CasePlan& plan) {
    const double parts = std::pow(2.0, plan.wet_level + plan.shedding.halvings);
    Vec3 cell;
    for (std::size_t a = 0; a < 3; ++a) {
        const AxisCells& axis = plan.axes[a];
        double length = axis.planes.back() - axis.planes.front();
        int cells = std::accumulate(axis.cells.begin(), axis.cells.end(), 0);
        for (const ForcingZone& zone : grown_zones(*plan.scene))
            if (zone.axis == static_cast<int>(a)) {
                length -= std::abs(zone.end - zone.begin);
                cells -= zone.high ? axis.cells.back() : axis.cells.front();
            }
        cell[static_cast<Eigen::Index>(a)] = length / cells / parts;
    }
    return {cell.x(), cell.maxCoeff(), cell.prod()};
}

}  // namespace

MeshOutcome make_mesh(const CasePlan& plan, const CasePrograms& programs, const std::function<int(double)>& ranks_for,
                      const Watch& watch, const std::function<void(const std::string&)>& starting) {
    const fs::path& folder = programs.case_folder();
    MeshOutcome out;
    const auto step = [&](const std::string& program, const std::vector<std::string>& arguments,
                          const std::string& log_name = {}) {
        if (out.stopped) return;
        starting(program);
        const Ended ended = programs.run(program, arguments, watch, log_name);
        out.cpu += ended.cpu;
        out.peak_memory = std::max(out.peak_memory, ended.peak_memory);
        out.stopped = !ended.ok();
    };
    clear_results(folder);
    const auto cut_out = [&](double moved) {  // the solids out of a background mesh that is moved along x [m]
        CasePlan at = plan;
        for (double& x : at.axes[0].planes) x += moved;
        write_text_atomically(folder / "system/blockMeshDict", block_mesh_dict(at));
        fs::remove_all(folder / "constant/polyMesh");
        step("blockMesh", {});
        if (!plan.snappy) return;
        if (!plan.solids.empty()) step(plan.flavour.surface_features_program(), {});
        step("snappyHexMesh", {"-overwrite"});
    };
    const auto smallest = [&] {
        const EdgeCell cell = edge_cell(plan);
        fs::create_directories(folder / "0");
        if (fs::exists(folder / "0.orig/pointDisplacement"))  // openfoam.org's programs ask for it where the mesh moves
            fs::copy(folder / "0.orig/pointDisplacement", folder / "0/pointDisplacement");
        step(plan.flavour.post_process_program(), {"-func", "writeCellCentres", "-time", "0"}, "writeCellCentres");
        step(plan.flavour.post_process_program(), {"-func", "writeCellVolumes", "-time", "0"}, "writeCellVolumes");
        if (out.stopped) return 1.0;
        const FieldFile centres = read_field(folder / "0/C"),
                        volumes = read_field(folder / "0" / cell_volumes_in(folder / "0"));
        std::vector<Vec3> middles;
        std::vector<double> of;
        for (std::size_t i = 0; i < centres.cells(); ++i)
            middles.push_back(centres.vector(i)), of.push_back(volumes.scalar(i));
        fs::remove_all(folder / "0");
        return smallest_edge_cell(middles, of, plan.shedding.edges, cell.size, cell.whole);
    };
    cut_out(0);
    // A wedge of a cell at a transom's edge is worth several per cent of the force. Whether there is one hangs on where
    // the edge lies in its cells: of four places the best has had none (docs/decisions/028-shedding-edges.md).
    constexpr double wedge = 0.12;
    if (!plan.ribbon.empty()) {
        double best = smallest(), at_best = 0, at = 0;
        for (const double quarters : {1.0, 2.0, 3.0}) {
            if (best >= wedge || out.stopped) break;
            at = quarters / 4 * edge_cell(plan).along_x;
            cut_out(at);
            if (const double share = smallest(); share > best) best = share, at_best = at;
        }
        if (at != at_best) cut_out(at_best);
    }
    if (plan.extrude) {
        step("extrudeMesh", {});
        step("createPatch", {"-overwrite"});
    }
    step("checkMesh", {});
    if (out.stopped) return out;
    read_check(read_text(programs.log("checkMesh")), out);
    if (out.cells < 1) throw RunError("the mesh has no cells, see " + programs.log("checkMesh").string());
    step("renumberMesh", {"-overwrite"});
    fs::remove_all(folder / "0");
    fs::copy(folder / "0.orig", folder / "0", fs::copy_options::recursive);
    step("setFields", {});
    // Cell centres and volumes as fields: decomposePar then shares them out in the order of the processors' cells.
    step(plan.flavour.post_process_program(), {"-func", "writeCellCentres", "-time", "0"}, "writeCellCentres");
    step(plan.flavour.post_process_program(), {"-func", "writeCellVolumes", "-time", "0"}, "writeCellVolumes");
    for (const char* component : {"Cx", "Cy", "Cz"}) fs::remove(folder / "0" / component);
    if (begins_with_wave(*plan.scene) && !out.stopped) begin_with_wave(plan, folder / "0");
    out.ranks = ranks_for(out.cells);
    if (out.ranks > 1) {
        write_text_atomically(folder / "system/decomposeParDict", decompose_par_dict(plan, out.ranks));
        step("decomposePar", {});
    }
    return out;
}

}  // namespace tw
