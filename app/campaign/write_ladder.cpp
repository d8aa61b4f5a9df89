#include "app/campaign/write_ladder.h"

#include <algorithm>

#include "app/arguments/output.h"
#include "app/campaign/report_every.h"
#include "app/runs/read_run.h"
#include "compare/ladder/judge_by_sizes.h"
#include "compare/ladder/ladder_report.h"
#include "compare/report/numbers.h"
#include "methods/methods.h"

namespace tw::app {

namespace fs = std::filesystem;

void LadderHarvest::take(RunRecord record, const fs::path& file) {
    runs.push_back(ladder_run(std::move(record)));
    runs.back().file = file;
}

void LadderHarvest::drop_lone_variations() {
    std::erase_if(variations, [&](const LadderVariation& v) {
        return std::ranges::none_of(runs, [&](const LadderRun& r) { return same_rung(r, v.run); });
    });
}

std::vector<RunRecord> measured_records(const std::vector<fs::path>& sources) {
    std::vector<RunRecord> records;
    for (const fs::path& source : sources)
        records.push_back(read_record(fs::is_directory(source) ? source / "record.h5" : source));
    return records;
}

Ladder ladder_of(const LadderHarvest& harvest, const std::vector<RunRecord>& measured) {
    Ladder ladder = build_ladder(harvest.runs, harvest.variations, CompareOptions{}.agree_within, measured);
    ladder.left_out = harvest.left_out;
    return ladder;
}

void write_tables(const Ladder& ladder, const fs::path& out) {
    make_folder(out);
    write_file(out / "ladder.md", ladder_text(ladder));
    write_file(out / "ladder.json", ladder_json(ladder));
    for (std::size_t k = 0; k < ladder.sides.size(); ++k)
        write_file(out / ("ladder_" + ladder.sides[k].method + ".csv"), ladder_csv(ladder, k));
}

Ladder report_ladder(const LadderHarvest& harvest, const std::vector<RunRecord>& measured, const fs::path& out,
                     const Common& common) {
    Ladder ladder = ladder_of(harvest, measured);
    write_tables(ladder, out);
    std::vector<RunRecord> finest;
    for (const LadderSide& side : ladder.sides) {
        finest.push_back(read_run(side.runs.front().file));
        finest.back().attributes["command"] = common.command;  // makes this page again, not only the finest pair
    }
    CompareOptions options;
    options.force = true;  // the methods may have different finest sizes
    Comparison pair = compare_records(std::move(finest), options);
    judge_by_sizes(pair, ladder);
    if (const std::string banner = provisional_banner(harvest.unfinished); !banner.empty())
        pair.banners.insert(pair.banners.begin(), banner);
    const ReportFiles files = leaving_files([&] { return write_report(pair, out, ladder_html(ladder)); });
    say(common, ladder_summary(ladder) + "\nwritten: " + (out / "ladder.md").string() +
                    "\nreport: " + files.html.string() + "\n");
    write_json(common, ladder_json(ladder));
    return ladder;
}

std::string not_agreeing(const Ladder& ladder) {
    if (ladder.quantities.empty()) return "no quantity was judged";
    std::string others;
    for (const LadderQuantity& q : ladder.quantities)
        for (const LadderDifference& d : q.differences()) {
            if (d.verdict == Verdict::agree) continue;
            const std::string who = q.pairs.empty() ? ""
                                                    : " (" + method_label(ladder.sides[d.a].method) + ", " +
                                                          method_label(ladder.sides[d.b].method) + ")";
            others += (others.empty() ? "" : ", ") + q.label + who + ": " + verdict_label(d.verdict);
        }
    return others;
}

}  // namespace tw::app
