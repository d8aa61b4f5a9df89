#include "base/trial.h"

#include <gtest/gtest.h>
#include <unistd.h>

#include <csignal>
#include <new>

#include "base/errors.h"

namespace tw {
namespace trial_test {

std::string fault_of(const std::function<std::string()>& work, const TrialLimits& limits = {}) {
    try {
        answer_of_trial(work, limits);
    } catch (const InputError& e) { return e.what(); }
    return "none";
}

TEST(Trial, SaysWhyItDidNotComeToItsEnd) {
    EXPECT_EQ(fault_of([]() -> std::string { throw InputError("a bad file"); }), "a bad file");
    EXPECT_EQ(fault_of([] {
                  std::raise(SIGKILL);
                  return "";
              }),
              "its numbers contradict each other");
    EXPECT_EQ(fault_of([]() -> std::string { throw std::bad_alloc(); }), "it asks for more memory than it may have");
    EXPECT_EQ(fault_of(
                  [] {
                      while (true) ::pause();
                      return "";
                  },
                  {.seconds = 1}),
              "it does not come to an end");
    EXPECT_EQ(fault_of(
                  [] {
                      for (volatile bool on = true; on;) {}
                      return "";
                  },
                  {.processor = 1}),
              "it does not come to an end");
}

TEST(Trial, AnswersAndChangesNothingHere) {
    int changed = 0;
    const std::string large(1'000'000, 'x');
    EXPECT_EQ(answer_of_trial([&] {
                  changed = 1;
                  return large;
              }),
              large);
    EXPECT_EQ(changed, 0);
}

}  // namespace trial_test
}  // namespace tw
