#include "foam_cases/cloud/cloud_case.h"
#include "foam_cases/run/case_programs.h"
#include "foam_cases/run/environment.h"

namespace tw {

std::optional<OpenFoam> openfoam_with_cloud_solver() {
    std::optional<OpenFoam> found;
    for (const OpenFoam& one : find_openfoam()) {
        const bool here =
            std::filesystem::exists(one.bin / cloud_solver) || !find_program(environment_of(one), cloud_solver).empty();
        if (here && (!found || (one.sound && !found->sound))) found = one;
    }
    return found;
}

void run_cloud_case(const OpenFoam& openfoam, const std::filesystem::path& folder) {
    const CasePrograms programs(openfoam, folder);
    programs.run("blockMesh", {}, {});
    programs.run(cloud_solver, {}, {});
}

}  // namespace tw
