#include "sph_solver/measure/run_watch.h"

#include <gtest/gtest.h>

#include <cmath>
#include <functional>

#include "base/errors.h"

namespace tw {
namespace run_watch_test {

TEST(RunWatch, EndsARunWhoseStepsHaveCollapsed) {
    RunWatch watch({});
    for (int k = 0; k < 1000; ++k) watch.note_step(0.1, 2e-6, 1e-3);  // small, and all the same it gets on
    const auto collapse = [&](int steps) {
        for (int k = 0; k < steps; ++k) watch.note_step(0.25, 9e-13, 1e-3);
    };
    collapse(150);
    watch.note_step(0.25, 1e-3, 1e-3);
    collapse(150);
    try {
        collapse(100);
        FAIL() << "it went on";
    } catch (const RunError& e) {
        EXPECT_NE(std::string(e.what()).find("collapsed to 9e-13 s at t = 0.25 s"), std::string::npos) << e.what();
    }
}

std::string cause_of(const std::function<void()>& watched) {
    try {
        watched();
    } catch (const RunError& e) { return e.what(); }
    return {};
}

TEST(RunWatch, EndsARunThatTakesTwentyTimesThePredictedSteps) {
    const auto run = [](double predicted, int steps) {
        return cause_of([=] {
            RunWatch watch({.duration = 1, .steps = predicted});
            for (int k = 0; k < steps; ++k) watch.note_step(1e-5 * k, k == 0 ? 1e-2 : 1e-5, 1e-2);
        });
    };
    EXPECT_EQ(run(0, 2000), "");  // a hundred steps like the first one, twenty times over
    EXPECT_NE(run(0, 2001).find("2e+03 steps have been taken by t = 0.02 s"), std::string::npos) << run(0, 2001);
    EXPECT_EQ(run(500, 10000), "");
    EXPECT_NE(run(500, 10001), "");
}

/// Two frames of a tank of 2 kg, in which a fall gives 3 m/s: 9 J.
RunRecord two_frames(const char* motion, double kinetic, double potential, double mass = 2) {
    RunRecord r;
    r.attributes["motion"] = motion;
    Table& t = r.table("samples");
    t.time = {0, 0.5};
    t.column("mass", "kg").values = {2, mass};
    t.column("kinetic_energy", "J").values = {0, kinetic};
    t.column("potential_energy", "J").values = {0, potential};
    return r;
}

TEST(RunWatch, EndsARunWhoseWaterHasEnergyFromNothing) {
    const auto cause = [](const char* motion, double kinetic, double potential) {
        return cause_of([&] { RunWatch({.speed = 3}).after_frame(two_frames(motion, kinetic, potential)); });
    };
    EXPECT_EQ(cause("none", 8, -8), "");  // it fell
    EXPECT_EQ(cause("none", 8, -4), "");  // a fault, and the validity checks's to tell
    EXPECT_NE(cause("none", 8, -3).find("5 J more are in the water at t = 0.5 s"), std::string::npos);
    EXPECT_NE(cause("none", std::nan(""), 0), "");
    EXPECT_EQ(cause("stream", 35, 0), "");
    EXPECT_NE(cause("stream", 37, 0).find("as if all of it had 6.083 m/s"), std::string::npos);
    EXPECT_EQ(cause_of([] { RunWatch({}).after_frame(two_frames("none", 1e9, 0)); }), "");  // no speed is known
}

TEST(RunWatch, EndsARunIntoWhichMoreWaterComesThanLeaves) {
    const auto cause = [](double mass) {
        return cause_of([&] { RunWatch({.speed = 3}).after_frame(two_frames("stream", 9, 0, mass)); });
    };
    EXPECT_EQ(cause(2.9), "");
    EXPECT_NE(cause(3.1).find("there are 3.1 kg of water"), std::string::npos);
}

}  // namespace run_watch_test
}  // namespace tw
