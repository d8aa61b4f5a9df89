#include "app/campaign/grid_study_jobs.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <optional>
#include <string_view>

#include "app/campaign/wave_twin.h"
#include "app/runs/solvers.h"
#include "base/errors.h"
#include "methods/methods.h"
#include "methods/names.h"
#include "scene/box/box_walls.h"

namespace tw::app {
namespace {

namespace fs = std::filesystem;

const std::vector<GridStudyChoice>& numerical_choices() {
    static const std::vector<GridStudyChoice> all{
        // The error of weak compressibility falls with Ma^2, so with c0^-2: 1/(1 - 1/1.5^2).
        {sph_method, "sound speed x 1.5", "sound_speed_1.5",
         [](RunRequest& r) { r.overrides.sound_speed_factor = 1.5; }, 1.8},
        // Errors of time stepping are taken as of first order: 1/(1 - 1/2).
        {sph_method, "half the time step", "time_step_0.5", [](RunRequest& r) { r.overrides.time_step_factor = 0.5; },
         2, 2},
        {fvm_method, "half the Courant number", "courant_0.5", [](RunRequest& r) { r.overrides.courant_factor = 0.5; },
         2, 2},
    };
    return all;
}
/// What the walls are worth; the share follows from the two boxes (compare/grid_study/steps.h).
GridStudyChoice wider_box() {
    return {.method = "",
            .name = "box x 1.5",
            .folder = "box_1.5",
            .make = [](RunRequest& r) { r.overrides.box_factor = 1.5; },
            .box = true};
}
/// Another model of the same surface: all of the change counts.
GridStudyChoice geometric_surface() {
    return {fvm_method, "geometric surface", "geometric_surface",
            [](RunRequest& r) { r.overrides.interface = "isoadvector"; }};
}
constexpr std::string_view upper_end = "_high", lower_end = "_low";
std::string end_of_interval(const std::string& number, bool upper) {
    return number + (upper ? ", upper end" : ", lower end");
}
/// An uncertain number at one end of its interval.
GridStudyChoice uncertain_input(const UncertainNumber& number, bool upper) {
    const double value = number.value + (upper ? number.half_width : -number.half_width);
    return {.method = "",
            .name = end_of_interval(number.name, upper),
            .folder = number.name + std::string(upper ? upper_end : lower_end),
            .make = [name = number.name, value](RunRequest& r) { r.numbers[name] = value; },
            .input = number.name};
}

/// Fewer sizes are not filled in: a fourth beside three makes their interval wider (decision 023).
constexpr int least_filled = 4;

class Planner {
public:
    Planner(const GridStudySizes& sizes, const fs::path& out) : sizes_(sizes), out_(out) {}

    GridStudyPlan plan() {
        std::optional<PlannedRun> coarsest;
        int allowed = 0;
        for (int k = sizes_.first; k < sizes_.levels; ++k)
            if (std::optional<PlannedRun> size = add_size(k)) coarsest = std::move(size), ++allowed;
        if (sizes_.surface && coarsest) refuse_idle_surface(coarsest->scene);
        if (sizes_.box && coarsest && sizes_.levels > 1) add_box(*coarsest);
        if (sizes_.input && coarsest) add_input(*coarsest);
        for (int k = 1; sizes_.fill && allowed >= least_filled && k + 1 < sizes_.levels; ++k) add_size(k + 0.5);
        std::ranges::stable_sort(plan_.jobs, {}, [](const GridStudyJob& j) {
            return std::pair(j.fills_in, j.run.plan.seconds(j.run.method));
        });
        add_wave_twins();
        return std::move(plan_);
    }

private:
    SceneOverrides overrides(double k) const {
        SceneOverrides o = sizes_.request.overrides;
        o.scale_resolution = o.scale_resolution.value_or(1) * std::pow(sizes_.ratio, k);
        return o;
    }
    RunRequest request_of(const SceneOverrides& o) const {
        RunRequest request = sizes_.request;
        request.overrides = o;
        return request;
    }
    fs::path folder_of(const PlannedRun& plan) const {
        return out_ / fmt::format("near_hull_{:.6g}mm", 1000 * plan.scene.resolution.near_hull);
    }
    void add(PlannedRun plan, const std::string& method, const fs::path& folder,
             const std::optional<GridStudyChoice>& choice, bool fills_in = false) {
        const std::string name =
            fmt::format("{} at {:g} m{}{}", method_label(method), plan.scene.resolution.near_hull,
                        choice ? fmt::format(", {}", choice->name) : "", fills_in ? ", between two sizes" : "");
        plan_.jobs.push_back({{name, method, std::move(plan), folder / method}, choice, fills_in});
    }
    /// Each before the run that it belongs to: what is read of that one has the wave of this one in it.
    void add_wave_twins() {
        std::vector<GridStudyJob> all;
        for (GridStudyJob& job : plan_.jobs) {
            if (std::optional<CampaignRun> twin = wave_twin_of(job.run))
                all.push_back({std::move(*twin), {}, job.fills_in});
            all.push_back(std::move(job));
        }
        plan_.jobs = std::move(all);
    }
    void leave_out(const SceneOverrides& o, const std::string& what, const InputError& why) {
        plan_.left_out.push_back(
            fmt::format("{} at {:.4g} times the scene's size: left out: {}", what, *o.scale_resolution, why.what()));
    }

    /// All methods of one size, and the choices if it is theirs; half a number fills in. None: the scene does not allow
    /// it; what is wrong at its own size is thrown.
    std::optional<PlannedRun> add_size(double k) {
        const SceneOverrides o = overrides(k);
        std::optional<PlannedRun> plan;
        try {
            plan = plan_run(request_of(o));
        } catch (const InputError& e) {
            if (k == 0) throw;
            leave_out(o, "run", e);
            return {};
        }
        for (const std::string& method : plan->scene.run.methods) {
            add(*plan, method, folder_of(*plan), {}, k != std::floor(k));
            if (k != std::max(0, sizes_.levels - 2)) continue;
            const auto vary = [&](const GridStudyChoice& choice) {
                if (choice.method == method) add_choice(o, folder_of(*plan), choice, method);
            };
            if (sizes_.variations) std::ranges::for_each(numerical_choices(), vary);
            if (sizes_.surface) vary(geometric_surface());
        }
        return plan;
    }
    void refuse_idle_surface(const Scene& scene) const {
        if (scene.fvm.captures_geometrically())
            throw InputError(
                fmt::format("{}: --surface would run the same once more; expected "
                            "\"mules\", or no --surface",
                            scene.place_of("fvm.interface")));
        if (std::ranges::find(scene.run.methods, geometric_surface().method) == scene.run.methods.end())
            throw InputError(
                "--surface: it is a run of the mesh method, which is not asked for; expected --method "
                "both or fvm, or no --surface");
    }
    void add_choice(const SceneOverrides& o, const fs::path& folder, const GridStudyChoice& choice,
                    const std::string& method) {
        RunRequest request = request_of(o);
        try {
            choice.make(request);
            add(plan_run(request), method, folder / choice.folder, choice);
        } catch (const InputError& e) { leave_out(o, choice.name, e); }
    }
    /// Either end of every uncertain number, of every method. The sizes stay those of the scene, also where they follow
    /// from what is changed, a hull's length: a size that changes with the number would be its own reason.
    void add_input(const PlannedRun& plan) {
        const Scene& scene = plan.scene;
        SceneOverrides o = sizes_.request.overrides;
        o.scale_resolution = scene.resolution.scale;
        const UncertainTable* more = sizes_.uncertain ? &*sizes_.uncertain : nullptr;
        for (const UncertainNumber& number : uncertain_numbers(sizes_.request.file, sizes_.request.overrides, more))
            for (const bool upper : {false, true}) {
                GridStudyChoice choice = uncertain_input(number, upper);
                RunRequest request = request_of(o);
                choice.make(request);
                try {
                    PlannedRun changed = plan_run(request);
                    if (changed.scene.resolution.near_hull != scene.resolution.near_hull) {
                        request.overrides.near_hull = scene.resolution.near_hull / scene.resolution.scale;
                        request.overrides.spacing = scene.resolution.spacing / scene.resolution.scale;
                        changed = plan_run(request);
                    }
                    for (const std::string& method : scene.run.methods)
                        add(changed, method, folder_of(plan) / choice.folder, choice);
                } catch (const InputError& e) { leave_out(o, choice.name, e); }
            }
    }
    /// Where the box has walls that the scene does not mean: in the method that is expected to take the least time, by the table of one core.
    /// What runs teach of this machine would choose otherwise after the runs than before them, and --collect, --resume
    /// and another machine have to find the run that was made.
    void add_box(const PlannedRun& plan) {
        const Domain& box = plan.scene.domain;
        if (!plan.scene.hull || plan.scene.motion.kind != Motion::Kind::stream) return;
        const bool sides_end_the_box = box.dimensions == 3 && !sides_are_meant(plan.scene);
        if (!sides_end_the_box && !box.floor_ends_the_box) return;  // a channel
        Scene on_one_core = plan.scene;
        on_one_core.run.threads = 1;
        const Prediction cost = predict_by_table(on_one_core);
        const std::string cheaper = *std::ranges::min_element(
            plan.scene.run.methods, {}, [&](const std::string& method) { return cost.of(method).seconds; });
        SceneOverrides o = sizes_.request.overrides;
        o.scale_resolution = plan.scene.resolution.scale;
        add_choice(o, folder_of(plan), wider_box(), cheaper);
    }

    const GridStudySizes& sizes_;
    const fs::path& out_;
    GridStudyPlan plan_;
};

}  // namespace

GridStudyPlan plan_grid_study(const GridStudySizes& sizes, const fs::path& out) { return Planner(sizes, out).plan(); }

std::vector<CampaignRun> runs_of(const std::vector<GridStudyJob>& jobs) {
    std::vector<CampaignRun> runs;
    for (const GridStudyJob& job : jobs) runs.push_back(job.run);
    return runs;
}

GridStudyVariation variation_of(const GridStudyChoice& choice, GridStudyRun run) {
    GridStudyVariation v{choice.name, choice.share, std::move(run), choice.steps, choice.box};
    v.input = choice.input;
    return v;
}

std::optional<GridStudyVariation> uncertain_input_of(const fs::path& record_file, const GridStudyRun& run) {
    const std::string folder = record_file.parent_path().parent_path().filename().string();
    for (const bool upper : {false, true}) {
        const std::string_view end = upper ? upper_end : lower_end;
        if (!folder.ends_with(end) || folder.find('.') == std::string::npos) continue;
        GridStudyVariation v{end_of_interval(folder.substr(0, folder.size() - end.size()), upper), 1, run};
        v.input = folder.substr(0, folder.size() - end.size());
        return v;
    }
    return {};
}

bool take(GridStudyHarvest& harvest, const GridStudyJob& job, CampaignResult result) {
    using State = CampaignResult::State;
    if (result.state == State::stopped) return false;
    if (!result.there()) {
        const bool failed = result.state == State::failed;
        harvest.left_out.push_back(job.run.name + ": " + (failed ? "failed: " : "") + result.why_not);
        harvest.any_failed |= failed;
    } else if (job.is_wave_twin()) {
        return true;  // what it measured comes with the run that has the bodies
    } else if (job.choice) {
        harvest.variations.push_back(variation_of(*job.choice, grid_study_run(std::move(*result.record))));
    } else {
        harvest.take(std::move(*result.record), job.run.folder / "record.h5");
    }
    return true;
}

}  // namespace tw::app
