#include "app/campaign/coarser_members.h"

#include <fmt/format.h>

#include <algorithm>
#include <functional>
#include <map>
#include <numbers>

#include "app/arguments/output.h"
#include "app/runs/read_run.h"
#include "app/runs/solvers.h"
#include "base/errors.h"
#include "compare/report/numbers.h"
#include "methods/methods.h"
#include "scene/hash.h"
#include "scene/refined_places.h"
#include "scene/wave_twin.h"

namespace tw::app {

namespace fs = std::filesystem;

namespace {

bool is_of_another_scene(const CampaignRun& run) {
    const fs::path file = run.folder / "record.h5";
    if (!fs::exists(file)) return false;
    RunRecord record = read_record(file);
    return record.attributes["run_hash"] != run_hash(run.plan.scene, run.method);
}

}  // namespace

GridStudySizes sizes_of_coarser_members(RunRequest own) {
    own.snapshots = false;
    return {.request = std::move(own), .levels = 3, .ratio = std::numbers::sqrt2, .variations = false};
}

CoarserMembers::CoarserMembers(RunRequest own, const fs::path& out) {
    GridStudySizes sizes = sizes_of_coarser_members(std::move(own));
    sizes.first = 1;
    plan_ = plan_grid_study(sizes, out);
    harvest_.left_out = plan_.left_out;
    sizes.request.method = every_method;
    for (GridStudyJob& job : plan_grid_study(sizes, out).jobs)
        if (std::ranges::none_of(plan_.jobs, [&](const GridStudyJob& j) { return j.run.method == job.run.method; }))
            of_other_methods_.push_back(std::move(job));
}

std::vector<CampaignRun> CoarserMembers::runs() const { return runs_of(plan_.jobs); }

std::vector<std::vector<CampaignRun>> CoarserMembers::by_size() const {
    std::map<double, std::vector<CampaignRun>, std::greater<>> sizes;
    for (const GridStudyJob& job : plan_.jobs) sizes[job.run.plan.scene.resolution.near_hull].push_back(job.run);
    std::vector<std::vector<CampaignRun>> all;
    for (auto& [near_hull, runs] : sizes) all.push_back(std::move(runs));
    return all;
}

double CoarserMembers::seconds() const {
    double sum = 0;
    for (const GridStudyJob& job : plan_.jobs)
        if (!is_finished(job.run)) sum += job.run.plan.seconds(job.run.method);
    return sum;
}

std::string CoarserMembers::prediction_text(const Scene& scene, double own) const {
    const auto count = [&](auto what) { return std::ranges::count_if(plan_.jobs, what); };
    const auto boxes = count([](const GridStudyJob& j) { return j.choice && j.choice->box; });
    const auto inputs = count([](const GridStudyJob& j) { return j.choice && !j.choice->input.empty(); });
    const auto coarser_members = count([](const GridStudyJob& j) { return j.is_wave_twin(); });
    const auto sizes = static_cast<long>(plan_.jobs.size()) - boxes - inputs - coarser_members;
    std::string text;
    if (sizes > 0)
        text = fmt::format(
            "grid triplet: {} coarser run{}{}{}{}, {} (+ {:.0f} %); --no-twins leaves them out\n", sizes,
            sizes == 1 ? "" : "s", boxes > 0 ? " and one in a wider box" : "",
            coarser_members > 0 ? fmt::format(", {} without {}", coarser_members, left_out_of_twin(scene)) : "",
            inputs > 0 ? fmt::format(", {} for [uncertain]", inputs) : "", about_text(seconds()),
            own > 0 ? 100 * seconds() / own : 0);
    for (const std::string& line : plan_.left_out) text += "! grid triplet: " + line + "\n";
    const int sizes_here = sizes_of_particles(scene);
    for (const GridStudyJob& job : plan_.jobs) {
        const Scene& twin = job.run.plan.scene;
        if (elements_of(job.run.method) != "particles" || sizes_of_particles(twin) == sizes_here) continue;
        text += fmt::format(
            "! grid triplet: {}: {} size{} of particles ({:.3g}) where the scene's own run has {}: there is no room "
            "for more at this spacing; the runs are not similar, and the report says so\n",
            job.run.name, sizes_of_particles(twin), sizes_of_particles(twin) == 1 ? "" : "s",
            job.run.plan.prediction.particles, sizes_here);
    }
    return text;
}

void CoarserMembers::refuse_others() const {
    for (const GridStudyJob& job : plan_.jobs)
        if (is_of_another_scene(job.run))
            throw InputError(
                fmt::format("{}: there is a run of another scene already; run anew with --overwrite, or "
                            "choose another folder with --out",
                            job.run.folder.string()));
}

void CoarserMembers::remove_others(const std::set<fs::path>& made) const {
    for (const GridStudyJob& job : plan_.jobs)
        if (made.contains(job.run.folder) && is_of_another_scene(job.run)) fs::remove_all(job.run.folder);
}

bool CoarserMembers::run(Campaign& campaign) {
    for (const GridStudyJob& job : plan_.jobs) {
        try {
            if (!take(harvest_, job, campaign.run_or_take(job.run))) return false;
        } catch (const InputError& e) {  // what is only found while a run is set up, such as a hull without particles
            harvest_.left_out.push_back(job.run.name + ": left out: " + e.what());
            complain(harvest_.left_out.back());
        }
    }
    return true;
}

std::optional<GridStudy> CoarserMembers::grid_study(const std::vector<RunRecord>& records, const fs::path& own) {
    GridStudyHarvest harvest = harvest_;
    for (const GridStudyJob& job : of_other_methods_)
        if (is_finished(job.run))
            take(harvest, job, {CampaignResult::State::taken, read_run(job.run.folder / "record.h5"), {}});
    // of methods whose own run is there and finished: the coarser members of others say nothing of what is compared
    GridStudyHarvest all;
    all.left_out = harvest.left_out;
    for (const RunRecord& record : records) {
        const auto at = record.attributes.find("method");
        if (record.state != "finished" || at == record.attributes.end()) continue;
        for (const GridStudyRun& run : harvest.runs)
            if (run.method == at->second) all.runs.push_back(run);
        all.take(record, own / at->second / "record.h5");
    }
    if (all.runs.empty()) return {};
    all.variations = harvest.variations;
    all.drop_lone_variations();
    try {
        return grid_study_of(all);
    } catch (const InputError& e) {  // the runs are there: their comparison is worth a report all the same
        complain(std::string("coarser runs (twins): no discretisation error: ") + e.what());
        return {};
    }
}

}  // namespace tw::app
