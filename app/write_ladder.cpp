#include "app/write_ladder.h"

#include <algorithm>

#include "app/output.h"
#include "base/atomic_file.h"

namespace tw::app {

namespace fs = std::filesystem;

void LadderHarvest::take(RunRecord record, const fs::path& file) {
    LadderRun run = ladder_run(std::move(record));
    auto& [spacing, finest_file] = finest.try_emplace(run.method, run.spacing, file).first->second;
    if (run.spacing <= spacing) spacing = run.spacing, finest_file = file;
    runs.push_back(std::move(run));
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

void write_ladder(const LadderHarvest& harvest, const std::vector<RunRecord>& measured, const fs::path& out,
                  const Common& common) {
    CompareOptions options;
    Ladder ladder = build_ladder(harvest.runs, harvest.variations, options.agree_within, measured);
    ladder.left_out = harvest.left_out;
    const std::string json = ladder_json(ladder);
    fs::create_directories(out);
    write_text_atomically(out / "ladder.md", ladder_text(ladder));
    write_text_atomically(out / "ladder.json", json);
    for (std::size_t k = 0; k < ladder.sides.size(); ++k)
        write_text_atomically(out / ("ladder_" + ladder.sides[k].method + ".csv"), ladder_csv(ladder, k));
    std::vector<RunRecord> finest;
    for (const LadderSide& side : ladder.sides) {
        finest.push_back(read_record(harvest.finest.at(side.method).second));
        finest.back().attributes["command"] = common.command;  // makes this page again, not only the finest pair
    }
    options.force = true;  // the methods may have different finest sizes
    const ReportFiles files = write_report(compare_records(std::move(finest), options), out, ladder_html(ladder));
    std::string verdicts;
    for (const LadderQuantity& q : ladder.quantities) verdicts += ladder_sentence(q) + "\n";
    say(common,
        "\n" + verdicts + "\nwritten: " + (out / "ladder.md").string() + "\nreport: " + files.html.string() + "\n");
    write_json(common, json);
}

}  // namespace tw::app
