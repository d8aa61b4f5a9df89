#include "app/commands/validate.h"

#include <fmt/chrono.h>
#include <fmt/format.h>

#include <algorithm>
#include <chrono>

#include "app/arguments/output.h"
#include "app/campaign/validate_case.h"
#include "app/runs/solvers.h"
#include "app/study/study.h"
#include "app/terminal/stop_signal.h"
#include "base/atomic_file.h"
#include "base/errors.h"
#include "base/folder_lock.h"
#include "compare/truth/validation_report.h"
#include "record/code_version.h"
#include "record/this_machine.h"
#include "suite/formulas.h"
#include "text/did_you_mean.h"

namespace tw::app {
namespace {

namespace fs = std::filesystem;

/// Pages first, so that a wrong folder is found before a table is printed.
void write_pages(const ValidationReport& report, const fs::path& folder) {
    make_folder(folder);
    for (const MadePage& page : validation_pages(report)) write_file(folder / page.name, page.text);
}

void write_all(const ValidationReport& report, const std::vector<ValidationChange>& changes,
               const ValidateCommand& command, const fs::path& out, const Common& common) {
    make_folder(out);
    write_file(out / "validation.json", validation_json(report));
    write_file(out / "validation.html", validation_html(report, changes, command.against.string()));
    write_file(out / "validation.csv", validation_csv(report));
    write_file(out / "junit.xml", validation_junit(report));
    if (!command.pages.empty()) write_pages(report, command.pages);
    for (const fs::path& page : command.into) write_file(page, with_tables(read_text(page), page.string(), report));
    say(common, "\n" + validation_text(report, changes) + "\nreport: " + (out / "validation.html").string() + "\n");
    write_json(common, validation_json(report));
}

/// The exit status of --require.
int required(const ValidateCommand& command, const ValidationReport& report,
             const std::vector<ValidationChange>& changes) {
    std::string not_met;
    const auto name = [&](const std::string& what) { not_met += (not_met.empty() ? "" : "; ") + what; };
    if (command.require == "no-worse")
        for (const ValidationChange& c : changes)
            if (c.kind == ValidationChange::Kind::worse) name(c.what);
    if (command.require == "goals")
        for (const ValidatedCase& c : report.cases)
            for (const ValidatedQuantity& q : c.quantities)
                for (const ValidatedValue& v : q.values)
                    if (falls_short(v, q) && !q.known_miss.contains(v.method))
                        name(fmt::format("{}, {}, {}", c.name, q.label, v.method));
    if (not_met.empty()) return done;
    complain("--require " + command.require + " is not met: " + not_met);
    return not_agreed;
}

int finish(const ValidateCommand& command, ValidationReport report, const fs::path& out, const Common& common) {
    if (!command.keep.empty()) {
        ValidationReport earlier = read_validation(command.keep);
        if (!earlier.estimator.empty()) judge_by(earlier, uncertainty_methods().front());
        for (const std::string& refused : keep_values(report, earlier)) complain("--keep: " + refused);
    }
    if (!command.estimator.empty()) judge_by(report, command.estimator);
    std::vector<ValidationChange> changes;
    if (!command.against.empty()) changes = changes_between(read_validation(command.against), report);
    write_all(report, changes, command, out, common);
    return required(command, report, changes);
}

void refuse_unknown_cases(const Suite& suite, const std::vector<std::string>& names) {
    std::vector<std::string> known;
    for (const SuiteCase& c : suite.cases) known.push_back(c.name);
    for (const std::string& name : names)
        if (std::ranges::find(known, name) == known.end())
            throw InputError("--case " + name + ": the suite has no such case" + did_you_mean(name, known));
}

/// What the machine needs for the methods that are run.
std::string ready_for(const std::vector<PlannedCase>& cases) {
    std::vector<std::string> methods;
    std::optional<Scene> scene;
    for (const PlannedCase& c : cases)
        for (const PlannedScene& s : c.scenes)
            for (const GridStudyJob& job : s.plan.jobs) {
                if (!scene) scene = job.run.plan.scene;
                if (std::ranges::find(methods, job.run.method) == methods.end()) methods.push_back(job.run.method);
            }
    return scene ? ready_text(methods, *scene) : "";
}

std::string today() {
    return fmt::format("{:%Y-%m-%d}",
                       fmt::gmtime(std::chrono::system_clock::to_time_t(std::chrono::system_clock::now())));
}

}  // namespace

int run_validate(const ValidateCommand& command, const Common& common) {
    if (command.formulas) {
        say(common, formulas_text());
        return done;
    }
    if (command.suite.empty()) throw InputError("validate: expected the folder of a suite, or --formulas");
    if (command.require == "no-worse" && command.against.empty())
        throw InputError("--require no-worse: expected an earlier report to be no worse than: --against FILE");
    if (fs::is_regular_file(command.suite)) {
        const fs::path out = command.out.empty() ? fs::absolute(command.suite).parent_path() : command.out;
        ValidationReport report = read_validation(command.suite);
        if (report.estimator.empty()) judge_by(report, uncertainty_methods().front());  // by the rules of this version
        return finish(command, std::move(report), out, common);
    }
    const Suite suite = read_suite(command.suite);
    refuse_unknown_cases(suite, command.cases);
    for (const fs::path& earlier : {command.against, command.keep})
        if (!earlier.empty()) read_validation(earlier);  // refused before hours are spent
    const fs::path out =
        command.out.empty()
            ? fs::path("runs") / (fs::weakly_canonical(fs::absolute(command.suite)).filename().string() + "_validation")
            : command.out;
    const ValidationRules asked{command.tier, command.method, command.cases, command.threads,
                                command.making.elsewhere()};
    std::vector<PlannedCase> planned;
    std::vector<CampaignRun> all;
    for (const SuiteCase& c : suite.cases) {
        planned.push_back(plan_case(c, asked, out));
        if (!planned.back().why_not.empty()) continue;
        for (const PlannedScene& scene : planned.back().scenes)
            for (CampaignRun& run : scene.runs()) all.push_back(std::move(run));
    }
    const FolderLock lock(out);
    CampaignRules rules = rules_of(command.making, out);
    rules.overwrite = command.overwrite;
    Campaign campaign(common, rules);
    const Study study{out, common.words, rules.overwrite, rules.take_finished};
    if (command.making.hand_over) return hand_over(command.making, study, campaign, all, common);
    if (!command.making.collect) say(common, ready_for(planned));
    catch_stop_signals();
    campaign.ahead(study, all);
    ValidationReport report{suite.title, command.tier, TWINWAKE_CODE_VERSION, cpu_model(), today(), common.command, {}};
    std::ranges::replace(report.command, '\n', ' ');
    bool failed = false;
    for (const PlannedCase& c : planned) {
        std::optional<ValidatedCase> judged = judge_case(c, campaign, out);
        if (!judged) {
            complain("validate: stopped on request; the same command continues from here");
            return run_failed;
        }
        failed |= c.wrong;
        report.cases.push_back(std::move(*judged));
    }
    const int status = finish(command, std::move(report), out, common);
    return failed || campaign.any_failed() ? static_cast<int>(run_failed) : status;
}

}  // namespace tw::app
