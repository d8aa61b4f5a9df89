#include "app/campaign/plan_again.h"

#include <fmt/format.h>

#include <map>

#include "app/runs/run_method.h"
#include "app/runs/solvers.h"
#include "base/errors.h"
#include "compare/report/numbers.h"
#include "text/plain_number.h"

namespace tw::app {
namespace {

constexpr double tolerated = 1.15, too_short = 0.02;

/// By what is known of this machine's pace now, which runs that have been made have taught [s].
double seconds_now(const CampaignRun& run) { return predict_here(run.plan.scene).of(run.method).seconds; }

/// Of one method: what runs took, and what they are predicted to take now [s].
struct Taken {
    double taken = 0, predicted = 0;
    double factor() const { return predicted > 0 ? taken / predicted : 1; }
};

}  // namespace

Trial try_coarsest(const std::vector<std::vector<CampaignRun>>& by_size, const std::vector<CampaignRun>& all,
                   const GridStudySizes& family, const PaidSizes& now, double budget, Campaign& campaign) {
    std::map<std::string, Taken> methods;
    for (const std::vector<CampaignRun>& size : by_size) {
        for (const CampaignRun& run : size) {
            const CampaignResult result = campaign.run_or_take(run);
            if (result.state == CampaignResult::State::stopped) return Trial{true, {}, {}};
            if (!result.there()) continue;
            const double taken = facts_of(run.method, *result.record, run.folder).wall;
            if (taken < too_short * budget) continue;
            methods[run.method].taken += taken, methods[run.method].predicted += seconds_now(run);
        }
        double predicted = 0, expected = 0;  // of what is still to be made
        for (const CampaignRun& run : all) {
            if (is_finished(run)) continue;
            const double seconds = seconds_now(run);
            predicted += seconds, expected += seconds * methods[run.method].factor();
        }
        if (!(predicted > 0) || campaign.spent() + expected <= tolerated * budget) continue;
        const std::string late =
            fmt::format("! what is still to be made will take {}, and {} of the budget of {} are used",
                        about_text(expected), time_text(campaign.spent()), time_text(budget));
        const double left = (budget - campaign.spent()) / (expected / predicted);
        try {
            if (left > 0)
                if (PaidSizes fewer = sizes_for_budget(family, left); fewer.scale > now.scale) {
                    fewer.seconds *= expected / predicted;
                    return {false, fewer,
                            fmt::format("{}: near_hull = {} m in place of {} m, with all runs {}\n", late,
                                        plain_number(fewer.near_hull), plain_number(now.near_hull),
                                        about_text(fewer.seconds))};
                }
        } catch (const InputError&) {}  // no sizes that the scene allows are cheap enough
        return {false, {}, late + ": no coarser sizes that the scene allows fit what is left; the study goes on\n"};
    }
    return {};
}

}  // namespace tw::app
