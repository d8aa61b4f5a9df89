#include "compare/ladder/ladder.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/errors.h"
#include "compare/checks/checks.h"
#include "compare/ladder/steps.h"
#include "methods/methods.h"

namespace tw {

bool same_rung(const LadderRun& a, const LadderRun& b) {
    return a.method == b.method && std::abs(a.spacing / b.spacing - 1) < 1e-6;
}

LadderRun ladder_run(RunRecord record, const CompareOptions& options) {
    const auto spacing = record.numbers.find("near_hull");
    if (spacing == record.numbers.end() || !(spacing->second > 0))
        throw InputError(fmt::format(
            "the {} record has no spacing at the hull (number near_hull); a grid-convergence study needs one",
            record.attributes["method"]));
    LadderRun run;
    run.title = record.attributes["title"], run.method = record.attributes["method"];
    run.spacing = spacing->second, run.elements = record.elements, run.memory = record.peak_memory;
    run.steps = record.steps;
    if (const auto sizes = record.numbers.find("levels"); sizes != record.numbers.end())
        run.element_sizes = sizes->second;
    run.predicted_seconds = record.numbers["predicted_seconds"], run.duration = record.numbers["duration"];
    for (const Phase& phase : record.phases) run.seconds += phase.wall, run.core_seconds += phase.cpu;
    run.hull_hash = record.attributes["hull_hash"];
    run.calibrated = record.attributes["calibrated"];
    run.family = family_of(record);
    run.domain = domain_of(record);
    std::vector<RunRecord> one;
    one.push_back(std::move(record));
    Comparison comparison = compare_records(std::move(one), options);
    run.quantities = std::move(comparison.quantities);
    run.references = std::move(comparison.references);
    run.failed_checks = failed_checks(std::move(comparison.checks));
    return run;
}

std::vector<LadderVariation> take_variations(std::vector<LadderRun>& runs) {
    std::vector<LadderVariation> variations;
    std::vector<LadderRun> kept;
    for (LadderRun& run : runs) {
        std::optional<LadderVariation> choice;
        for (const LadderRun& base : runs)
            if (&base != &run && same_rung(base, run) && !run.family.hash.empty() &&
                base.family.hash != run.family.hash && !choice)
                choice = variation_between(base, run);
        if (choice)
            variations.push_back(std::move(*choice));
        else
            kept.push_back(run);
    }
    runs = std::move(kept);
    return variations;
}

Ladder build_ladder(std::vector<LadderRun> runs, std::vector<LadderVariation> variations, double agree_within,
                    const std::vector<RunRecord>& measured) {
    if (runs.empty()) throw InputError("a grid-convergence study without a finished run; expected one or more");
    Ladder ladder;
    ladder.title = runs.front().title;
    ladder.agree_within = agree_within;
    ladder.sides = sides_of(std::move(runs));
    for (const LadderSide& side : ladder.sides)
        if (side.runs.front().hull_hash != ladder.sides.front().runs.front().hull_hash)
            throw InputError(
                fmt::format("{} and {} were not run with the same hull: their difference would not be one of "
                            "method; expected records of one scene",
                            method_label(ladder.sides.front().method), method_label(side.method)));
    for (LadderVariation& v : variations) add_variation(ladder.sides, std::move(v));
    for (const LadderSide& side : ladder.sides) {
        for (const std::string& note : {steps_note(side), unlike_sizes_note(side)})
            if (!note.empty()) ladder.notes.push_back(note);
        for (const LadderVariation& v : side.variations)
            if (!v.refused.empty())
                ladder.notes.push_back(fmt::format("{} with {}: no evidence, and no share of the intervals: {}",
                                                   method_label(side.method), v.name, v.refused));
    }
    for (const LadderSide& side : ladder.sides)  // the union of what the runs measured, in their order
        for (const LadderRun& run : side.runs)
            for (const Quantity& from : run.quantities)
                if (from.judged || from.judged_in_ladder) {
                    const auto at = std::ranges::find(ladder.quantities, from.name, &LadderQuantity::name);
                    if (at != ladder.quantities.end() && at->unit != from.unit)
                        throw InputError(
                            fmt::format("{} at {:g} m: {} is in {}, elsewhere in {}; expected one unit in "
                                        "all records",
                                        method_label(side.method), run.spacing, from.label, from.unit, at->unit));
                    if (at != ladder.quantities.end()) continue;
                    LadderQuantity q;
                    q.name = from.name, q.label = from.label, q.unit = from.unit;
                    ladder.quantities.push_back(std::move(q));
                }
    for (LadderQuantity& q : ladder.quantities) {
        double scale = 0;
        for (const LadderSide& side : ladder.sides)
            for (const LadderRun& run : side.runs)
                if (const Quantity* of_run = find_quantity(run, q.name)) scale = std::max(scale, of_run->scale);
        for (std::size_t k = 0; k < ladder.sides.size(); ++k)
            q.values.push_back(value_of(ladder.sides, k, q.name, scale));
        judge(q, ladder.sides, ladder.agree_within, scale);
    }
    for (const LadderSide& side : ladder.sides)
        for (const LadderRun& run : side.runs)
            if (const std::string line = method_label(side.method) + ": " + run.calibrated;
                !run.calibrated.empty() && std::ranges::find(ladder.calibrated, line) == ladder.calibrated.end())
                ladder.calibrated.push_back(line);
    add_references(ladder);
    for (const RunRecord& record : measured) add_measured(ladder, record);
    return ladder;
}

}  // namespace tw
