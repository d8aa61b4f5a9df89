// Boxes that overlap or touch, divided anew: the same space, nothing twice.
#include "base/disjoint_boxes.h"

#include <gtest/gtest.h>

#include <algorithm>
#include <random>

#include "base/errors.h"

namespace tw {
namespace disjoint_boxes_test {

Box flat(double x0, double z0, double x1, double z1) { return {Vec3(x0, 0, z0), Vec3(x1, 1, z1)}; }

double volume_of(const std::vector<Box>& boxes) {
    double sum = 0;
    for (const Box& box : boxes) sum += box.volume();
    return sum;
}

TEST(DisjointBoxes, OfOneWaterAreOneHoweverItIsWritten) {
    const std::vector<Box> stacked{flat(0, 0, 0.4, 0.1), flat(0, 0.1, 0.4, 0.3)},
        overlapping{flat(0, 0, 0.4, 0.2), flat(0, 0.15, 0.25, 0.3), flat(0.2, 0.1, 0.4, 0.3)},
        apart{flat(0, 0, 0.4, 0.0985), flat(0, 0.1, 0.4, 0.3)};
    for (std::vector<Box> blocks : {stacked, overlapping, apart}) {
        std::ranges::sort(blocks, {}, [](const Box& b) { return b.volume(); });
        for (int order = 0; order < 2; ++order, std::ranges::reverse(blocks)) {
            const std::vector<Box> found = disjoint_boxes(blocks, 2, 0.0025);
            ASSERT_EQ(found.size(), 1u);
            EXPECT_EQ(found[0].min, Vec3(0, 0, 0));
            EXPECT_NEAR((found[0].max - Vec3(0.4, 1, 0.3)).norm(), 0, 1e-12);
        }
    }
}

TEST(DisjointBoxes, LeavesAloneWhatDoesNotTouch) {
    const std::vector<Box> two{flat(0, 0, 0.1, 0.2), flat(0.2, 0, 0.3, 0.2)};
    const auto groups = disjoint_groups(two, 2, 0.005);
    ASSERT_EQ(groups.size(), 2u);
    EXPECT_EQ(groups[0][0].max, two[0].max);
    EXPECT_EQ(groups[1][0].min, two[1].min);
    const std::vector<Box> corner{flat(0, 0, 0.1, 0.2), flat(0.1, 0.2, 0.3, 0.4)};
    EXPECT_EQ(disjoint_groups(corner, 2, 0.005).size(), 2u) << "no water goes through an edge";
}

TEST(DisjointBoxes, PrefersThickOnesToSlivers) {
    // Two columns whose tops differ by less than a particle: no layer of that height is cut off.
    const std::vector<Box> found =
        disjoint_boxes(std::vector{flat(0, 0, 0.2, 0.3), flat(0.2, 0, 0.4, 0.302)}, 2, 0.0025);
    ASSERT_EQ(found.size(), 2u);
    for (const Box& box : found) EXPECT_GT(box.size().z(), 0.29);
}

TEST(DisjointBoxes, OfRandomOnesFillTheSameSpaceOnce) {
    std::mt19937 random(7);
    std::uniform_real_distribution<double> anywhere(0, 1);
    for (const int dimensions : {2, 3}) {
        std::vector<Box> blocks;
        for (int n = 0; n < 12; ++n) {
            Vec3 a(anywhere(random), anywhere(random), anywhere(random)), b(anywhere(random), anywhere(random), 1);
            if (dimensions == 2) a.y() = 0, b.y() = 1;
            blocks.push_back({a.cwiseMin(b), a.cwiseMax(b) + Vec3::Constant(0.01)});
        }
        const std::vector<Box> found = disjoint_boxes(blocks, dimensions, 1e-4);
        int in_one = 0;
        for (int n = 0; n < 5000; ++n) {
            const Vec3 x(anywhere(random), dimensions == 2 ? 0.5 : anywhere(random), anywhere(random));
            const auto holds = [&](const Box& box) { return box.contains(x); };
            const auto times = std::ranges::count_if(found, holds);
            ASSERT_EQ(times, std::ranges::any_of(blocks, holds) ? 1 : 0);
            in_one += times > 0 ? 1 : 0;
        }
        EXPECT_GT(in_one, 1000);
        EXPECT_LT(volume_of(found), volume_of(blocks)) << "they overlapped";
    }
}

TEST(DisjointBoxes, RefuseWhatCannotBeDivided) {
    std::vector<Box> many;
    for (int n = 0; n < 400; ++n) many.push_back({Vec3::Constant(0.001 * n), Vec3::Constant(1 + 0.001 * n)});
    EXPECT_THROW(disjoint_boxes(many, 3, 1e-6), InputError);
}

}  // namespace disjoint_boxes_test
}  // namespace tw
