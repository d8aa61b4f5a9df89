#include "app/campaign/validate_case.h"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <cmath>

#include "app/arguments/output.h"
#include "app/campaign/write_grid_study.h"
#include "app/runs/solvers.h"
#include "base/errors.h"
#include "compare/verdict/left_out.h"
#include "import/import.h"
#include "methods/methods.h"
#include "suite/basis.h"
#include "text/did_you_mean.h"

namespace tw::app {
namespace {

namespace fs = std::filesystem;

/// What is run of a scene's methods: those of the suite, else of the scene file, as far as they are asked for.
std::vector<std::string> methods_asked(const SuiteScene& scene, const std::string& method) {
    std::vector<std::string> of_scene = scene.methods;
    if (of_scene.empty()) of_scene = read_scene(scene.file, scene.changes).run.methods;
    std::vector<std::string> asked;
    for (const std::string& name : method_names())
        if (std::ranges::find(of_scene, name) != of_scene.end() &&
            (method.empty() || method == every_method || method == name))
            asked.push_back(name);
    return asked;
}

RunRequest request_of(const SuiteScene& scene, const std::vector<std::string>& methods, const ValidationRules& rules) {
    return {.file = scene.file,
            .overrides = scene.changes,
            .method = methods.size() == 1 ? methods.front() : every_method,
            .threads = rules.threads,
            .snapshots = false,
            .elsewhere = rules.elsewhere};
}

PlannedScene plan_scene(const SuiteScene& scene, const ValidationRules& rules, const fs::path& out) {
    PlannedScene planned{.scene = &scene, .methods = methods_asked(scene, rules.method)};
    if (planned.methods.empty()) return planned;
    const RunRequest own = request_of(scene, planned.methods, rules);
    const PlannedRun finest = plan_run(own);
    planned.near_hull = finest.scene.resolution.near_hull;
    planned.plan = plan_grid_study({.request = own,
                                    .levels = scene.levels,
                                    .ratio = scene.ratio,
                                    .variations = false,
                                    .uncertain = scene.uncertain},
                                   out);
    return planned;
}

/// What the runs of one scene gave.
struct SceneHarvest {
    GridStudyHarvest harvest;
    std::optional<GridStudy> grid_study;
    std::map<std::string, std::string> why_failed;  ///< by method: of its own size
    std::vector<CaseCost> costs;
    std::map<std::string, std::vector<std::string>> versions;  ///< by method: of the program, as the records say
    std::map<std::string, std::string> dates;                  ///< by method: the last day on which a run was begun
};

/// The readings of a case's quantities stand beside those that every report has.
GridStudyRun with_readings(const fs::path& file, RunRecord record, const PlannedCase& planned, std::size_t scene) {
    std::vector<Quantity> read;
    for (const SuiteQuantity& q : planned.of->quantities)
        if (q.scene == scene && q.reading)
            read.push_back(quantity_of(*q.reading, q.judged.name,
                                       q.judged.label.empty() ? q.judged.name : q.judged.label, record));
    GridStudyRun run = grid_study_run(std::move(record));
    run.file = file;
    for (Quantity& q : read) {
        std::erase_if(run.quantities, [&](const Quantity& other) { return other.name == q.name; });
        run.quantities.push_back(std::move(q));
    }
    return run;
}

void charge(SceneHarvest& harvest, const GridStudyRun& run) {
    auto cost = std::ranges::find(harvest.costs, run.method, &CaseCost::method);
    if (cost == harvest.costs.end()) cost = harvest.costs.insert(cost, {run.method});
    cost->core_seconds += run.core_seconds, cost->seconds += run.seconds, ++cost->runs;
}

/// False: stopped on request.
bool make_runs(const PlannedCase& planned, std::size_t place, Campaign& campaign, SceneHarvest& harvest) {
    const PlannedScene& scene = planned.scenes[place];
    const auto take_run = [&](const GridStudyJob& job, auto&& into) {
        const CampaignRun& run = job.run;
        CampaignResult result;
        try {
            result = campaign.run_or_take(run);
        } catch (const InputError& e) {  // what is only found while a run is set up
            complain(run.name + ": " + e.what());
            result.why_not = e.what();
        }
        if (result.state == CampaignResult::State::stopped) return false;
        if (result.there() && job.is_wave_twin()) {
            charge(harvest, grid_study_run(std::move(*result.record)));
        } else if (result.there()) {
            std::vector<std::string>& versions = harvest.versions[run.method];
            if (const std::string& version = result.record->attributes["code_version"];
                std::ranges::find(versions, version) == versions.end())
                versions.push_back(version);
            std::string& date = harvest.dates[run.method];
            date = std::max(date, result.record->attributes["started"].substr(0, std::size("2026-01-31") - 1));
            GridStudyRun made = with_readings(run.folder / "record.h5", std::move(*result.record), planned, place);
            charge(harvest, made);
            into(std::move(made));
        } else if (!job.choice && !job.is_wave_twin() &&
                   std::abs(run.plan.scene.resolution.near_hull / scene.near_hull - 1) < 1e-6) {
            harvest.why_failed[run.method] = result.why_not;
        } else {
            harvest.harvest.left_out.push_back(run.name + ": " + result.why_not);
        }
        return true;
    };
    for (const GridStudyJob& job : scene.plan.jobs) {
        const bool goes_on = take_run(job, [&](GridStudyRun run) {
            if (job.choice)
                harvest.harvest.variations.push_back(variation_of(*job.choice, std::move(run)));
            else
                harvest.harvest.runs.push_back(std::move(run));
        });
        if (!goes_on) return false;
    }
    return true;
}

const Quantity* quantity_in(const GridStudyRun& run, const std::string& name) {
    const auto found = std::ranges::find(run.quantities, name, &Quantity::name);
    return found == run.quantities.end() ? nullptr : &*found;
}

/// With what the run leaves out, where that has a bound.
void add_outer(ValidatedValue& v, const GridStudyValue& value, const GridStudyRun& run, const Quantity& of_run) {
    MeanValue mean = of_run.values[0];
    mean.discretisation = value.estimate.uncertainty, mean.choices = std::hypot(value.choices, value.box);
    mean.uncertainty = std::hypot(value.own, value.box);
    const OuterInterval outer = outer_interval(of_run, mean, read_record(run.file));
    v.outer_below = outer.below, v.outer_above = outer.above;
}

std::string unknown_quantity(const SuiteQuantity& q, const GridStudy& grid_study) {
    std::vector<std::string> known;
    for (const GridStudyQuantity& l : grid_study.quantities) known.push_back(l.name);
    std::string all;
    for (const std::string& name : known) all += (all.empty() ? "" : ", ") + name;
    return fmt::format("{}: the runs have no such quantity; they have: {}{}", q.place, all,
                       did_you_mean(q.judged.name, known));
}

ValidatedValue value_of(const SuiteQuantity& q, const std::string& method, const SceneHarvest& harvest,
                        double near_hull) {
    ValidatedValue v;
    v.method = method, v.outcome = Outcome::failed;
    if (const auto made = harvest.versions.find(method); made != harvest.versions.end())
        v.version = fmt::format("{}", fmt::join(made->second, ", ")), v.date = harvest.dates.at(method);
    if (const auto failed = harvest.why_failed.find(method); failed != harvest.why_failed.end())
        return v.why_not = failed->second, v;
    if (!harvest.grid_study) return v.why_not = "no run is finished", v;
    const GridStudy& grid_study = *harvest.grid_study;
    const auto side = std::ranges::find(grid_study.sides, method, &GridStudySide::method);
    if (side == grid_study.sides.end()) return v.why_not = "no run of this method is finished", v;
    const auto quantity = std::ranges::find(grid_study.quantities, q.judged.name, &GridStudyQuantity::name);
    if (quantity == grid_study.quantities.end()) return v.why_not = unknown_quantity(q, grid_study), v;
    if (quantity->unit != q.judged.unit)
        return v.why_not = fmt::format("{}: is in {} in the runs, and in {} in the suite; expected one unit", q.place,
                                       quantity->unit, q.judged.unit),
               v;
    const GridStudyValue& value = quantity->values[static_cast<std::size_t>(side - grid_study.sides.begin())];
    if (value.levels.empty() || std::abs(value.levels.front().h / near_hull - 1) > 1e-6) {
        v.why_not = "its own size gives none";
        for (const std::string& why : value.absent) v.why_not += "; " + why;
        return v;
    }
    v.value = value.levels.front().value;
    v.statistical = value.statistical;
    v.discretisation = v.own_discretisation = value.estimate.uncertainty;
    v.by_method = method_estimates(value.estimate);
    v.choices = std::hypot(value.choices, value.box), v.input = value.input;
    v.inputs = inputs_of(value.sensitivities);
    v.order = value.estimate.order, v.convergence = to_string(value.estimate.convergence);
    for (const StudyLevel& level : value.levels) v.sizes.emplace_back(level.h, level.value);
    v.why_not = value.estimate.why_not;
    if (const Quantity* of_run = quantity_in(side->runs.front(), q.judged.name))
        add_outer(v, value, side->runs.front(), *of_run);
    return v;
}

/// The truth of a quantity that an import holds, within the time of the runs.
void take_measured(ValidatedQuantity& judged, const SuiteQuantity& q, const SceneHarvest& harvest) {
    const RunRecord record = import_record(q.measured);
    if (q.reading) {
        const MeanValue m = quantity_of(*q.reading, q.judged.name, "", record).values[0];
        if (!m.known) throw InputError(fmt::format("{}: {}", q.measured.string(), m.why_not));
        judged.truth.value = m.value;
    } else {
        const GridStudy held = grid_study_of(harvest.harvest, {record});
        const auto found = std::ranges::find(held.quantities, q.judged.name, &GridStudyQuantity::name);
        if (found == held.quantities.end() || found->held.empty())
            throw InputError(fmt::format("{}: holds no {}", q.measured.string(), q.judged.name));
        judged.truth.value = found->held.back().value.value;
        if (!q.own_uncertainty) judged.truth.half_width = found->held.back().value.half_width;
    }
    if (!std::isfinite(judged.scale)) judged.scale = std::abs(judged.truth.value);
    if (judged.truth.half_width < 0) judged.truth.half_width *= -judged.scale;  // a share, see read_truth
    if (q.goal_share) judged.goal = *q.goal_share * judged.scale;
}

std::vector<std::map<std::string, ValueBasis>> bases_of(const SuiteCase& c) {
    std::vector<std::map<std::string, ValueBasis>> all(c.quantities.size());
    for (std::size_t s = 0; s < c.scenes.size(); ++s)
        for (const std::string& method : method_names()) try {
                const std::string scene = scene_digest(c.scenes[s], method);
                for (std::size_t k = 0; k < all.size(); ++k)
                    if (const SuiteQuantity& q = c.quantities[k]; q.scene == s)
                        all[k][method] = {scene, definition_digest(q, c.scenes[s]), truth_digest(q)};
            } catch (const InputError&) {}
    return all;
}

ValidatedQuantity judged_quantity(const SuiteQuantity& q, const PlannedScene& scene, const SceneHarvest& harvest,
                                  std::map<std::string, ValueBasis> basis) {
    ValidatedQuantity judged = q.judged;
    judged.basis = std::move(basis);
    for (const std::string& method : scene.methods) {
        judged.values.push_back(value_of(q, method, harvest, scene.near_hull));
        judged.values.back().made_for = judged.basis[method];
    }
    if (harvest.grid_study && judged.label.empty())
        for (const GridStudyQuantity& l : harvest.grid_study->quantities)
            if (l.name == judged.name) judged.label = l.label;
    if (judged.label.empty()) judged.label = judged.name;
    if (!q.measured.empty() && harvest.grid_study) try {
            take_measured(judged, q, harvest);
        } catch (const InputError& e) {
            complain(e.what());
            for (ValidatedValue& v : judged.values) v.value = nan, v.why_not = e.what();
        }
    for (ValidatedValue& v : judged.values) {
        bound_by_spread(v, judged);
        judge_against(v, judged);
    }
    return judged;
}

/// Says of all that a case asks why it is not there.
ValidatedCase case_not_run(const PlannedCase& planned, ValidatedCase c) {
    for (const SuiteQuantity& q : planned.of->quantities) {
        ValidatedQuantity& judged = c.quantities.emplace_back(q.judged);
        judged.basis = planned.bases[c.quantities.size() - 1];
        if (judged.label.empty()) judged.label = judged.name;
        ValidatedValue v;
        v.outcome = planned.wrong ? Outcome::failed : Outcome::not_run;
        v.why_not = c.why_not;
        for (const std::string& method : method_names()) {
            const std::vector<std::string>& of_scene = planned.of->scenes[q.scene].methods;
            if (!of_scene.empty() && std::ranges::find(of_scene, method) == of_scene.end()) continue;
            v.method = method;
            judged.values.push_back(v);
        }
    }
    return c;
}

}  // namespace

PlannedCase plan_case(const SuiteCase& of, const ValidationRules& rules, const fs::path& out) {
    PlannedCase planned{&of, {}, false, {}, bases_of(of)};
    const auto rank = [](const std::string& tier) {
        return std::ranges::find(suite_tiers(), tier) - suite_tiers().begin();
    };
    if (!rules.cases.empty() && std::ranges::find(rules.cases, of.name) == rules.cases.end())
        planned.why_not = "not asked for";
    else if (rank(of.tier) > rank(rules.tier))
        planned.why_not = fmt::format("of tier {}; {} was asked for", of.tier, rules.tier);
    if (!planned.why_not.empty()) return planned;
    std::string place;
    try {
        bool any = false;
        for (const SuiteScene& scene : of.scenes) {
            place = scene.place;
            planned.scenes.push_back(
                plan_scene(scene, rules, scene.name.empty() ? out / of.name : out / of.name / scene.name));
            any |= !planned.scenes.back().methods.empty();
        }
        if (!any) planned.why_not = "of no method that was asked for";
    } catch (const InputError& e) {
        planned.why_not = place + ": " + e.what(), planned.wrong = true;
        complain(of.name + ": " + planned.why_not);
    }
    for (PlannedScene& scene : planned.scenes)
        for (GridStudyJob& job : scene.plan.jobs) job.run.name = of.name + ": " + job.run.name;
    return planned;
}

std::optional<ValidatedCase> judge_case(const PlannedCase& planned, Campaign& campaign, const fs::path& out) {
    const SuiteCase& of = *planned.of;
    ValidatedCase c{of.name, of.title, of.family, of.tier, of.why, of.shows, of.shows_not, {}, planned.why_not, {}, {}};
    for (const SuiteScene& scene : of.scenes) {
        const std::string file = scene.file.lexically_proximate(fs::current_path()).string();
        if (std::ranges::find(c.scenes, file) == c.scenes.end()) c.scenes.push_back(file);
    }
    if (!planned.why_not.empty()) return case_not_run(planned, std::move(c));
    std::vector<SceneHarvest> harvests(planned.scenes.size());
    for (std::size_t k = 0; k < harvests.size(); ++k) {
        SceneHarvest& h = harvests[k];
        h.harvest.left_out = planned.scenes[k].plan.left_out;
        if (!make_runs(planned, k, campaign, h)) return {};
        h.harvest.drop_lone_variations();
        if (h.harvest.runs.empty()) continue;
        h.grid_study = grid_study_of(h.harvest);
        const std::string& name = planned.scenes[k].scene->name;
        write_tables(*h.grid_study, name.empty() ? out / of.name : out / of.name / name);
        for (const CaseCost& cost : h.costs) {
            auto at = std::ranges::find(c.costs, cost.method, &CaseCost::method);
            if (at == c.costs.end()) at = c.costs.insert(at, {cost.method});
            at->core_seconds += cost.core_seconds, at->seconds += cost.seconds, at->runs += cost.runs;
        }
    }
    for (std::size_t k = 0; k < of.quantities.size(); ++k) {
        const SuiteQuantity& q = of.quantities[k];
        c.quantities.push_back(judged_quantity(q, planned.scenes[q.scene], harvests[q.scene], planned.bases[k]));
    }
    return c;
}

}  // namespace tw::app
