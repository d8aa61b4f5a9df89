#pragma once
#include <vector>

#include "foam_cases/case_plan.h"
#include "foam_cases/read/hull_patch.h"
#include "foam_cases/read/solver_log.h"
#include "foam_cases/read/time_folders.h"
#include "record/run_record.h"

namespace tw {

/// The faces of each of the plan's solids, as the solver wrote them at a write time; nothing where it was stopped before.
using Walls = std::vector<std::optional<HullPatch>>;
Walls read_walls(const CasePlan& plan, const std::filesystem::path& case_folder, const std::string& time_name);
/// The water's load on those that the table of forces counts; nothing where one of them is missing, or there is none. A
/// solid that the mesh has no face of, inside another or smaller than a cell, bears none.
std::optional<WaterLoad> read_load(const CasePlan& plan, const std::filesystem::path& case_folder, const Walls& walls);

/// The column [-]: share of the water that is faster than `water_speed_limit` of the plan.
inline constexpr const char* fast_water = "fast_water";

/// What a step's flow makes and swallows of the domain's water and air while the stream passes the hull once,
///
///   sum |div u| V / sum V * L / U   [%],
///
/// which says whether pressure is solved well enough for the hull's load (docs/decisions/015-interfoam-settings.md).
RecordedCheck continuity_of_held_hull(const Scene& scene, const SolverLog::Step& step);

/// Turns what the solver leaves at its write times into rows of the run record: water poured into the raster, mass,
/// energies, the water's load on the hull or the solids of a tank. Half-model results are doubled here, once.
class FrameReader {
public:
    /// Reads cell centres and volumes from the 0 folders; throws RunError when they are not there.
    FrameReader(const CasePlan& plan, const std::filesystem::path& case_folder);

    std::size_t cells() const;
    /// Adds the write time to `record` (tables forces and samples, raster frames, hull pictures). The folder must be
    /// whole.
    void read(const TimeFolders::Moment& moment, const SolverLog& log, RunRecord& record);
    /// Puts the hull's pressure at this write time into `record` as its picture, where its surface is there.
    void show_hull(const TimeFolders::Moment& moment, RunRecord& record) const;

private:
    struct Part {                     ///< one root: the case or a processor's share
        std::vector<Vec3> centres;    ///< of the cells [m]
        std::vector<double> volumes;  ///< of the cells [m3]
    };
    bool frame_is_due(double time, const SolverLog& log, const RunRecord& record) const;
    void read_water(const TimeFolders::Moment& moment, const SolverLog& log, RunRecord& record) const;
    /// `in_boxes`: water in each box of the scene, as solved [m3].
    void keep_volumes(double time, const std::vector<double>& in_boxes, RunRecord& record) const;
    void keep_load(double time, const WaterLoad& load, RunRecord& record) const;
    void keep_hull(double time, const HullPatch& patch, const WaterLoad& load, RunRecord& record) const;
    void note_mesh_error(double time, const HullPatch& patch, RunRecord& record) const;
    void picture_hull(const HullPatch& patch, RunRecord& record) const;
    void keep_suction(const Walls& walls, RunRecord& record) const;  ///< of every solid

    const CasePlan& plan_;
    std::filesystem::path case_;
    TimeFolders folders_;
    static Part read_part(const std::filesystem::path& folder);
    std::vector<Part> parts_;
};

/// Tables that hold every step: forces_total (water and air together), pressure and height of the probes. They are made
/// anew from the files each time, and fx_total, fz_total and the air's part are added to the table forces.
void read_step_tables(const CasePlan& plan, const std::filesystem::path& case_folder, const SolverLog& log,
                      RunRecord& record);

}  // namespace tw
