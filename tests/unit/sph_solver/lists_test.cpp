// Neighbour lists against distances found one by one.
#include <gtest/gtest.h>

#include <cmath>
#include <random>

#include "sph_solver/neighbours/pencils.h"
#include "sph_solver/pair_loops/views.h"

namespace tw {
namespace lists_test {

/// A cloud without any order, sorted and cut into clusters as the solver does: some pencils tall, some empty.
struct Cloud {
    double dp = 0.1;
    FixedPoint fixed_point{Vec3(0.3, 0.2, 0.5), 0.1 / (1 << 18)};
    PencilGrid grid{Box{Vec3(0.2, 0.2, 0), Vec3(1.1, 0.8, 1.5)}, 0.1, 3, fixed_point,
                    passes().lanes};  // smaller than the cloud
    std::vector<PackedPlace> places;
    std::vector<std::int32_t> start;
    std::vector<Cluster> clusters;

    Cloud() {
        std::mt19937 random(5);
        std::uniform_real_distribution<double> along(0, 1.2), height(0, 1);
        std::vector<WidePlace> raw;
        for (int k = 0; k < 1500; ++k) {
            const double x = along(random), y = along(random), top = x < 0.5 ? 2 : 0.4;
            raw.push_back(fixed_point.wide({x, y, top * height(random)}));
        }
        std::vector<std::int32_t> order;
        sort_by_pencil(grid, raw, order, start);
        for (const std::int32_t k : order) places.push_back(raw[static_cast<std::size_t>(k)].packed(1));
        make_clusters({&grid, places.data(), &start, 0}, passes().lanes, clusters);
    }
    /// Of place k from the nearest particle of the cluster, one of `targets` [m].
    double distance(const Cluster& g, std::size_t k) const { return distance(places, g, k); }
    double distance(const std::vector<PackedPlace>& targets, const Cluster& g, std::size_t k) const {
        double least = 1e30;
        for (std::int32_t i = g.first; i < g.first + g.size; ++i) {
            const PackedPlace &a = targets[static_cast<std::size_t>(i)], &b = places[k];
            least = std::min(least, std::hypot(double(a.x) - b.x, double(a.y) - b.y, double(a.z) - b.z));
        }
        return least * fixed_point.size;
    }
};

/// What a list says of every place: 0 not on it or not asked, 1 live, 2 doubtful, 3 both.
std::vector<int> said_of_places(const Lists& lists, const Cluster& g, std::size_t places) {
    std::vector<int> said(places, 0);
    const NeighbourBlock* const first = lists.blocks(g.list);
    for (const NeighbourBlock* b = first; b != first + g.list.size; ++b)
        for (std::size_t bit = 0; bit < 32; ++bit)
            if (const std::size_t k = static_cast<std::size_t>(b->first) + bit; (b->live | b->maybe) >> bit & 1u) {
                if (k >= places) {
                    ADD_FAILURE() << "no such place";
                    continue;
                }
                EXPECT_EQ(said[k], 0) << "twice on the list";
                said[k] = static_cast<int>(b->live >> bit & 1u) + 2 * static_cast<int>(b->maybe >> bit & 1u);
            }
    return said;
}

TEST(NeighbourLists, HoldWhoeverIsWithinReachAndNobodyElse) {
    Cloud cloud;
    const Reaches reaches{0.36, 0.31, 0.24};
    NeighbourLists lists;
    lists.build(passes(), cloud.fixed_point, {&cloud.grid, cloud.places.data(), &cloud.start, 0}, cloud.clusters,
                {{&cloud.grid, cloud.places.data(), &cloud.start, 0}}, reaches);
    const double rounding = 1e-5;
    int seen = 0;
    for (const Cluster& g : cloud.clusters) {
        const std::vector<int> said = said_of_places(lists.view(), g, cloud.places.size());
        for (std::size_t k = 0; k < said.size(); ++k) {
            const double d = cloud.distance(g, k);
            const bool at_a_limit = std::abs(d / reaches.far - 1) < rounding ||
                                    std::abs(d / reaches.now - 1) < rounding ||
                                    std::abs(d / reaches.sure - 1) < rounding;
            if (at_a_limit) continue;
            EXPECT_EQ(said[k] & 1, d < reaches.now) << d;
            EXPECT_EQ(said[k] >> 1, d < reaches.far && d > reaches.sure) << d;
            seen += said[k] != 0;
        }
    }
    EXPECT_GT(seen, 10000);
}

// As when one level's particles are looked for among another's: the clusters' places are sorted by a grid of their own.
TEST(NeighbourLists, HoldThemForPlacesSortedByPencilsOfAnotherWidth) {
    const Cloud cloud;
    for (const double factor : {0.5, 2.0}) {
        const PencilGrid grid = cloud.grid.scaled(factor);
        std::vector<WidePlace> raw;
        for (const PackedPlace& p : cloud.places) raw.push_back({p.x + 1000, p.y, p.z});
        std::vector<std::int32_t> order, start;
        sort_by_pencil(grid, raw, order, start);
        std::vector<PackedPlace> places;
        for (const std::int32_t k : order) places.push_back(raw[static_cast<std::size_t>(k)].packed(1));
        const Source targets{&grid, places.data(), &start, 0};
        std::vector<Cluster> clusters;
        make_clusters(targets, passes().lanes, clusters);
        const double reach = 0.31;
        NeighbourLists lists;
        lists.build(passes(), cloud.fixed_point, targets, clusters,
                    {{&cloud.grid, cloud.places.data(), &cloud.start, 0}}, {reach, reach, reach});
        int seen = 0;
        for (const Cluster& g : clusters) {
            const std::vector<int> said = said_of_places(lists.view(), g, cloud.places.size());
            for (std::size_t k = 0; k < said.size(); ++k) {
                const double d = cloud.distance(places, g, k);
                if (std::abs(d / reach - 1) < 1e-5) continue;
                EXPECT_EQ(said[k] & 1, d < reach) << d;
                seen += said[k] & 1;
            }
        }
        EXPECT_GT(seen, 10000);
    }
}

TEST(NeighbourLists, PrunedAfterAMoveHoldWhoeverIsWithinReachThen) {
    Cloud cloud;
    const double support = 0.3, slack = 0.06;
    NeighbourLists lists;
    lists.build(passes(), cloud.fixed_point, {&cloud.grid, cloud.places.data(), &cloud.start, 0}, cloud.clusters,
                {{&cloud.grid, cloud.places.data(), &cloud.start, 0}}, {support + slack, support, support - slack});
    std::mt19937 random(6);
    std::uniform_real_distribution<double> move(-0.017, 0.017);  // a distance changes by less than the slack
    for (PackedPlace& p : cloud.places)
        for (std::int32_t* x : {&p.x, &p.y, &p.z})
            *x += static_cast<std::int32_t>(move(random) / cloud.fixed_point.size);
    PruneData d;
    d.lists = lists.view();
    d.of = d.place = cloud.places.data();
    d.reach = support / cloud.fixed_point.size;
    passes().run(d, cloud.clusters.data(), static_cast<int>(cloud.clusters.size()));
    int came_or_went = 0;
    for (const Cluster& g : cloud.clusters) {
        const std::vector<int> said = said_of_places(lists.view(), g, cloud.places.size());
        for (std::size_t k = 0; k < said.size(); ++k)
            if (const double distance = cloud.distance(g, k); std::abs(distance / support - 1) > 1e-5) {
                EXPECT_EQ(said[k] & 1, distance < support) << distance;
                came_or_went += said[k] == 2 || said[k] == 3;
            }
    }
    EXPECT_GT(came_or_went, 1000);
}

}  // namespace lists_test
}  // namespace tw
