// The loops that a back end offers: everybody once, and sums that do not depend on the number of threads.
#include "sph_solver/backend/for_particles.h"

#include <gtest/gtest.h>
#include <omp.h>

#include "base/exact_sum.h"

namespace tw {
namespace for_particles_test {

constexpr std::size_t n = 3 * 4096 + 17;

TEST(ForParticles, VisitsEverybodyOnce) {
    std::vector<int> visits(n, 0);
    for_particles(n, [&](std::size_t i) { ++visits[i]; });
    EXPECT_EQ(visits, std::vector<int>(n, 1));
    for_particles(0, [&](std::size_t) { FAIL(); });
}

TEST(ForClusters, VisitsEveryClusterOnce) {
    std::vector<Cluster> clusters(100);
    std::vector<int> visits(100, 0);
    for (int k = 0; k < 100; ++k) clusters[static_cast<std::size_t>(k)].first = k;
    for_clusters(clusters, [&](const Cluster& g) { ++visits[static_cast<std::size_t>(g.first)]; });
    EXPECT_EQ(visits, std::vector<int>(100, 1));
}

TEST(ForPairs, GivesEveryClusterToThePassOnce) {
    std::vector<Cluster> clusters(100);
    std::vector<int> visits(100, 0);
    for (int k = 0; k < 100; ++k) clusters[static_cast<std::size_t>(k)].first = k;
    struct Data {
        int* visits;
    };
    struct PairLoops {
        void run(const Data& d, const Cluster* g, int count) const {
            for (int k = 0; k < count; ++k) ++d.visits[g[k].first];
        }
    };
    for_pairs(PairLoops{}, Data{visits.data()}, clusters);
    EXPECT_EQ(visits, std::vector<int>(100, 1));
}

TEST(InFixedRanges, SumsToTheSameBitsWithAnyNumberOfThreads) {
    struct Part {
        float sum = 0;
        std::size_t begin = 0, end = 0;
    };
    const auto parts_with = [](int threads) {
        const int before = omp_get_max_threads();
        omp_set_num_threads(threads);
        const std::vector<Part> parts = in_fixed_ranges<Part>(n, [](Part& part, std::size_t begin, std::size_t end) {
            part.begin = begin, part.end = end;
            for (std::size_t i = begin; i < end; ++i) part.sum += 1 / static_cast<float>(i + 1);
        });
        omp_set_num_threads(before);
        return parts;
    };
    const std::vector<Part> one = parts_with(1), three = parts_with(3);
    ASSERT_EQ(one.size(), 4u);
    ASSERT_EQ(three.size(), 4u);
    float sum_of_one = 0, sum_of_three = 0;
    std::size_t reached = 0;
    for (std::size_t c = 0; c < 4; ++c) {
        EXPECT_EQ(one[c].begin, reached);  // in order, without gaps
        reached = one[c].end;
        sum_of_one += one[c].sum, sum_of_three += three[c].sum;
    }
    EXPECT_EQ(reached, n);
    EXPECT_EQ(sum_of_one, sum_of_three);
}

TEST(SumOver, IsTheSameInAnyOrderAndWithAnyNumberOfThreads) {
    const auto sum_with = [](int threads, bool backwards) {
        const int before = omp_get_max_threads();
        omp_set_num_threads(threads);
        const ExactSum sum = sum_over<ExactSum>(
            n, [&](ExactSum& part, std::size_t i) { part += 1 / static_cast<double>(backwards ? n - i : i + 1); });
        omp_set_num_threads(before);
        return sum.value();
    };
    double harmonic = 0;
    for (std::size_t i = n; i > 0; --i) harmonic += 1 / static_cast<double>(i);
    EXPECT_NEAR(sum_with(1, false), harmonic, 1e-12);
    EXPECT_EQ(sum_with(1, false), sum_with(3, true));
    EXPECT_EQ(sum_over<ExactSum>(0, [](ExactSum&, std::size_t) { FAIL(); }).value(), 0);
}

}  // namespace for_particles_test
}  // namespace tw
