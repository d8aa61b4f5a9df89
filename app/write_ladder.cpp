#include "app/write_ladder.h"

#include <algorithm>

#include "app/output.h"

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

Ladder write_ladder(const LadderHarvest& harvest, const std::vector<RunRecord>& measured, const fs::path& out,
                    const Common& common) {
    CompareOptions options;
    Ladder ladder = build_ladder(harvest.runs, harvest.variations, options.agree_within, measured);
    ladder.left_out = harvest.left_out;
    const std::string json = ladder_json(ladder);
    make_folder(out);
    write_file(out / "ladder.md", ladder_text(ladder));
    write_file(out / "ladder.json", json);
    for (std::size_t k = 0; k < ladder.sides.size(); ++k)
        write_file(out / ("ladder_" + ladder.sides[k].method + ".csv"), ladder_csv(ladder, k));
    std::vector<RunRecord> finest;
    for (const LadderSide& side : ladder.sides) {
        finest.push_back(read_record(side.runs.front().file));
        finest.back().attributes["command"] = common.command;  // makes this page again, not only the finest pair
    }
    options.force = true;  // the methods may have different finest sizes
    const Comparison pair = compare_records(std::move(finest), options);
    const ReportFiles files = leaving_files([&] { return write_report(pair, out, ladder_html(ladder)); });
    say(common, ladder_summary(ladder) + "\nwritten: " + (out / "ladder.md").string() +
                    "\nreport: " + files.html.string() + "\n");
    write_json(common, json);
    return ladder;
}

}  // namespace tw::app
