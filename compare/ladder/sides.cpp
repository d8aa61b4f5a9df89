#include "compare/ladder/steps.h"

#include <fmt/format.h>

#include <algorithm>
#include <tuple>

#include "base/errors.h"
#include "compare/ladder/variation.h"
#include "methods/methods.h"

namespace tw {

std::vector<LadderSide> sides_of(std::vector<LadderRun> runs) {
    std::ranges::sort(runs, [](const LadderRun& a, const LadderRun& b) {
        return std::tuple(method_rank(a.method), a.method, a.spacing) <
               std::tuple(method_rank(b.method), b.method, b.spacing);
    });
    std::vector<LadderSide> sides;
    for (LadderRun& run : runs) {
        if (sides.empty() || sides.back().method != run.method) sides.push_back({run.method, {}, {}, true});
        LadderSide& side = sides.back();
        if (!side.runs.empty() && run.spacing <= side.runs.back().spacing * (1 + 1e-6))
            throw InputError(fmt::format("two {} runs with the spacing {:g} m; expected one run of every size",
                                         method_label(side.method), run.spacing));
        if (!side.runs.empty()) {
            const Family &first = side.runs.front().family, &here = run.family;
            const bool hashes = !first.hash.empty() && !here.hash.empty();
            if (hashes && first.hash != here.hash)
                throw InputError(fmt::format(
                    "{0} at {1:g} m and {0} at {2:g} m are not of one family: {3}; expected runs of one scene with one "
                    "set of numerics, which differ in their sizes alone",
                    method_label(side.method), side.runs.front().spacing, run.spacing,
                    family_differences(first, here)));
            side.similar = side.similar && (hashes || first.likeness == here.likeness);
        }
        side.runs.push_back(std::move(run));
    }
    return sides;
}

void add_variation(std::vector<LadderSide>& sides, LadderVariation v) {
    for (LadderSide& side : sides)
        if (const auto base = std::ranges::find_if(side.runs, [&](const LadderRun& r) { return same_rung(r, v.run); });
            base != side.runs.end()) {
            weigh(v, *base);
            side.variations.push_back(std::move(v));
            return;
        }
    throw InputError(fmt::format("{} with {}: the study has no {} run of {:g} m that it varies", v.run.method, v.name,
                                 v.run.method, v.run.spacing));
}

}  // namespace tw
