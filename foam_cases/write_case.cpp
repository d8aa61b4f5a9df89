#include "foam_cases/write_case.h"

#include "base/atomic_file.h"
#include "base/errors.h"
#include "foam_cases/doctor.h"
#include "foam_cases/files/case_files.h"
#include "foam_cases/plan_case.h"
#include "meshes/surface.h"

namespace tw {
namespace fs = std::filesystem;

void write_case(const CasePlan& plan, const fs::path& folder, int ranks) {
    for (const char* part : {"system", "constant/triSurface", "0.orig"}) fs::create_directories(folder / part);
    for (const CaseFile& f : case_files(plan, ranks)) {
        write_text_atomically(folder / f.path, f.text);
        if (f.executable)
            fs::permissions(folder / f.path, fs::perms::owner_exec | fs::perms::group_exec | fs::perms::others_exec,
                            fs::perm_options::add);
    }
    write_text_atomically(folder / "case.foam", "");  // what ParaView opens
    if (!plan.ribbon.empty())
        write_stl(folder / "constant/triSurface" / (plan.ribbon + ".stl"),
                  ribbon(plan.shedding.edges, 0.1 * plan.shedding.reach), plan.ribbon);
    for (const Solid& s : plan.solids) write_stl(folder / "constant/triSurface" / (s.name + ".stl"), s.surface, s.name);
}

std::string changed_file(const CasePlan& plan, const fs::path& folder) {
    for (const CaseFile& f : case_files(plan, 1)) {
        if (f.path == "system/controlDict" || f.path == "system/decomposeParDict" || f.path == "Allrun" ||
            f.path == "README")
            continue;
        if (!fs::exists(folder / f.path) || read_text(folder / f.path) != f.text) return f.path;
    }
    return {};
}

void write_fvm_case(const Scene& scene, const fs::path& folder) {
    // Written for the installation that is here, sound or not; without one for the release the settings were measured
    // with.
    const auto found = find_openfoam(scene.fvm.openfoam);
    const CasePlan plan = found.empty() ? plan_case(scene, Flavour()) : plan_case(scene, found.front());
    if (fs::exists(folder) && !fs::is_empty(folder) && !fs::exists(folder / "system/controlDict"))
        throw InputError(folder.string() + ": holds something that is not an OpenFOAM case; choose an empty folder");
    write_case(plan, folder, std::max(1, scene.run.threads));
}

}  // namespace tw
