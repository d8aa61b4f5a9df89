// The picture of the sizes of particles and cells: what it draws, and that it can be read.
#include "compare/report/resolution_picture.h"

#include <gtest/gtest.h>

#include <cmath>

#include "compare/checks/checks.h"
#include "compare/report/comparison_tables.h"
#include "compare/report/svg_plot.h"
#include "meshes/generate.h"
#include "record/recorded_checks.h"

namespace tw {
namespace resolution_picture_test {

TEST(LabelPlaces, NeverOverlapNorLeaveTheFrame) {
    const DrawnBox frame{0, 0, 400, 200};
    std::vector<LabelBox> boxes;
    for (int k = 0; k < 6; ++k)  // one in another, the upper edges nearly on each other
        boxes.push_back({{20.0 * k, 3.0 * k, 400 - 25.0 * k, 190 - 12.0 * k}, 45});
    boxes.push_back({{200, 100, 206, 106}, 45});  // smaller than its label
    const auto places = label_places(boxes, frame);
    for (std::size_t i = 0; i < places.size(); ++i) {
        ASSERT_TRUE(places[i]) << i;
        EXPECT_TRUE(frame.holds(*places[i])) << i;
        for (std::size_t j = 0; j < i; ++j) EXPECT_FALSE(places[i]->overlaps(*places[j])) << i << " " << j;
    }
}

TEST(LabelPlaces, WhereThereIsNoRoomThereIsNoLabel) {
    const auto places = label_places({{{0, 0, 30, 10}, 60}}, {0, 0, 30, 10});
    EXPECT_FALSE(places[0]);
}

TEST(Silhouette, IsWhatTheTrianglesCover) {
    Surface two = box_surface({Vec3(0, 0, 0), Vec3(2, 1, 1)});
    const Surface above = box_surface({Vec3(1, 3, 4), Vec3(2, 4, 5)});
    const int n = static_cast<int>(two.points.size());
    two.points.insert(two.points.end(), above.points.begin(), above.points.end());
    for (auto t : above.triangles) two.triangles.push_back({t[0] + n, t[1] + n, t[2] + n});
    const PlotShadow side = silhouette(two, 2, 0.25, {-1, 4}), plan = silhouette(two, 1, 0.25, {-1, 4});
    double area = 0, seen_from_above = 0;
    for (std::size_t i = 0; i < side.x.size(); ++i)
        if (side.x[i] < 2) area += 0.25 * (side.high[i] - side.low[i]);
    for (std::size_t i = 0; i < plan.x.size(); ++i)
        if (plan.x[i] < 2) seen_from_above += 0.25 * (plan.high[i] - plan.low[i]);
    EXPECT_NEAR(area, 3, 1e-12);  // 2 x 1 and 1 x 1, apart from each other
    EXPECT_NEAR(seen_from_above, 3, 1e-12);
}

TEST(Silhouette, EndsAtThePicture) {
    Surface far = box_surface({Vec3(0, 0, 0), Vec3(2, 1, 1)});
    for (Vec3& p : far.points)
        if (p.x() > 1) p.x() = 1e30;
    const PlotShadow side = silhouette(far, 2, 0.25, {-1, 4});
    ASSERT_FALSE(side.x.empty());
    EXPECT_GE(side.x.front(), 0);
    EXPECT_EQ(side.x.back(), 4);
}

RunRecord run_of(double coarsest, const std::vector<ResolvedBox>& finer) {
    RunRecord r;
    r.attributes = {{"motion", "stream"}, {"symmetry_factor", "2"}};
    r.numbers = {{"dimensions", 3}};
    r.hull = box_surface({Vec3(-1, 0, -0.2), Vec3(1, 0.5, 0.5)});
    r.resolution = resolution_within({coarsest, {Vec3(-4, 0, -2), Vec3(4, 2, 1)}}, finer);
    return r;
}

TEST(ResolutionPicture, ShowsEverySizeOfEveryRunFromTheSideAndFromAbove) {
    const std::vector<RunRecord> runs{run_of(0.2, {{0.1, {Vec3(-2, 0, -1), Vec3(2, 1, 1)}}}),
                                      run_of(0.4, {{0.05, {Vec3(-1.5, 0, -0.6), Vec3(1.5, 0.8, 0.6)}}})};
    const std::string picture = resolution_picture(runs, {"particles", "cells"});
    const auto count = [&](const std::string& part) {
        std::size_t n = 0;
        for (std::size_t at = picture.find(part); at != std::string::npos; at = picture.find(part, at + 1)) ++n;
        return n;
    };
    for (const char* size : {">0.2 m<", ">0.1 m<", ">0.4 m<", ">0.05 m<"}) EXPECT_EQ(count(size), 2u) << size;
    for (const char* name : {">particles<", ">cells<"}) EXPECT_EQ(count(name), 2u) << name;
    EXPECT_EQ(count("class=\"box s0"), 4u);
    EXPECT_EQ(count("class=\"shadow"), 2u);
    EXPECT_NE(picture.find("z [m]"), std::string::npos);
    EXPECT_NE(picture.find("y [m]"), std::string::npos);
}

TEST(ResolutionPicture, OfOneSizeIsNone) {
    EXPECT_EQ(resolution_picture(std::vector<RunRecord>{run_of(0.2, {})}, {"sph"}), "");
}

// The zones of a stream are drawn where there is one size too.
TEST(ResolutionPicture, ShowsWhatLiesBetweenForcingZones) {
    RunRecord run = run_of(0.2, {});
    for (const auto& [name, at] : {std::pair{"x_min", -1.0}, {"x_max", 1.0}, {"y_min", 0.0}, {"y_max", 0.5}})
        run.numbers[std::string("undamped_") + name] = at;
    const std::string picture = resolution_picture(std::vector<RunRecord>{run}, {"sph"});
    EXPECT_NE(picture.find("outside the rectangle: forcing zones"), std::string::npos);
    std::size_t outlines = 0;
    for (std::size_t at = picture.find("\"outline\""); at != std::string::npos;
         at = picture.find("\"outline\"", at + 1))
        ++outlines;
    EXPECT_EQ(outlines, 2u) << "from the side and from above";
}

TEST(LevelsTable, HasARowForEverySizeAndNoneForOneSize) {
    Comparison c;
    c.names = {"sph"};
    c.sources.resize(1);
    EXPECT_TRUE(levels_table(c).empty());
    for (const std::size_t k : {0u, 1u}) {
        Table& t = c.sources[0].table(level_table(k));
        t.time = {0.1, 0.2, 0.3};
        t.column("spacing", "m").values.assign(3, k == 0 ? 0.2 : 0.1);
        if (k == 1) t.column("mass_drift", "%").values = {0.2, -1.5, 0.4};
        c.sources[0].numbers[level_table(k) + "_seconds"] = k == 0 ? 10 : 30;
        c.sources[0].numbers[level_table(k) + "_edge_seconds"] = k == 0 ? 0 : 10;
    }
    const ReportTable table = levels_table(c);
    ASSERT_EQ(table.rows.size(), 2u);
    EXPECT_EQ(table.rows[1].cells[1].number, 0.1);
    EXPECT_EQ(table.rows[1].cells[10].number, 0.4);
    EXPECT_EQ(table.rows[1].cells[11].number, 1.5);
    EXPECT_EQ(table.rows[1].cells[12].number, 60);
    EXPECT_EQ(table.rows[1].cells[13].number, 20);
    EXPECT_TRUE(std::isnan(table.rows[0].cells[10].number));  // the coarsest has no zone
}

// A drift of a zone's mass is told, but nothing was broken: a reader sees it from the other lines.
TEST(ChecksTable, TellsAWarningFromWhatIsNotMet) {
    RunRecord r;
    note_worst(r, {mass_drift_line, "%", 1.4, 0.5, 0.2});
    note_worst(r, {"particles lost", "-", 3, 0, 0.2});
    const ReportTable table = checks_table(checks_of(r, "sph"), true);
    const auto badge_of = [&](const std::string& line) {
        for (const ReportRow& row : table.rows)
            if (row.cells[0].text == line) return row.cells[5].text;
        return std::string();
    };
    EXPECT_EQ(badge_of(mass_drift_line), "warning");
    EXPECT_EQ(badge_of("particles lost"), "not met");
}

}  // namespace resolution_picture_test
}  // namespace tw
