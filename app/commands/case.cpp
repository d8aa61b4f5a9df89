#include "app/arguments/output.h"
#include "app/runs/solvers.h"
#include "base/errors.h"
#include "foam_cases/write_case.h"
#include "scene/cost/node.h"

namespace tw::app {

int run_case(const CaseCommand& command, const Common& common) {
    const Scene scene = read_scene(command.scene.file, command.scene.overrides());
    refuse_unmeshable(scene);
    refuse_oversize(scene, predict_by_table(scene));
    if (std::filesystem::exists(command.folder) && !std::filesystem::is_empty(command.folder))
        throw InputError(command.folder.string() + ": exists already and is not empty; choose a new folder");
    make_folder(command.folder);
    leaving_files([&] { write_fvm_case(scene, command.folder); });
    say(common, command.folder.string() + ": OpenFOAM case written; run it with ./Allrun\n");
    return done;
}

}  // namespace tw::app
