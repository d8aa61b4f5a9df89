#include "foam_cases/run/first_steps.h"

#include <fmt/format.h>

#include <chrono>
#include <csignal>
#include <thread>

#include "base/atomic_file.h"
#include "base/errors.h"
#include "foam_cases/files/case_files.h"
#include "foam_cases/read/body_rows.h"
#include "foam_cases/read/time_folders.h"

namespace tw {
namespace fs = std::filesystem;

namespace {

/// To the end of the run; false when it was stopped.
bool run_solver(const CasePlan& plan, const CasePrograms& programs, int ranks,
                const std::function<bool()>& stop_asked) {
    const auto child =
        programs.start(programs.openfoam().solver, plan.flavour.solver_arguments(), "first_steps", ranks);
    for (;;) {
        if (const auto ended = child->poll()) {
            if (ended->ok()) return true;
            throw RunError(fmt::format("{} failed in the body's first steps:\n{}", programs.openfoam().solver.string(),
                                       why_it_failed(programs.log("first_steps"))));
        }
        if (stop_asked()) {
            child->signal_group(SIGKILL);
            child->wait();
            return false;
        }
        std::this_thread::sleep_for(std::chrono::milliseconds(50));
    }
}

}  // namespace

std::optional<double> release_factor(const CasePlan& plan, const CasePrograms& programs, int ranks,
                                     const std::function<bool()>& stop_asked) {
    const fs::path folder = programs.case_folder(), control = folder / "system/controlDict";
    // Steps grow by a fifth: six of them, in which the body has moved by half a cell. Body and air answer each other
    // with a relaxation, which has done its work by then.
    Scene scene = *plan.scene;
    scene.run.duration = 10 * plan.first_step;
    CasePlan trial = plan;
    trial.scene = &scene;
    trial.write_interval = 2 * scene.run.duration;  // nothing is kept
    write_text_atomically(control, control_dict(trial));
    const bool ran = run_solver(trial, programs, ranks, stop_asked);
    const std::vector<BodyPlace> places = ran ? free_places(plan, folder / "postProcessing") : std::vector<BodyPlace>();
    const TimeFolders folders(folder);
    for (const TimeFolders::Moment& m : folders.moments()) folders.remove(m);
    fs::remove_all(folder / "postProcessing");
    write_text_atomically(control, control_dict(plan));
    if (!ran) return {};
    if (places.empty()) throw RunError("interFoam has not said where the body is after its first steps");

    const RigidBodySetup& motion = plan.moving().motion;
    const Vec3 wanted = motion.velocity, falls(0, 0, motion.free.along[2] ? -scene.water.gravity : 0);
    const Vec3 lost = wanted + falls * places.back().time - places.back().velocity;
    const double share = lost.dot(wanted) / wanted.squaredNorm();
    if (!(share > -0.5 && share < 0.5))
        throw RunError(
            fmt::format("the body loses {:.3g} % of its speed in its first steps through the air, more than the drag "
                        "of the air explains; see {}",
                        100 * share, programs.log("first_steps").string()));
    return 1 / (1 - share);
}

}  // namespace tw
