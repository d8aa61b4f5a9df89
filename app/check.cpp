#include "app/facts_json.h"
#include "app/machine_pace.h"
#include "app/output.h"

namespace tw::app {

int run_check(const CheckCommand& command, const Common& common) {
    const Scene scene = read_scene(command.scene.file, command.scene.overrides());
    const Prediction prediction = predict(scene, machine_pace());
    refuse_oversize(scene, prediction);
    say(common, to_text(scene, prediction));
    write_json(common, check_json(scene, prediction));
    return done;
}

}  // namespace tw::app
