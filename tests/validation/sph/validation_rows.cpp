// Judges a finished run for docs/validation.md and prints the rows in Markdown.
//
//   validation_rows JUDGE scene.toml record.h5 [table.csv [second.csv]]
//
// JUDGE: still, buoyancy, channel, front, measured_front, wedge, spheric2, entry, sloshing, cubes, waves. Any method's
// record. Exit status 0 when every row passes, 1 when one does not, 2 for wrong usage.
#include <cstdio>
#include <exception>
#include <string>

#include "judges.h"

int main(int argc, char** argv) {
    using namespace tw;
    using namespace tw::test;
    if (argc < 4) {
        std::fputs(
            "usage: validation_rows "
            "still|buoyancy|channel|front|measured_front|wedge|spheric2|entry|sloshing|cubes|waves "
            "scene.toml record.h5 [table.csv [second.csv]]\n",
            stderr);
        return 2;
    }
    try {
        const std::string judge = argv[1];
        const Scene scene = read_scene(argv[2]);
        const RunRecord record = read_record(argv[3]);
        const std::filesystem::path table = argc > 4 ? argv[4] : "", second = argc > 5 ? argv[5] : "";
        const double half = 0.5 * record.numbers.at("duration");
        std::vector<Row> rows;
        if (judge == "still")
            rows = judge_still_water(scene, record, half);
        else if (judge == "buoyancy")
            rows = judge_buoyancy(scene, record, half);
        else if (judge == "channel")
            rows = judge_channel(scene, record, half);
        else if (judge == "front")
            rows = judge_dam_break_front(scene, record, table);
        else if (judge == "measured_front")
            rows = judge_measured_front(scene, record, table);
        else if (judge == "wedge")
            rows = judge_wedge_drop(scene, record, table);
        else if (judge == "spheric2")
            rows = judge_spheric2(scene, record, table);
        else if (judge == "entry")
            rows = judge_entry(scene, record, table);
        else if (judge == "sloshing")
            rows = judge_sloshing(scene, record, table, second);
        else if (judge == "cubes")
            rows = judge_cubes(scene, record, table);
        else if (judge == "waves")
            rows = judge_box_in_waves(scene, record, table);
        else {
            std::fprintf(stderr, "validation_rows: unknown judge '%s'\n", argv[1]);
            return 2;
        }
        bool all = record.state == "finished";
        for (const Row& row : rows) {
            all = all && row.passes();
            std::printf("| %s | %s | %s | %.3g %s | %.3g | %s |\n", scene.title.c_str(),
                        record.attributes.at("method").c_str(), row.quantity.c_str(), row.value, row.unit.c_str(),
                        row.limit, row.passes() ? "pass" : "**fail**");
        }
        return all ? 0 : 1;
    } catch (const std::exception& e) {
        std::fprintf(stderr, "validation_rows: %s\n", e.what());
        return 2;
    }
}
