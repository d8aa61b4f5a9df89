#pragma once
#include <optional>
#include <string>
#include <vector>

#include "foam_cases/case_plan.h"

namespace tw {

struct CaseFile {
    std::string path;  ///< inside the case folder
    std::string text;
    bool executable = false;
};

// One function per OpenFOAM file, each in a source file of the same subject.
std::string block_mesh_dict(const CasePlan& plan);
std::string slab_side(const Patch& patch);  ///< name of a side of the slab that a flat mesh is drawn out of
std::string extrude_mesh_dict(const CasePlan& plan);
/// Adds a field's entries for what is left of the slab's sides.
void add_sides_of_slab(const CasePlan& plan, Dictionary& boundary);
std::string create_patch_dict(const CasePlan& plan);
std::string surface_features_dict(const CasePlan& plan);
std::string snappy_hex_mesh_dict(const CasePlan& plan);
std::string set_fields_dict(const CasePlan& plan);
std::string decompose_par_dict(const CasePlan& plan, int ranks);
std::string control_dict(const CasePlan& plan);
std::string fv_schemes(const CasePlan& plan);
std::string fv_solution(const CasePlan& plan);

std::string gravity_file(const CasePlan& plan);
std::string turbulence_file(const CasePlan& plan);
std::vector<CaseFile> phase_files(const CasePlan& plan);  ///< transportProperties, or a file per phase

/// `inside`: of the cells, where it is not what setFields or the stream makes it.
std::string alpha_water(const CasePlan& plan, const std::optional<Value>& inside = {});
std::string velocity_field(const CasePlan& plan, const std::optional<Value>& inside = {});
std::string p_rgh(const CasePlan& plan);
/// constant/dynamicMeshDict, 0.orig/pointDisplacement and the table of a prescribed motion; none where nothing moves.
std::vector<CaseFile> mesh_motion_files(const CasePlan& plan);
/// The rule of foam_cases/held_body: a body is at rest before `release` [s] and then moves by Newmark's.
Dictionary held_newmark(double release, double gamma);
/// constant/fvOptions and its table; none where the tank rests.
std::vector<CaseFile> tank_motion_files(const CasePlan& plan);
/// constant/fvOptions or fvModels with the source of foam_cases/forcing_zones alone.
std::string forcing_zones_file(const Flavour& flavour, const ZoneSource& source);
void add_zones(const ZoneSource& source, Dictionary& sources);    ///< to the entries of that file
std::vector<CaseFile> forcing_zones_files(const CasePlan& plan);  ///< none without zones
/// constant/inletWave; none where no wave enters with the stream.
std::vector<CaseFile> inlet_wave_files(const CasePlan& plan);
/// Of the inlet's fraction or velocity: `of_regular` where a regular wave enters, that of sums where one does.
std::string inlet_wave_type(const CasePlan& plan, const std::string& of_regular);
std::vector<CaseFile> turbulence_fields(const CasePlan& plan);    ///< k, omega, nut; none in laminar flow

std::string allrun_script(const CasePlan& plan, int ranks);
std::string case_readme(const CasePlan& plan);

/// The whole case but for the surfaces of constant/triSurface.
std::vector<CaseFile> case_files(const CasePlan& plan, int ranks);

}  // namespace tw
