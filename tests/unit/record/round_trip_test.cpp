#include <gtest/gtest.h>

#include <cstring>

#include "base/atomic_file.h"
#include "base/errors.h"
#include "tests/unit/record/example_record.h"

namespace tw {
namespace round_trip_test {

template <class T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && (a.empty() || std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0);
}

TEST(RunRecordFile, GivesBackEveryFieldBitForBit) {
    const ScratchFolder folder;
    const RunRecord out = example_record();
    write_record(folder / "record.h5", out);
    const RunRecord in = read_record(folder / "record.h5");

    EXPECT_EQ(in.attributes, out.attributes);
    EXPECT_EQ(in.scene_text, out.scene_text);
    ASSERT_EQ(in.numbers.size(), out.numbers.size());
    for (const auto& [name, value] : out.numbers)
        EXPECT_EQ(std::memcmp(&in.numbers.at(name), &value, sizeof value), 0) << name;
    ASSERT_EQ(in.tables.size(), out.tables.size());
    for (const auto& [name, table] : out.tables) {
        const Table& got = in.tables.at(name);
        EXPECT_EQ(got.name, name);
        EXPECT_TRUE(same_bits(got.time, table.time)) << name;
        ASSERT_EQ(got.columns.size(), table.columns.size()) << name;
        for (std::size_t c = 0; c < table.columns.size(); ++c) {
            EXPECT_EQ(got.columns[c].name, table.columns[c].name);  // order is kept too
            EXPECT_EQ(got.columns[c].unit, table.columns[c].unit);
            EXPECT_TRUE(same_bits(got.columns[c].values, table.columns[c].values)) << table.columns[c].name;
        }
    }
    EXPECT_EQ(in.raster.origin, out.raster.origin);
    EXPECT_EQ(in.raster.voxel, out.raster.voxel);
    EXPECT_EQ(in.raster.count, out.raster.count);
    ASSERT_EQ(in.frames.size(), out.frames.size());
    for (std::size_t f = 0; f < out.frames.size(); ++f) {
        EXPECT_EQ(in.frames[f].time, out.frames[f].time);
        EXPECT_EQ(in.frames[f].water, out.frames[f].water);
    }
    EXPECT_EQ(in.hull.points, out.hull.points);
    EXPECT_EQ(in.hull.triangles, out.hull.triangles);
    EXPECT_TRUE(same_bits(in.hull_pressure, out.hull_pressure));
    EXPECT_TRUE(same_bits(in.hull_wet, out.hull_wet));
    ASSERT_EQ(in.bodies.size(), 2u);
    for (std::size_t b = 0; b < 2; ++b) {
        EXPECT_EQ(in.bodies[b].table, out.bodies[b].table);
        EXPECT_EQ(in.bodies[b].centre, out.bodies[b].centre);
        EXPECT_EQ(in.bodies[b].surface.points, out.bodies[b].surface.points);
        EXPECT_EQ(in.bodies[b].surface.triangles, out.bodies[b].surface.triangles);
    }
    ASSERT_EQ(in.phases.size(), 2u);
    EXPECT_EQ(in.phases[1].name, "solving");
    EXPECT_EQ(in.phases[1].wall, 100.5);
    EXPECT_EQ(in.phases[1].cpu, 199.75);
    EXPECT_EQ(in.peak_memory, out.peak_memory);
    EXPECT_EQ(in.elements, out.elements);
    EXPECT_EQ(in.steps, out.steps);
    ASSERT_EQ(in.validity_checks.size(), 2u);
    EXPECT_EQ(in.validity_checks[0].name, "Mach number");
    EXPECT_EQ(in.validity_checks[0].value, 0.31);
    EXPECT_EQ(in.validity_checks[0].limit, 1);
    EXPECT_EQ(in.validity_checks[0].time, 0.25);
    EXPECT_EQ(in.validity_checks[0].place, Vec3(1, 2, -0.5));
    EXPECT_EQ(in.validity_checks[1].unit, "-");
    EXPECT_TRUE(std::isnan(in.validity_checks[1].place.x()));
    ASSERT_EQ(in.resolution.size(), 2u);
    EXPECT_EQ(in.resolution[0].size, 0.4);
    EXPECT_EQ(in.resolution[1].box.min, out.resolution[1].box.min);
    EXPECT_EQ(in.resolution[1].box.max, out.resolution[1].box.max);
    ASSERT_EQ(in.effects.size(), 2u);
    EXPECT_EQ(in.effects[0].name, "air");
    EXPECT_FALSE(in.effects[0].on);
    EXPECT_TRUE(in.effects[0].forced);
    EXPECT_EQ(in.effects[0].reason, out.effects[0].reason);
    EXPECT_EQ(in.effects[0].influence, out.effects[0].influence);
    EXPECT_EQ(in.effects[0].cost, 0.4);
    ASSERT_EQ(in.effects[0].bounds.size(), 2u);
    EXPECT_TRUE(in.effects[1].bounds.empty());
    EXPECT_EQ(in.effects[0].bounds[0].of, "arrival");
    EXPECT_EQ(in.effects[0].bounds[0].below, 0);
    EXPECT_EQ(in.effects[0].bounds[0].above, 0.14);
    EXPECT_EQ(in.effects[0].bounds[1].unit, "Pa");
    EXPECT_EQ(in.effects[0].bounds[1].source, "Ma^2");
    EXPECT_EQ(in.effects[0].bounds[1].elements, "particles");
    EXPECT_EQ(in.state, "stopped");
    EXPECT_EQ(in.reason, "the user asked");
}

TEST(RunRecordFile, WritingTwiceGivesTheSameBytes) {
    const ScratchFolder folder;
    write_record(folder / "a.h5", example_record());
    write_record(folder / "b.h5", read_record(folder / "a.h5"));
    EXPECT_EQ(read_text(folder / "a.h5"), read_text(folder / "b.h5"));
}

TEST(RunRecordFile, AnEmptyRecordIsStillARecord) {
    const ScratchFolder folder;
    write_record(folder / "record.h5", RunRecord{});
    const RunRecord in = read_record(folder / "record.h5");
    EXPECT_EQ(in.state, "running");
    EXPECT_TRUE(in.tables.empty());
    EXPECT_TRUE(in.frames.empty());
}

TEST(RunRecordFile, AColumnShorterThanItsTimesIsRefusedAndTheOldFileStays) {
    const ScratchFolder folder;
    const RunRecord good = example_record();
    write_record(folder / "record.h5", good);
    RunRecord bad = good;
    bad.tables["forces"].columns[1].values.pop_back();
    EXPECT_THROW(write_record(folder / "record.h5", bad), RunError);
    EXPECT_EQ(read_record(folder / "record.h5").tables.at("forces").columns.size(),
              good.tables.at("forces").columns.size());
}

TEST(Tables, ColumnIsMadeOnceAndFound) {
    Table t;
    t.column("fx", "N").values.push_back(3);
    EXPECT_EQ(t.column("fx", "N").values.size(), 1u);
    EXPECT_EQ(t.columns.size(), 1u);
    EXPECT_EQ(t.find("fy"), nullptr);
    RunRecord r;
    r.table("forces") = t;
    ASSERT_NE(r.series("forces", "fx"), nullptr);
    EXPECT_EQ(r.series("samples", "fx"), nullptr);
}

}  // namespace round_trip_test
}  // namespace tw
