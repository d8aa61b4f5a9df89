#include <fmt/format.h>

#include "app/arguments/output.h"
#include "app/campaign/coarser_members.h"
#include "app/commands/check_page.h"
#include "app/runs/facts_json.h"
#include "app/runs/ranks.h"
#include "app/runs/run_method.h"
#include "compare/report/svg_plot.h"
#include "scene/refined_places.h"
#include "sph_solver/on_gpu.h"

namespace tw::app {

int run_check(const CheckCommand& command, const Common& common) {
    const PlannedRun plan = plan_run({.file = command.scene.file,
                                      .overrides = command.scene.overrides(),
                                      .threads = command.threads,
                                      .ranks = command.ranks});
    const Scene& scene = plan.scene;
    double own = 0;
    for (const std::string& method : scene.run.methods) own += plan.seconds(method);
    const CoarserMembers coarser_members(
        {.file = command.scene.file, .overrides = command.scene.overrides(), .threads = command.threads}, {});
    std::string text = to_text(scene, plan.prediction) + coarser_members.prediction_text(scene, own) +
                       "budget: none, the scene's own sizes are run; run --budget TIME chooses the finest that fit\n";
    const RanksTake ranks = ranks_take(plan, command.ranks);
    text += ranks.line;
    if (built_for_gpu()) {
        const Prediction& p = plan.prediction;
        text += fmt::format(
            "gpu: one can make the particles' steps (run --device gpu) with {:.2g} GB of its "
            "memory; the force by the control volume is left out\n",
            bytes_on_gpu(p.most_particles + p.wall_particles, sizes_of_particles(scene) > 1) / 1e9);
    }
    // Before a word is printed: a reader of the words that has enough, as head has, ends the program.
    if (!command.picture.empty()) write_file(command.picture, svg_file(scene_picture(scene)));
    if (!command.html.empty()) write_file(command.html, check_page(scene, text));
    write_json(common, check_json(scene, plan.prediction, ranks));
    say(common, text);
    for (const std::filesystem::path& file : {command.picture, command.html})
        if (!file.empty()) say(common, "written: " + file.string() + "\n");
    return done;
}

}  // namespace tw::app
