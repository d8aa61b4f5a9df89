#include "sph_solver/measure/run_watch.h"

#include <gtest/gtest.h>

#include "base/errors.h"

namespace tw {
namespace run_watch_test {

TEST(RunWatch, EndsARunWhoseStepsHaveCollapsed) {
    RunWatch watch;
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

}  // namespace run_watch_test
}  // namespace tw
