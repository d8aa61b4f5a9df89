#include <fmt/format.h>

#include <algorithm>

#include "app/arguments/output.h"
#include "app/campaign/campaign.h"
#include "app/runs/ranks.h"
#include "app/runs/solvers.h"
#include "app/study/study.h"
#include "app/terminal/stop_signal.h"
#include "base/errors.h"
#include "base/folder_lock.h"
#include "compare/ablate/ablation.h"
#include "compare/report/numbers.h"
#include "methods/methods.h"
#include "scene/effects/registry.h"

namespace tw::app {
namespace {

namespace fs = std::filesystem;

/// The scene as it is, or with one effect switched.
struct Variant {
    std::string name = "base", folder = "base", effect = {};
    std::size_t against = 0;  ///< the variant it differs from by this one effect
    SceneOverrides overrides = {};
    std::optional<PlannedRun> plan = {};
    std::vector<std::string> methods = {};
    std::string why_not = {};  ///< why it cannot be switched
};

/// The variants of a command; those that others are compared with come first.
class Variants {
public:
    explicit Variants(const AblateCommand& command) : command_(command) {
        Variant base;
        base.overrides = command.scene.overrides();
        base.plan = plan(base.overrides);
        all_.push_back(std::move(base));
    }

    /// Switches an effect in the base; one that needs another in the variant that has this other one on. Returns its
    /// place.
    std::size_t add(const std::string& effect) {
        const auto there = std::ranges::find(all_, effect, &Variant::effect);
        if (there != all_.end()) return static_cast<std::size_t>(there - all_.begin());
        Variant v;
        v.effect = effect;
        const std::string needed = effect_part(effect).needs;
        if (!needed.empty() && !all_.front().plan->scene.effect_on(needed)) v.against = add(needed);
        if (const Variant& reference = all_[v.against]; reference.plan) {
            switch_effect(v, reference);
        } else {
            v.name = v.folder = effect;
            v.why_not = fmt::format("needs {}, which cannot be switched: {}", needed, reference.why_not);
        }
        all_.push_back(std::move(v));
        return all_.size() - 1;
    }

    /// Methods of the base: every one that some variant needs. Throws InputError: nothing can be switched.
    std::vector<Variant> take() {
        for (const std::string& method : method_names())
            if (std::ranges::any_of(
                    all_, [&](const Variant& v) { return std::ranges::find(v.methods, method) != v.methods.end(); }))
                all_.front().methods.push_back(method);
        if (all_.front().methods.empty())
            throw InputError(
                fmt::format("none of these effects can be switched; {}: {}", all_.back().effect, all_.back().why_not));
        return std::move(all_);
    }

private:
    PlannedRun plan(const SceneOverrides& overrides) const {
        return plan_run({.file = command_.scene.file,
                         .overrides = overrides,
                         .method = command_.method,
                         .threads = command_.threads,
                         .elsewhere = command_.making.elsewhere()});
    }

    void switch_effect(Variant& v, const Variant& reference) const {
        const Scene& before = reference.plan->scene;
        const bool on = !before.effect_on(v.effect);
        v.name = fmt::format("{} {}", v.effect, on ? "on" : "off");
        v.folder = fmt::format("{}_{}", v.effect, on ? "on" : "off");
        v.overrides = reference.overrides;
        v.overrides.effects[v.effect] = on;
        std::vector<std::string> follow;  // what the plan switches with it
        try {
            for (const std::string& other : effect_names())
                if (!on && effect_part(other).needs == v.effect) v.overrides.effects[other] = false;
            v.plan = plan(v.overrides);
            for (const std::string& other : effect_names())
                if (other != v.effect && v.plan->scene.effect_on(other) != before.effect_on(other))
                    follow.push_back(other);
            if (!follow.empty()) v.name += fmt::format(" (with {})", fmt::join(follow, ", "));
        } catch (const InputError& e) {
            v.why_not = std::string("cannot be switched: ") + e.what();
            return;
        }
        if (v.plan->scene.sph.levels != before.sph.levels || v.plan->scene.domain.box.min != before.domain.box.min ||
            v.plan->scene.domain.box.max != before.domain.box.max) {
            v.why_not =
                "cannot be switched alone: it also changes the sizes of the particles or the box; write [sph] levels = "
                "1";
            v.plan.reset();
            return;
        }
        const auto& asked = v.plan->scene.run.methods;
        for (const std::string& method : method_names())
            if (std::ranges::find(asked, method) != asked.end() && solves(method, effect_part(v.effect)))
                v.methods.push_back(method);
        if (v.methods.empty())
            v.why_not = "cannot be switched: it acts in the particle method alone, which does not run here";
    }

    const AblateCommand& command_;
    std::vector<Variant> all_;
};

std::vector<Variant> variants_of(const AblateCommand& command) {
    std::vector<std::string> asked;
    for (const std::string& name : command.effects) {
        asked.push_back(present_name(name));
        refuse_unknown_effect("--effects " + name, asked.back());
    }
    Variants variants(command);
    for (const std::string& name : effect_names())
        if (asked.empty() || std::ranges::find(asked, name) != asked.end()) variants.add(name);
    return variants.take();
}

CampaignRun run_of(const Variant& variant, const std::string& method, const fs::path& out) {
    return {variant.name + ": " + method_label(method), method, *variant.plan, out / variant.folder / method};
}

std::vector<CampaignRun> runs_of(const std::vector<Variant>& variants, const fs::path& out) {
    std::vector<CampaignRun> runs;
    for (const Variant& v : variants)
        for (const std::string& method : v.methods) runs.push_back(run_of(v, method, out));
    return runs;
}

/// All methods of one variant. False: stopped on request. What is wrong with a variant goes into its row; the
/// base must be sound: RunError or InputError.
bool run_variant(const Variant& variant, const fs::path& out, Campaign& campaign, AblationRun& run) {
    for (const std::string& method : variant.methods) {
        try {
            CampaignResult result = campaign.run_or_take(run_of(variant, method, out));
            if (result.state == CampaignResult::State::stopped) return false;
            if (result.there())
                run.sides.push_back(ablation_side(std::move(*result.record)));
            else if (variant.effect.empty())
                throw RunError("the base failed, so there is nothing to compare with: " + result.why_not);
            else
                run.why_not = result.why_not;
        } catch (const InputError& e) {
            if (variant.effect.empty()) throw;
            run.why_not = e.what();
            complain(variant.name + ": " + run.why_not);
        }
    }
    return true;
}

}  // namespace

int run_ablate(const AblateCommand& command, const Common& common) {
    const fs::path out =
        command.out.empty() ? fs::path("runs") / (command.scene.file.stem().string() + "_ablation") : command.out;
    const std::vector<Variant> variants = variants_of(command);
    const Scene& scene = variants.front().plan->scene;
    if (!command.making.hand_over && !command.making.collect)
        say(common, ready_text(variants.front().methods, scene, &variants.front().plan->prediction));
    say(common, unused_ranks(scene));
    double seconds = 0;
    int count = 0;
    for (const Variant& v : variants) {
        for (const std::string& method : v.methods) seconds += v.plan->seconds(method), ++count;
        if (!v.why_not.empty()) complain(v.name + ": " + v.why_not);
    }
    say(common, fmt::format("{} runs, {} in all; results in {}\n", count, about_text(seconds), out.string()));

    const FolderLock lock(out);
    CampaignRules rules = rules_of(command.making, out);
    rules.overwrite = command.overwrite;
    Campaign campaign(common, rules);
    const Study study{out, common.words, rules.overwrite, rules.take_finished};
    const std::vector<CampaignRun> all = runs_of(variants, out);
    if (command.making.hand_over) return hand_over(command.making, study, campaign, all, common);

    catch_stop_signals();
    campaign.ahead(study, all);
    std::vector<AblationRun> runs;
    for (const Variant& v : variants) {
        AblationRun& run = runs.emplace_back(AblationRun{v.name, v.effect, v.against, v.why_not});
        if (!run_variant(v, out, campaign, run)) {
            complain("ablate: stopped on request; the same command continues from here");
            return run_failed;
        }
    }
    const bool all_failed = std::ranges::none_of(
        runs, [](const AblationRun& r) { return !r.effect.empty() && r.why_not.empty() && !r.sides.empty(); });
    const Ablation ablation = build_ablation(scene.title, std::move(runs));
    make_folder(out);
    write_file(out / "ablation.md", ablation_text(ablation));
    write_file(out / "ablation.json", ablation_json(ablation));
    write_file(out / "ablation.csv", ablation_csv(ablation));
    write_file(out / "ablation.html", ablation_html(ablation));
    say(common, "\n" + ablation_summary(ablation) + "\nreport: " + (out / "ablation.html").string() + "\n");
    write_json(common, ablation_json(ablation));
    return all_failed || campaign.any_failed() ? run_failed : done;
}

}  // namespace tw::app
