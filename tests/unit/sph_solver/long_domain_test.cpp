// A domain longer than 32 bits of fixed-point units reach (16384 spacings): two-dimensional rows of 30 000 spacings,
// along x and upright. Places and velocities repeat every hundred spacings, so that rates must repeat too.
#include <gtest/gtest.h>

#include <cmath>
#include <random>
#include <stdexcept>

#include "sph_solver/neighbours/pencils.h"
#include "sph_solver/pair_loops/views.h"

namespace tw {
namespace long_domain_test {

constexpr double dp = 0.1, h = 1.5 * dp;
constexpr std::int64_t one_dp = 1 << 18;
constexpr int rows = 4, period = 100;

struct Row {
    int length;
    FixedPoint fixed_point{Vec3(2, 0, 2), dp / one_dp};
    std::vector<WidePlace> raw;  ///< particle k * rows + m: k along the row, m across
    std::vector<PackedPlace> place;
    std::vector<std::int32_t> order, start;
    std::vector<PackedVelocityDensity> motion;
    std::vector<PackedGradientPressure> stress;
    std::vector<PackedShiftSupport> shift;
    std::vector<PackedRate> rate;
    std::vector<Cluster> clusters;
    NeighbourLists lists;

    Row(int spacings, bool upright) : length(spacings) {
        const double end = spacings * dp;
        const Box area{Vec3(0, 0, 0), upright ? Vec3(rows * dp, 0, end) : Vec3(end, 0, rows * dp)};
        const PencilGrid grid(area, dp, 2, fixed_point, passes().lanes);
        EXPECT_EQ(grid.nz > 1, upright && spacings > 4096);
        std::mt19937 random(4);
        std::uniform_int_distribution<std::int64_t> jitter(-one_dp / 5, one_dp / 5);
        std::uniform_real_distribution<float> any(-1, 1);
        struct {
            std::int64_t along, across;
            PackedVelocityDensity motion;
        } pattern[period * rows];
        for (auto& p : pattern)
            p = {jitter(random), jitter(random), {any(random), any(random), any(random), any(random)}};
        for (int k = 0; k < spacings; ++k)
            for (int m = 0; m < rows; ++m) {
                const auto& moved = pattern[k % period * rows + m];
                const std::int64_t along = k * one_dp + moved.along, across = m * one_dp + moved.across;
                raw.push_back(upright ? WidePlace{across, 0, along} : WidePlace{along, 0, across});
            }
        sort_by_pencil(grid, raw, order, start);
        for (const std::int32_t i : order) {
            place.push_back(raw[static_cast<std::size_t>(i)].packed(static_cast<float>(dp * dp)));
            motion.push_back(pattern[i % (period * rows)].motion);
        }
        const Source source{&grid, place.data(), &start, 0};
        make_clusters(source, passes().lanes, clusters);
        lists.build(passes(), fixed_point, source, clusters, {source}, {2 * h, 2 * h, 2 * h});
        stress.resize(place.size()), shift.resize(place.size()), rate.resize(place.size());
        FirstPairLoopData d{.water = {.list = lists.view(),
                                      .place = place.data(),
                                      .motion = motion.data(),
                                      .kernel = Kernel(h, 2),
                                      .unit = static_cast<float>(fixed_point.size),
                                      .two_dimensional = true},
                            .stress = stress.data(),
                            .shift = shift.data(),
                            .rate = rate.data()};
        d.inv_W_dp = static_cast<float>(1 / d.water.kernel.W(dp));
        passes().run(d, clusters.data(), static_cast<int>(clusters.size()));
    }
    double distance(std::int32_t i, std::int32_t j) const {  // [dp]
        const WidePlace &a = raw[static_cast<std::size_t>(i)], &b = raw[static_cast<std::size_t>(j)];
        return std::hypot(double(a.x - b.x), double(a.z - b.z)) / one_dp;
    }
};

void expect_lists_as_by_hand(const Row& row) {
    int wrong = 0;
    for (const Cluster& g : row.clusters) {
        std::vector<std::int32_t> found, wanted;
        const NeighbourBlock* const blocks = row.lists.view().blocks(g.list);
        for (std::int32_t b = 0; b < g.list.size; ++b)
            for (std::int32_t bit = 0; bit < 32; ++bit)
                if (blocks[b].live >> bit & 1u)
                    found.push_back(row.order[static_cast<std::size_t>(blocks[b].first + bit)]);
        const auto of_cluster = [&](std::int32_t l) { return row.order[static_cast<std::size_t>(g.first + l)]; };
        std::int32_t lowest = of_cluster(0), highest = lowest;
        for (std::int32_t l = 0; l < g.size; ++l)
            lowest = std::min(lowest, of_cluster(l)), highest = std::max(highest, of_cluster(l));
        for (std::int32_t j = std::max(0, lowest - 5 * rows);
             j < std::min(static_cast<std::int32_t>(row.raw.size()), highest + 5 * rows); ++j)
            for (std::int32_t l = 0; l < g.size; ++l)
                if (row.distance(of_cluster(l), j) < 2 * h / dp) {
                    wanted.push_back(j);
                    break;
                }
        std::sort(found.begin(), found.end());
        wrong += found != wanted;
    }
    EXPECT_EQ(wrong, 0) << "of " << row.clusters.size() << " clusters";
}

TEST(LongDomain, OfThirtyThousandSpacingsHasTheListsFoundByHandAndTheSameRatesEverywhere) {
    for (const bool upright : {false, true}) {
        const Row row(30000, upright);
        expect_lists_as_by_hand(row);
        std::vector<std::size_t> at(row.order.size());
        for (std::size_t k = 0; k < row.order.size(); ++k) at[static_cast<std::size_t>(row.order[k])] = k;
        double largest = 0, largest_rate = 0, largest_shift = 0;
        const std::size_t first = 10 * rows, step = period * rows;
        for (std::size_t i = first + step; i + first < row.raw.size(); ++i) {
            const std::size_t here = at[i], there = at[first + (i - first) % step];
            largest_rate = std::max(largest_rate, std::abs(double(row.rate[here].drho)));
            largest = std::max(largest, std::abs(double(row.rate[here].drho) - row.rate[there].drho));
            largest_shift = std::max(largest_shift, std::abs(double(row.shift[here].x) - row.shift[there].x));
        }
        EXPECT_GT(largest_rate, 1000);
        EXPECT_LT(largest, 1e-5 * largest_rate) << upright;  // single precision
        EXPECT_LT(largest_shift, 1e-4) << upright;
    }
}

TEST(LongDomain, PlacesComeBackFromTheirFixedPoint) {
    const FixedPoint fixed_point(Vec3(1, 2, 3), dp / one_dp);
    for (const double x : {-2000.3, 1.0, 17.77, 1500.5, 2999.9})
        for (int axis = 0; axis < 3; ++axis)
            EXPECT_NEAR(fixed_point.metres(fixed_point.of(x, axis), axis, x + 5), x, fixed_point.size);
}

TEST(FixedPointOfLevels, APlaceOfACoarseLevelIsOneOfAFinerLevelByAShift) {
    const FixedPoint coarse(Vec3(1, 2, 3), dp / one_dp), fine(Vec3(1, 2, 3), dp / 4 / one_dp);
    const std::int64_t q = 123456789;
    EXPECT_EQ(fine.wide(1 + static_cast<double>(q) * coarse.size, 0), q << 2);
}

}  // namespace long_domain_test
}  // namespace tw
