#include <fmt/format.h>

#include "app/arguments/output.h"
#include "app/campaign/twins.h"
#include "app/runs/facts_json.h"
#include "app/runs/ranks.h"
#include "app/runs/run_method.h"
#include "base/errors.h"
#include "compare/report/resolution_picture.h"
#include "compare/report/svg_plot.h"
#include "scene/new_record.h"
#include "scene/refined_places.h"
#include "sph_solver/on_gpu.h"

namespace tw::app {

namespace {

void draw_sizes(const Scene& scene, const std::filesystem::path& file) {
    std::vector<RunRecord> runs;
    std::vector<std::string> names;
    for (const std::string& method : scene.run.methods) {
        runs.push_back(new_record(scene, method));
        names.push_back(elements_of(method) + " (" + method + ")");
    }
    const std::string picture = resolution_picture(runs, names);
    if (picture.empty())
        throw InputError(
            "--picture: particles and cells have one size everywhere in this scene, and it has no forcing zones; leave "
            "the "
            "option out");
    write_file(file, svg_file(picture));
}

}  // namespace

int run_check(const CheckCommand& command, const Common& common) {
    const PlannedRun plan = plan_run({.file = command.scene.file,
                                      .overrides = command.scene.overrides(),
                                      .threads = command.threads,
                                      .ranks = command.ranks});
    const Scene& scene = plan.scene;
    double own = 0;
    for (const std::string& method : scene.run.methods) own += plan.seconds(method);
    const Twins twins({.file = command.scene.file, .overrides = command.scene.overrides(), .threads = command.threads},
                      {});
    say(common, to_text(scene, plan.prediction) + twins.prediction_text(scene, own) +
                    "budget: none, the scene's own sizes are run; run --budget TIME chooses the finest that fit\n");
    const RanksTake ranks = ranks_take(plan, command.ranks);
    say(common, ranks.line);
    if (built_for_gpu()) {
        const Prediction& p = plan.prediction;
        say(common,
            fmt::format("gpu: one can make the particles' steps (run --device gpu) with {:.2g} GB of its "
                        "memory; the force by the control volume is left out\n",
                        bytes_on_gpu(p.most_particles + p.wall_particles, sizes_of_particles(scene) > 1) / 1e9));
    }
    if (!command.picture.empty()) draw_sizes(scene, command.picture);
    write_json(common, check_json(scene, plan.prediction, ranks));
    return done;
}

}  // namespace tw::app
