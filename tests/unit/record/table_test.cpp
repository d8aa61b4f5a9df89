#include "record/table.h"

#include <gtest/gtest.h>

#include <cmath>

#include "record/run_record.h"

namespace tw {
namespace table_test {

TEST(Table, ColumnsThatBeginLateOrMissARowDoNotKnowTheirValueThere) {
    Table t;
    t.set(t.append(0.1), "fx", "N", 1);
    const std::size_t row = t.append(0.2);
    t.set(row, "fz", "N", 2);
    t.set(t.append(0.3), "fx", "N", 3);
    ASSERT_EQ(t.time, (std::vector<double>{0.1, 0.2, 0.3}));
    const std::vector<double>&fx = t.find("fx")->values, &fz = t.find("fz")->values;
    EXPECT_EQ(fx[0], 1);
    EXPECT_TRUE(std::isnan(fx[1]));
    EXPECT_EQ(fx[2], 3);
    EXPECT_TRUE(std::isnan(fz[0]));
    EXPECT_EQ(fz[1], 2);
    ASSERT_EQ(fz.size(), 3u) << "every column is as long as the table's time";
    EXPECT_TRUE(std::isnan(fz[2]));
}

TEST(RunRecord, RewoundKeepsWhatStandsAtOrBeforeThatTime) {
    RunRecord r;
    for (const double time : {0.1, 0.2, 0.3}) {
        Table& forces = r.table("forces");
        forces.set(forces.append(time), "fx", "N", 10 * time);
        r.frames.push_back({time, {}});
    }
    r.table("samples").append(0.25);
    r.rewind(0.2);
    EXPECT_EQ(r.table("forces").time, (std::vector<double>{0.1, 0.2}));
    EXPECT_EQ(r.series("forces", "fx")->values, (std::vector<double>{1, 2}));
    EXPECT_TRUE(r.table("samples").time.empty());
    ASSERT_EQ(r.frames.size(), 2u);
    EXPECT_EQ(r.frames.back().time, 0.2);
}

}  // namespace table_test
}  // namespace tw
