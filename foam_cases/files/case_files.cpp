#include "foam_cases/files/case_files.h"

namespace tw {

std::vector<CaseFile> case_files(const CasePlan& plan, int ranks) {
    std::vector<CaseFile> files{
        {"system/blockMeshDict", block_mesh_dict(plan)},
        {"system/controlDict", control_dict(plan)},
        {"system/decomposeParDict", decompose_par_dict(plan, ranks)},
        {"system/fvSchemes", fv_schemes(plan)},
        {"system/fvSolution", fv_solution(plan)},
        {"system/setFieldsDict", set_fields_dict(plan)},
        {"constant/g", gravity_file(plan)},
        {"constant/" + plan.flavour.turbulence_file(), turbulence_file(plan)},
        {"0.orig/alpha.water", alpha_water(plan)},
        {"0.orig/U", velocity_field(plan)},
        {"0.orig/p_rgh", p_rgh(plan)},
        {"Allrun", allrun_script(plan, ranks), true},
        {"README", case_readme(plan)},
    };
    if (plan.snappy) {
        files.push_back({"system/snappyHexMeshDict", snappy_hex_mesh_dict(plan)});
        if (!plan.solids.empty())
            files.push_back(
                {"system/" + plan.flavour.surface_features_program() + "Dict", surface_features_dict(plan)});
    }
    if (plan.extrude) {
        files.push_back({"system/extrudeMeshDict", extrude_mesh_dict(plan)});
        files.push_back({"system/createPatchDict", create_patch_dict(plan)});
    }
    for (CaseFile& f : phase_files(plan)) files.push_back(std::move(f));
    for (CaseFile& f : mesh_motion_files(plan)) files.push_back(std::move(f));
    for (CaseFile& f : tank_motion_files(plan)) files.push_back(std::move(f));
    for (CaseFile& f : forcing_zones_files(plan)) files.push_back(std::move(f));
    for (CaseFile& f : inlet_wave_files(plan)) files.push_back(std::move(f));
    for (CaseFile& f : turbulence_fields(plan)) files.push_back(std::move(f));
    return files;
}

}  // namespace tw
