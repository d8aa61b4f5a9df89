#include "base/side_thread.h"

#include <gtest/gtest.h>

#include <atomic>
#include <future>
#include <stdexcept>
#include <string>

namespace tw {
namespace side_thread_test {

TEST(SideThread, WorksWhileTheCallerGoesOnOnePieceAfterTheOther) {
    SideThread side;
    std::promise<void> gone_on;
    std::string order;
    side.begin([&, later = gone_on.get_future().share()] {
        later.wait();  // a caller who waited for this would wait for ever
        order += "first ";
    });
    gone_on.set_value();
    side.begin([&] { order += "second "; });
    side.finish();
    EXPECT_EQ(order, "first second ");
}

TEST(SideThread, TellsWhatEndedItsWorkOnceAndGoesOn) {
    SideThread side;
    bool begun = false;
    side.begin([] { throw std::runtime_error("the disk is full"); });
    try {
        side.begin([&] { begun = true; });
        FAIL() << "nothing was said";
    } catch (const std::runtime_error& e) { EXPECT_STREQ(e.what(), "the disk is full"); }
    side.finish();
    EXPECT_FALSE(begun);
    side.begin([&] { begun = true; });
    side.finish();
    EXPECT_TRUE(begun);
}

TEST(SideThread, FinishesItsWorkBeforeItIsGone) {
    std::atomic<int> done = 0;
    {
        SideThread side;
        side.begin([&] { ++done; });
    }
    EXPECT_EQ(done, 1);
    { const SideThread idle; }
}

TEST(SideThread, CountsTheProcessorTimeOfItsWorkAlone) {
    SideThread side;
    const double before = side.cpu();
    volatile double own = 0;
    for (int k = 0; k < 3'000'000; ++k) own = own + 1;
    EXPECT_LT(side.cpu() - before, 0.002);
    side.begin([] {
        volatile double sum = 0;
        for (int k = 0; k < 3'000'000; ++k) sum = sum + 1;
    });
    side.finish();
    EXPECT_GT(side.cpu() - before, 0.002);
}

}  // namespace side_thread_test
}  // namespace tw
