#include "compare/sweep/sweep.h"

#include <fmt/format.h>

#include <algorithm>
#include <optional>

#include "app/campaign.h"
#include "app/output.h"
#include "app/solvers.h"
#include "app/stop_signal.h"
#include "app/twins.h"
#include "base/errors.h"
#include "base/folder_lock.h"
#include "compare/ladder/judge_by_sizes.h"

namespace tw::app {
namespace {

namespace fs = std::filesystem;

/// One scene of the set: the scene file with another hull, speed and trim.
struct SweptHull {
    std::string name, folder;
    SceneOverrides overrides;
};

/// Letters, digits, points and dashes of a name; the rest becomes a dash.
std::string plain(std::string name) {
    for (char& c : name)
        if (!std::isalnum(static_cast<unsigned char>(c)) && c != '.') c = '-';
    return name;
}

/// Every hull at every speed and trim; a list that is not given stands for the scene's own.
std::vector<SweptHull> variants_of(const SweepCommand& command) {
    const std::vector<fs::path> hulls = command.hulls.empty() ? std::vector<fs::path>{{}} : command.hulls;
    const std::vector<std::string> speeds = command.speeds.empty() ? std::vector<std::string>{""} : command.speeds,
                                   trims = command.trims.empty() ? std::vector<std::string>{""} : command.trims;
    std::vector<SweptHull> variants;
    for (const fs::path& hull : hulls)
        for (const std::string& speed : speeds)
            for (const std::string& trim : trims) {
                SceneArguments scene = command.scene;
                scene.hull = hull, scene.speed = speed, scene.trim = trim;
                std::string name;
                for (const std::string& part : {hull.stem().string(), speed, trim.empty() ? "" : "trim " + trim})
                    if (!part.empty()) name += (name.empty() ? "" : ", ") + part;
                if (name.empty()) name = command.scene.file.stem().string();
                std::string folder = plain(name);  // a run that is there is found again when the lists grow
                while (std::ranges::find(variants, folder, &SweptHull::folder) != variants.end()) folder += "_2";
                variants.push_back({name, folder, scene.overrides()});
            }
    return variants;
}

/// Which scenes run twins, and what they have told so far.
struct Errors {
    std::string twins;  ///< first, all, none
    RelativeErrors first = {};
    bool wanted() const { return twins == "all" || (twins == "first" && first.scene.empty()); }
};

/// All methods of one scene, their twins if it is to run some, and their comparison. False: stopped on request. What is
/// wrong with this scene goes into the member; the others are run all the same.
bool run_member(const SweptHull& variant, const fs::path& folder, const SweepCommand& command, Campaign& campaign,
                Errors& errors, SweepMember& member) {
    try {
        const PlannedRun plan = plan_run(command.scene.file, variant.overrides, every_method, command.threads);
        std::optional<Twins> twins;
        if (errors.wanted())
            twins.emplace(command.scene.file, variant.overrides, every_method, command.threads, folder / "twins");
        if (twins && !twins->run(campaign)) return false;
        std::vector<RunRecord> records;
        for (const std::string& method : plan.scene.run.methods) {
            CampaignResult result = campaign.run_or_take({variant.name + ": " + method, method, plan, folder / method});
            if (result.state == CampaignResult::State::stopped) return false;
            if (!result.there()) {
                member.why_not = method + ": " + result.why_not;
                return true;
            }
            records.push_back(std::move(*result.record));
        }
        const std::optional<Ladder> ladder = twins ? twins->ladder(records, folder) : std::nullopt;
        Comparison comparison = compare_records(std::move(records));
        if (ladder) {
            judge_by_sizes(comparison, *ladder);
            write_tables(*ladder, folder);
            if (!comparison.discretisation_from.empty()) errors.first = relative_errors(*ladder, variant.name);
        } else if (errors.twins == "first") {
            judge_by_errors_of(comparison, errors.first);
        }
        leaving_files([&] { return write_report(comparison, folder, ladder ? ladder_html(*ladder) : ""); });
        member.report = variant.folder + "/report.html";
        member.methods = comparison.names;
        member.quantities = comparison.quantities;
        member.discretisation_from = comparison.discretisation_from;
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
    const std::vector<SweptHull> variants = variants_of(command);
    say(common, ready_text(method_names(), {}));
    const FolderLock lock(out);
    catch_stop_signals();
    Campaign campaign(common, {.overwrite = command.overwrite});
    std::vector<SweepMember> members;
    Errors errors{command.twins};
    for (const SweptHull& variant : variants) {
        SweepMember& member = members.emplace_back();
        member.name = variant.name;
        if (!run_member(variant, out / variant.folder, command, campaign, errors, member)) {
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
