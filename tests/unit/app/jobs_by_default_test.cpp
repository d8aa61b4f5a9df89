#include "app/pace/jobs_by_default.h"

#include <gtest/gtest.h>

namespace tw::app {
namespace jobs_by_default_test {

constexpr double GB = 1e9;
JobCost mesh(double core_seconds, double ranks_alone = 1) { return {core_seconds, GB, ranks_alone, false}; }
JobCost particles(double core_seconds) { return {core_seconds, GB, 2, true}; }

// Three sizes and a wider box of each method, as the demo has them: the small interFoam runs leave a core idle.
TEST(JobsByDefault, AStudyOfBothMethodsGoesSideBySide) {
    const std::vector<JobCost> demo{particles(20), particles(40), particles(110), particles(25),
                                    mesh(12),      mesh(40),      mesh(110, 2),   mesh(14)};
    const SideBySideChoice c = jobs_by_default(demo, 2, 16 * GB);
    EXPECT_EQ(c.jobs, 2);
    EXPECT_NEAR(c.one_by_one, 195 / 1.97 + 66 + 110 / 1.7, 1e-9);
    EXPECT_NEAR(c.together, 371.0 / 2, 20);
    EXPECT_LT(c.together, 0.9 * c.one_by_one);
}

TEST(JobsByDefault, OneAfterAnotherWhereThatIsAsFast) {
    EXPECT_EQ(jobs_by_default({particles(100), particles(100)}, 2, 16 * GB).jobs, 1) << "threads lose 3 % only";
    EXPECT_EQ(jobs_by_default({mesh(1000, 2), mesh(20)}, 2, 16 * GB).jobs, 1) << "one run is all the work";
    EXPECT_EQ(jobs_by_default({mesh(100)}, 2, 16 * GB).jobs, 1) << "it is alone";
    EXPECT_EQ(jobs_by_default({mesh(100), mesh(100)}, 1, 16 * GB).jobs, 1) << "there is one core";
    EXPECT_EQ(jobs_by_default({mesh(5), mesh(5)}, 2, 16 * GB).jobs, 1) << "it is over before they have begun";
}

TEST(JobsByDefault, OneAfterAnotherWhereTheMemoryDoesNotHoldTwo) {
    std::vector<JobCost> runs{mesh(100), mesh(100)};
    EXPECT_EQ(jobs_by_default(runs, 2, 2.5 * GB).jobs, 2);
    EXPECT_EQ(jobs_by_default(runs, 2, 1.5 * GB).jobs, 1);
}

}  // namespace jobs_by_default_test
}  // namespace tw::app
