#include "app/facts_json.h"
#include "app/output.h"
#include "app/run_method.h"
#include "app/twins.h"

namespace tw::app {

int run_check(const CheckCommand& command, const Common& common) {
    const auto [scene, prediction] = plan_run(command.scene.file, command.scene.overrides(), "", command.threads);
    const PlannedRun plan{scene, prediction};
    double own = 0;
    for (const std::string& method : scene.run.methods) own += plan.seconds(method);
    const Twins twins(command.scene.file, command.scene.overrides(), "", command.threads, {});
    say(common, to_text(scene, prediction) + twins.prediction_text(own));
    write_json(common, check_json(scene, prediction));
    return done;
}

}  // namespace tw::app
