#include "compare/grid_study/grid_study.h"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "base/errors.h"
#include "compare/checks/checks.h"
#include "compare/grid_study/steps.h"
#include "methods/methods.h"

namespace tw {

bool same_rung(const GridStudyRun& a, const GridStudyRun& b) {
    return a.method == b.method && std::abs(a.spacing / b.spacing - 1) < 1e-6;
}

GridStudyRun grid_study_run(RunRecord record, const CompareOptions& options) {
    const auto spacing = record.numbers.find("near_hull");
    if (spacing == record.numbers.end() || !(spacing->second > 0))
        throw InputError(fmt::format(
            "the {} record has no spacing at the hull (number near_hull); a grid-convergence study needs one",
            record.attributes["method"]));
    GridStudyRun run;
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

std::vector<GridStudyVariation> take_variations(std::vector<GridStudyRun>& runs) {
    std::vector<GridStudyVariation> variations;
    std::vector<GridStudyRun> kept;
    for (GridStudyRun& run : runs) {
        std::optional<GridStudyVariation> choice;
        for (const GridStudyRun& base : runs)
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

GridStudy build_grid_study(std::vector<GridStudyRun> runs, std::vector<GridStudyVariation> variations,
                           double agree_within, const std::vector<RunRecord>& measured) {
    if (runs.empty()) throw InputError("a grid-convergence study without a finished run; expected one or more");
    GridStudy grid_study;
    grid_study.title = runs.front().title;
    grid_study.agree_within = agree_within;
    grid_study.sides = sides_of(std::move(runs));
    for (const GridStudySide& side : grid_study.sides)
        if (side.runs.front().hull_hash != grid_study.sides.front().runs.front().hull_hash)
            throw InputError(
                fmt::format("{} and {} were not run with the same hull: their difference would not be one of "
                            "method; expected records of one scene",
                            method_label(grid_study.sides.front().method), method_label(side.method)));
    for (GridStudyVariation& v : variations) add_variation(grid_study.sides, std::move(v));
    for (const GridStudySide& side : grid_study.sides) {
        for (const std::string& note : {steps_note(side), unlike_sizes_note(side)})
            if (!note.empty()) grid_study.notes.push_back(note);
        for (const GridStudyVariation& v : side.variations)
            if (!v.refused.empty())
                grid_study.notes.push_back(fmt::format("{} with {}: no evidence, and no share of the intervals: {}",
                                                       method_label(side.method), v.name, v.refused));
    }
    for (const GridStudySide& side : grid_study.sides)  // the union of what the runs measured, in their order
        for (const GridStudyRun& run : side.runs)
            for (const Quantity& from : run.quantities)
                if (from.judged || from.judged_in_grid_study) {
                    const auto at = std::ranges::find(grid_study.quantities, from.name, &GridStudyQuantity::name);
                    if (at != grid_study.quantities.end() && at->unit != from.unit)
                        throw InputError(
                            fmt::format("{} at {:g} m: {} is in {}, elsewhere in {}; expected one unit in "
                                        "all records",
                                        method_label(side.method), run.spacing, from.label, from.unit, at->unit));
                    if (at != grid_study.quantities.end()) continue;
                    GridStudyQuantity q;
                    q.name = from.name, q.label = from.label, q.unit = from.unit;
                    grid_study.quantities.push_back(std::move(q));
                }
    for (GridStudyQuantity& q : grid_study.quantities) {
        double scale = 0;
        for (const GridStudySide& side : grid_study.sides)
            for (const GridStudyRun& run : side.runs)
                if (const Quantity* of_run = find_quantity(run, q.name)) scale = std::max(scale, of_run->scale);
        for (std::size_t k = 0; k < grid_study.sides.size(); ++k)
            q.values.push_back(value_of(grid_study.sides, k, q.name, scale));
        judge(q, grid_study.sides, grid_study.agree_within, scale);
    }
    for (const GridStudySide& side : grid_study.sides)
        for (const GridStudyRun& run : side.runs)
            if (const std::string line = method_label(side.method) + ": " + run.calibrated;
                !run.calibrated.empty() &&
                std::ranges::find(grid_study.calibrated, line) == grid_study.calibrated.end())
                grid_study.calibrated.push_back(line);
    add_references(grid_study);
    for (const RunRecord& record : measured) add_measured(grid_study, record);
    return grid_study;
}

}  // namespace tw
