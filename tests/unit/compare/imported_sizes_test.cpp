// An imported record that gives the spacing at the hull and the water's raster is a size of a grid study like any run.
#include <gtest/gtest.h>

#include <algorithm>

#include "base/errors.h"
#include "compare/grid_study/grid_study.h"
#include "compare/grid_study/grid_study_report.h"
#include "tests/unit/compare/synthetic_pair.h"

namespace tw {
namespace imported_sizes_test {

RunRecord run_of(const std::string& method, double spacing, double splash) {
    RunRecord r = synthetic_run({.method = method,
                                 .noise = 2,
                                 .duration = 1.4,
                                 .step = 4e-3,
                                 .splash = splash,
                                 .seed = static_cast<unsigned>(1000 * spacing) + (method == "sph" ? 1 : 2)});
    r.numbers["near_hull"] = spacing;
    return r;
}

/// What twinwake import makes of another code's run: no solver's numbers, and the water poured into the scene's voxels.
RunRecord imported(double spacing, double splash) {
    RunRecord r = run_of("other code", spacing, splash);
    r.attributes["import_kind"] = "csv", r.attributes["imported_from"] = "other.csv";
    r.hull_pressure.clear(), r.hull_wet.clear(), r.phases.clear(), r.effects.clear();
    r.elements = r.steps = 0;
    return r;
}

GridStudy grid_study_of(const std::vector<RunRecord>& records) {
    std::vector<GridStudyRun> runs;
    for (const RunRecord& r : records) runs.push_back(grid_study_run(r));
    return build_grid_study(std::move(runs));
}

const GridStudyQuantity* find(const GridStudy& grid_study, const std::string& name) {
    const auto q = std::ranges::find(grid_study.quantities, name, &GridStudyQuantity::name);
    return q == grid_study.quantities.end() ? nullptr : &*q;
}

TEST(ImportedSizes, AreASideOfTheGridStudyWithTheirSplashAndAVerdict) {
    const GridStudy grid_study =
        grid_study_of({imported(0.04, 0.5), run_of("sph", 0.04, 0.3), imported(0.08, 0.52), run_of("sph", 0.08, 0.28)});
    ASSERT_EQ(grid_study.sides.size(), 2u);
    EXPECT_EQ(grid_study.sides[1].method, "other code");
    EXPECT_EQ(grid_study.sides[1].runs.size(), 2u);
    const GridStudyQuantity* splash = find(grid_study, "splash_sheet_height");
    ASSERT_NE(splash, nullptr);
    ASSERT_EQ(splash->values[1].levels.size(), 2u);
    EXPECT_EQ(splash->values[1].levels.front().h, 0.04);
    EXPECT_GT(splash->difference, 0.1);
    EXPECT_GT(splash->values[1].estimate.uncertainty, 0);
    EXPECT_TRUE(splash->verdict == Verdict::differ || splash->verdict == Verdict::undecided)
        << to_string(splash->verdict) << splash->reason;
    EXPECT_NE(find(grid_study, "lift")->verdict, Verdict::not_comparable);
    EXPECT_NE(grid_study_text(grid_study).find("| other code"), std::string::npos);
}

TEST(ImportedSizes, WithoutASpacingOrARasterSayWhatIsMissing) {
    RunRecord bare = imported(0.04, 0.5);
    bare.numbers.erase("near_hull");
    try {
        grid_study_of({bare});
        FAIL() << "a size without a size";
    } catch (const InputError& e) {
        EXPECT_NE(std::string(e.what()).find("other code record has no spacing"), std::string::npos) << e.what();
    }
    RunRecord dry = imported(0.04, 0.5);
    dry.frames.clear();
    const GridStudy grid_study = grid_study_of({dry, run_of("sph", 0.04, 0.3)});
    const GridStudyQuantity* splash = find(grid_study, "splash_sheet_height");
    ASSERT_NE(splash, nullptr);
    EXPECT_EQ(splash->verdict, Verdict::not_comparable);
    EXPECT_NE(splash->reason.find("other code: no size has a mean; at 0.04 m: not measured"), std::string::npos)
        << splash->reason;
}

}  // namespace imported_sizes_test
}  // namespace tw
