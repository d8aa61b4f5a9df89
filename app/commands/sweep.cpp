#include "compare/sweep/sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "app/arguments/output.h"
#include "app/campaign/campaign.h"
#include "app/campaign/coarser_members.h"
#include "app/campaign/hull_labels.h"
#include "app/campaign/wave_twin.h"
#include "app/runs/ranks.h"
#include "app/runs/solvers.h"
#include "app/study/study.h"
#include "app/terminal/stop_signal.h"
#include "base/errors.h"
#include "base/folder_lock.h"
#include "compare/grid_study/grid_study_report.h"
#include "compare/grid_study/judge_by_sizes.h"
#include "record/record_numbers.h"

namespace tw::app {
namespace {

namespace fs = std::filesystem;

/// One scene of the set: the scene file with another hull, speed, trim and wave length.
struct SweptScene {
    std::string name, folder;
    std::string but_speed, but_wave_length;  ///< the name without the one and without the other
    SceneOverrides overrides;
    std::optional<PlannedRun> plan = {};
    std::string why_not = {};  ///< what is wrong with this scene
};

/// Letters, digits, points and dashes of a name; the rest becomes a dash.
std::string plain(std::string name) {
    for (char& c : name)
        if (!std::isalnum(static_cast<unsigned char>(c)) && c != '.') c = '-';
    return name;
}

std::string joined(std::initializer_list<std::string> parts) {
    std::string name;
    for (const std::string& part : parts)
        if (!part.empty()) name += (name.empty() ? "" : ", ") + part;
    return name;
}

/// A list that is not given stands for the scene's own value, which is "".
std::vector<std::string> or_own(const std::vector<std::string>& list) {
    return list.empty() ? std::vector<std::string>{""} : list;
}

/// Every hull at every speed, trim and wave length.
std::vector<SweptScene> variants_of(const SweepCommand& command) {
    const std::vector<fs::path> hulls = command.hulls.empty() ? std::vector<fs::path>{{}} : command.hulls;
    const std::vector<std::string> labels = hull_labels(hulls);
    std::vector<SweptScene> variants;
    const auto add = [&](std::size_t h, const std::string& speed, const std::string& trim, const std::string& wave) {
        SceneArguments scene = command.scene;
        scene.hull = hulls[h], scene.speed = speed, scene.trim = trim, scene.wave_length = wave;
        const std::string at_trim = trim.empty() ? "" : "trim " + trim,
                          in_waves = wave.empty() ? "" : "waves of " + wave;
        std::string name = joined({labels[h], speed, at_trim, in_waves});
        if (name.empty()) name = command.scene.file.stem().string();
        std::string folder = plain(name);  // a run that is there is found again when the lists grow
        while (std::ranges::find(variants, folder, &SweptScene::folder) != variants.end()) folder += "_2";
        variants.push_back({name, folder, joined({labels[h], at_trim, in_waves}), joined({labels[h], speed, at_trim}),
                            scene.overrides()});
    };
    for (std::size_t h = 0; h < hulls.size(); ++h)
        for (const std::string& speed : or_own(command.speeds))
            for (const std::string& trim : or_own(command.trims))
                for (const std::string& wave : or_own(command.wave_lengths)) add(h, speed, trim, wave);
    return variants;
}

RunRequest request_of(const SweptScene& variant, const SweepCommand& command) {
    return {.file = command.scene.file,
            .overrides = variant.overrides,
            .method = command.method,
            .threads = command.threads,
            .elsewhere = command.making.elsewhere()};
}

void plan_all(std::vector<SweptScene>& variants, const SweepCommand& command) {
    for (SweptScene& v : variants) try {
            v.plan = plan_run(request_of(v, command));
        } catch (const InputError& e) {
            v.why_not = e.what();
            complain(v.name + ": " + v.why_not);
        }
}

CoarserMembers coarser_members_of(const SweptScene& variant, const fs::path& out, const SweepCommand& command) {
    return {request_of(variant, command), out / variant.folder / "twins"};
}

CampaignRun run_of(const SweptScene& variant, const std::string& method, const fs::path& out) {
    return {variant.name + ": " + method_label(method), method, *variant.plan, out / variant.folder / method};
}

/// All that will be run as long as no coarser member fails.
std::vector<CampaignRun> runs_of(const std::vector<SweptScene>& variants, const fs::path& out,
                                 const SweepCommand& command) {
    std::vector<CampaignRun> runs;
    std::string coarser_members = command.coarser_members;
    for (const SweptScene& v : variants) {
        if (!v.plan) continue;
        if (coarser_members != "none")
            for (CampaignRun& twin : coarser_members_of(v, out, command).runs()) {
                twin.name = v.name + ": " + twin.name;
                runs.push_back(std::move(twin));
            }
        if (coarser_members == "first") coarser_members = "none";
        for (const std::string& method : v.plan->scene.run.methods) {
            CampaignRun run = run_of(v, method, out);
            if (std::optional<CampaignRun> twin = wave_twin_of(run)) runs.push_back(std::move(*twin));
            runs.push_back(std::move(run));
        }
    }
    return runs;
}

/// Which scenes run coarser members, and what they have told so far.
struct Errors {
    std::string coarser_members;  ///< first, all, none
    RelativeErrors first = {};
    bool wanted() const { return coarser_members == "all" || (coarser_members == "first" && first.scene.empty()); }
};

/// All methods of one scene, their coarser members if it is to run some, and their comparison. False: stopped on
/// request. What is wrong with this scene goes into the member; the others are run all the same.
bool run_swept(const SweptScene& variant, const fs::path& out, const SweepCommand& command, Campaign& campaign,
               Errors& errors, SweepMember& member) {
    member.why_not = variant.why_not;
    if (!variant.plan) return true;
    const fs::path folder = out / variant.folder;
    try {
        std::optional<CoarserMembers> coarser_members;
        if (errors.wanted()) coarser_members = coarser_members_of(variant, out, command);
        if (coarser_members && !coarser_members->run(campaign)) return false;
        std::vector<RunRecord> records;
        for (const std::string& method : variant.plan->scene.run.methods) {
            const CampaignRun run = run_of(variant, method, out);
            if (const std::optional<CampaignRun> twin = wave_twin_of(run);
                twin && campaign.run_or_take(*twin).state == CampaignResult::State::stopped)
                return false;
            CampaignResult result = campaign.run_or_take(run);
            if (result.state == CampaignResult::State::stopped) return false;
            if (!result.there()) {
                member.why_not = method + ": " + result.why_not;
                return true;
            }
            records.push_back(std::move(*result.record));
        }
        const std::optional<GridStudy> grid_study =
            coarser_members ? coarser_members->grid_study(records, folder) : std::nullopt;
        Comparison comparison = compare_records(std::move(records));
        if (grid_study) {
            judge_by_sizes(comparison, *grid_study);
            write_tables(*grid_study, folder);
            if (!comparison.discretisation_from.empty()) errors.first = relative_errors(*grid_study, variant.name);
        } else if (errors.coarser_members == "first") {
            judge_by_errors_of(comparison, errors.first);
        }
        leaving_files([&] { return write_report(comparison, folder, grid_study ? grid_study_html(*grid_study) : ""); });
        member.report = variant.folder + "/report.html";
        member.methods = comparison.names;
        member.quantities = comparison.quantities;
        member.references = comparison.references;
        member.discretisation_from = comparison.discretisation_from;
        const RunRecord& first = comparison.sources.front();
        member.speed = {variant.but_speed, number_of(first, "speed", nan)};
        member.wave_length = {variant.but_wave_length, number_of(first, "wave_length", nan)};
    } catch (const InputError& e) {
        member.why_not = e.what();
        complain(variant.name + ": " + member.why_not);
    }
    return true;
}

}  // namespace

int run_sweep(const SweepCommand& command, const Common& common) {
    const fs::path out =
        command.out.empty() ? fs::path("runs") / (command.scene.file.stem().string() + "_sweep") : command.out;
    std::vector<SweptScene> variants = variants_of(command);
    plan_all(variants, command);
    const auto first = std::ranges::find_if(variants, [](const SweptScene& v) { return v.plan.has_value(); });
    if (first != variants.end()) say(common, unused_ranks(first->plan->scene));
    const FolderLock lock(out);
    CampaignRules rules = rules_of(command.making, out);
    rules.overwrite = command.overwrite;
    Campaign campaign(common, rules);
    const Study study{out, common.words, rules.overwrite, rules.take_finished};
    const std::vector<CampaignRun> all = runs_of(variants, out, command);
    if (command.making.hand_over) return hand_over(command.making, study, campaign, all, common);
    if (first != variants.end() && !command.making.collect)
        say(common, ready_text(first->plan->scene.run.methods, first->plan->scene, &first->plan->prediction));
    catch_stop_signals();
    campaign.ahead(study, all);
    std::vector<SweepMember> members;
    Errors errors{command.coarser_members};
    for (const SweptScene& variant : variants) {
        SweepMember& member = members.emplace_back();
        member.name = variant.name;
        if (!run_swept(variant, out, command, campaign, errors, member)) {
            complain("sweep: stopped on request; the same command continues from here");
            return run_failed;
        }
    }
    const bool all_failed = std::ranges::none_of(members, [](const SweepMember& m) { return m.why_not.empty(); });
    const Sweep sweep = build_sweep(command.scene.file.stem().string() + ": a set of scenes", std::move(members));
    make_folder(out);
    write_file(out / "sweep.md", sweep_text(sweep));
    write_file(out / "sweep.json", sweep_json(sweep));
    write_file(out / "sweep.csv", sweep_csv(sweep));
    write_file(out / "sweep.html", sweep_html(sweep));
    say(common, "\n" + sweep_text(sweep) + "\nreport: " + (out / "sweep.html").string() + "\n");
    write_json(common, sweep_json(sweep));
    return all_failed || campaign.any_failed() ? run_failed : done;
}

}  // namespace tw::app
