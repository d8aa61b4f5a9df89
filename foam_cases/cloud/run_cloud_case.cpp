#include "foam_cases/cloud/cloud_case.h"
#include "foam_cases/run/case_programs.h"

namespace tw {

std::optional<OpenFoam> openfoam_with_cloud_solver() {
    std::optional<OpenFoam> found;
    for (const OpenFoam& one : find_openfoam())
        if (std::filesystem::exists(one.bin / cloud_solver) && (!found || (one.sound && !found->sound))) found = one;
    return found;
}

void run_cloud_case(const OpenFoam& openfoam, const std::filesystem::path& folder) {
    const CasePrograms programs(openfoam, folder);
    programs.run("blockMesh", {}, {});
    programs.run(cloud_solver, {}, {});
}

}  // namespace tw
