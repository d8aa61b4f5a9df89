#include "app/campaign/write_grid_study.h"

#include <algorithm>

#include "app/arguments/output.h"
#include "app/campaign/report_every.h"
#include "app/runs/read_run.h"
#include "compare/grid_study/grid_study_report.h"
#include "compare/grid_study/judge_by_sizes.h"
#include "compare/report/numbers.h"
#include "methods/methods.h"

namespace tw::app {

namespace fs = std::filesystem;

void GridStudyHarvest::take(RunRecord record, const fs::path& file) {
    runs.push_back(grid_study_run(std::move(record)));
    runs.back().file = file;
}

void GridStudyHarvest::drop_lone_variations() {
    std::erase_if(variations, [&](const GridStudyVariation& v) {
        return std::ranges::none_of(runs, [&](const GridStudyRun& r) { return same_rung(r, v.run); });
    });
}

std::vector<RunRecord> measured_records(const std::vector<fs::path>& sources) {
    std::vector<RunRecord> records;
    for (const fs::path& source : sources)
        records.push_back(read_record(fs::is_directory(source) ? source / "record.h5" : source));
    return records;
}

GridStudy grid_study_of(const GridStudyHarvest& harvest, const std::vector<RunRecord>& measured) {
    GridStudy grid_study = build_grid_study(harvest.runs, harvest.variations, CompareOptions{}.agree_within, measured);
    grid_study.left_out = harvest.left_out;
    return grid_study;
}

void write_tables(const GridStudy& grid_study, const fs::path& out) {
    make_folder(out);
    write_file(out / "ladder.md", grid_study_text(grid_study));
    write_file(out / "ladder.json", grid_study_json(grid_study));
    for (std::size_t k = 0; k < grid_study.sides.size(); ++k)
        write_file(out / ("ladder_" + grid_study.sides[k].method + ".csv"), grid_study_csv(grid_study, k));
}

GridStudy report_grid_study(const GridStudyHarvest& harvest, const std::vector<RunRecord>& measured,
                            const fs::path& out, const Common& common) {
    GridStudy grid_study = grid_study_of(harvest, measured);
    write_tables(grid_study, out);
    std::vector<RunRecord> finest;
    for (const GridStudySide& side : grid_study.sides) {
        finest.push_back(read_run(side.runs.front().file));
        finest.back().attributes["command"] = common.command;  // makes this page again, not only the finest pair
    }
    CompareOptions options;
    options.force = true;  // the methods may have different finest sizes
    Comparison pair = compare_records(std::move(finest), options);
    judge_by_sizes(pair, grid_study);
    if (const std::string banner = provisional_banner(harvest.unfinished); !banner.empty())
        pair.banners.insert(pair.banners.begin(), banner);
    const ReportFiles files = leaving_files([&] { return write_report(pair, out, grid_study_html(grid_study)); });
    say(common, grid_study_summary(grid_study) + "\nwritten: " + (out / "ladder.md").string() +
                    "\nreport: " + files.html.string() + "\n");
    write_json(common, grid_study_json(grid_study));
    return grid_study;
}

std::string not_agreeing(const GridStudy& grid_study) {
    if (grid_study.quantities.empty()) return "no quantity was judged";
    std::string others;
    for (const GridStudyQuantity& q : grid_study.quantities)
        for (const GridStudyDifference& d : q.differences()) {
            if (d.verdict == Verdict::agree) continue;
            const std::string who = q.pairs.empty() ? ""
                                                    : " (" + method_label(grid_study.sides[d.a].method) + ", " +
                                                          method_label(grid_study.sides[d.b].method) + ")";
            others += (others.empty() ? "" : ", ") + q.label + who + ": " + verdict_label(d.verdict);
        }
    return others;
}

}  // namespace tw::app
