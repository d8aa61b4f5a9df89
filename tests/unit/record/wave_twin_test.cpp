// The twin of a run in waves: which record counts as one.
#include "record/wave_twin.h"
#include "record/hull_motion.h"

#include <gtest/gtest.h>

namespace tw::test {
namespace wave_twin_of_record_test {

RunRecord record_of(const std::string& state, double near_hull) {
    RunRecord r;
    r.state = state;
    r.numbers = {{"near_hull", near_hull}, {"duration", 3}, {"wave_period", 0.8}};
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
    r.attributes[std::string(wave_twin_of_run)] = "abc";
    return r;
}
/// Why it does not count; empty: it does.
std::string refused(const RunRecord& of, const RunRecord& twin) {
    RunRecord record = of;
    take_wave_twin(record, twin);
    const bool taken = record.series(std::string(empty_twin_table), gauge_of_empty_twin("box")) != nullptr;
    const auto why = record.attributes.find(std::string(no_wave_twin));
    EXPECT_EQ(taken, why == record.attributes.end());
    return taken ? "" : why->second;
}

TEST(EmptyTwinOfARecord, CountsOfThisVeryRunAlone) {
    EXPECT_EQ(refused(with_bodies(), twin()), "");
    EXPECT_EQ(refused(with_bodies(), twin(0.02)), "it has near_hull = 0.02 m and the run with bodies 0.01 m");
    RunRecord other = twin();
    other.attributes[std::string(wave_twin_of_run)] = "abd";
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

TEST(CalmTwinOfARecord, GivesItsForcesAndMotion) {
    RunRecord record = with_bodies(), calm = twin();
    calm.numbers.erase("wave_period");
    take_wave_twin(record, calm);
    EXPECT_EQ(record.attributes[std::string(no_wave_twin)], "it has no forces");
    Table &forces = calm.table("forces"), &motion = calm.table(hull_motion_table);
    forces.set(forces.append(0.5), "fx", "N", 12);
    motion.set(motion.append(0.5), "trim", "deg", 4);
    record = with_bodies();
    take_wave_twin(record, calm);
    ASSERT_TRUE(record.series(std::string(calm_forces_table), "fx"));
    EXPECT_EQ(record.series(std::string(calm_motion_table), "trim")->values[0], 4);
    EXPECT_FALSE(record.series(std::string(empty_twin_table), "without_box")) << "levels of calm water are no wave";
    calm.numbers["duration"] = 2;
    record = with_bodies();
    take_wave_twin(record, calm);
    EXPECT_EQ(record.attributes[std::string(no_wave_twin)], "it ends at 2 s and the run in waves at 3 s");
}

}  // namespace wave_twin_of_record_test
}  // namespace tw::test
