// The empty twin of a run: which record counts as one.
#include "record/empty_twin.h"

#include <gtest/gtest.h>

namespace tw::test {
namespace empty_twin_of_record_test {

RunRecord record_of(const std::string& state, double near_hull) {
    RunRecord r;
    r.state = state;
    r.numbers = {{"near_hull", near_hull}, {"duration", 3}};
    Table& height = r.table("height");
    height.set(height.append(0.5), "without_box", "m", 0.02);
    return r;
}
RunRecord with_bodies() {
    RunRecord r = record_of("finished", 0.01);
    r.attributes["run_hash"] = "abc";
    return r;
}
RunRecord twin(double near_hull = 0.01) {
    RunRecord r = record_of("finished", near_hull);
    r.attributes[std::string(empty_twin_of_run)] = "abc";
    return r;
}
/// Why it does not count; empty: it does.
std::string refused(const RunRecord& of, const RunRecord& twin) {
    RunRecord record = of;
    take_empty_twin(record, twin);
    const bool taken = record.series(std::string(empty_twin_table), gauge_of_empty_twin("box")) != nullptr;
    const auto why = record.attributes.find(std::string(no_empty_twin));
    EXPECT_EQ(taken, why == record.attributes.end());
    return taken ? "" : why->second;
}

TEST(EmptyTwinOfARecord, CountsOfThisVeryRunAlone) {
    EXPECT_EQ(refused(with_bodies(), twin()), "");
    EXPECT_EQ(refused(with_bodies(), twin(0.02)), "it has near_hull = 0.02 m and the run with bodies 0.01 m");
    RunRecord other = twin();
    other.attributes[std::string(empty_twin_of_run)] = "abd";
    EXPECT_EQ(refused(with_bodies(), other), "it is of another scene or of other numerics");
    RunRecord nameless = with_bodies(), no_twin = twin();
    nameless.attributes.clear(), no_twin.attributes.clear();
    EXPECT_EQ(refused(nameless, no_twin), "it is of another scene or of other numerics");
    RunRecord running = twin();
    running.state = "stopped";
    EXPECT_EQ(refused(with_bodies(), running), "it is not finished");
    RunRecord shorter = twin();
    shorter.numbers["duration"] = 2;
    EXPECT_EQ(refused(with_bodies(), shorter), "it ends at 2 s and the run with bodies at 3 s");
    RunRecord dry = twin();
    dry.tables.clear();
    EXPECT_EQ(refused(with_bodies(), dry), "it has no levels");
}

}  // namespace empty_twin_of_record_test
}  // namespace tw::test
