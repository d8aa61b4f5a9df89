// What runs teach of the machine's speed: neither a busy hour nor a short run's first seconds are kept for ever.
#include <gtest/gtest.h>
#include <unistd.h>

#include <cstdlib>
#include <filesystem>

#include "app/pace/machine_pace.h"
#include "base/atomic_file.h"
#include "record/this_machine.h"

namespace tw::app {
namespace pace_test {

class Pace : public testing::Test {
protected:
    std::filesystem::path cache = std::filesystem::temp_directory_path() / ("pace_" + std::to_string(::getpid()));
    std::string before = std::getenv("XDG_CACHE_HOME") ? std::getenv("XDG_CACHE_HOME") : "";

    void SetUp() override { setenv("XDG_CACHE_HOME", cache.c_str(), 1); }
    void TearDown() override {
        before.empty() ? unsetenv("XDG_CACHE_HOME") : setenv("XDG_CACHE_HOME", before.c_str(), 1);
        std::filesystem::remove_all(cache);
    }
    void write(const std::string& of_machine) const {
        std::filesystem::create_directories(cache / "twinwake");
        write_text_atomically(cache / "twinwake/pace.json", "{\"" + cpu_model() + "\": {" + of_machine + "}}");
    }
};

TEST_F(Pace, OneQuietRunEndsABusyHour) {
    write("\"sph\": [8, 9, 10, 9, 8], \"bench\": 7");
    EXPECT_EQ(machine_pace("sph"), 9);
    learn_pace("sph", 20, 22, true);
    EXPECT_DOUBLE_EQ(machine_pace("sph"), 1.1);
}

TEST_F(Pace, AShortRunEndsItToo) {
    write("\"bench\": 7");  // of doctor, in that hour
    learn_pace("sph", 2, 2.4, true);
    EXPECT_DOUBLE_EQ(machine_pace("sph"), 1.2);
    learn_pace("sph", 2, 8, true);
    EXPECT_DOUBLE_EQ(machine_pace("sph"), 1.2) << "a short run that is slow tells of its first seconds";
}

TEST_F(Pace, IsTheMedianOfNineRunsSoThatFourOddOnesDoNotMoveIt) {
    for (int k = 0; k < 5; ++k) learn_pace("sph", 20, 20, true);
    for (int k = 0; k < 4; ++k) learn_pace("sph", 20, 38, true);
    EXPECT_DOUBLE_EQ(machine_pace("sph"), 1);
    for (int k = 0; k < 2; ++k) learn_pace("sph", 20, 38, true);
    EXPECT_DOUBLE_EQ(machine_pace("sph"), 1.9) << "five of the last nine";
}

TEST_F(Pace, ThatNoProcessorHasComesFromTheTableAndTeachesNothing) {
    write("\"fvm\": [0.08, 1.4, 1.6], \"bench\": 1.7");
    EXPECT_DOUBLE_EQ(machine_pace("fvm"), 1.5) << "learned by an earlier version";
    learn_pace("fvm", 100, 12, true);
    EXPECT_DOUBLE_EQ(machine_pace("fvm"), 1.5);
    learn_pace("fvm", 20, 26, true);
    EXPECT_DOUBLE_EQ(machine_pace("fvm"), 1.4);
}

TEST_F(Pace, ARunBesideOthersTeachesNothing) {
    learn_pace("sph", 20, 25, true);
    for (int k = 0; k < 5; ++k) learn_pace("sph", 20, 200, false);
    EXPECT_DOUBLE_EQ(machine_pace("sph"), 1.25);
    for (int k = 0; k < 5; ++k) learn_pace("sph", 20, 40, true);
    EXPECT_DOUBLE_EQ(machine_pace("sph"), 2) << "slow runs alone on the machine do: the scenes are others";
}

}  // namespace pace_test
}  // namespace tw::app
