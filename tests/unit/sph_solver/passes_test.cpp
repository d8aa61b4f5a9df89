// The pair loops themselves: walls that move, points that accelerate, loads body by body. A block of jittered water
// over a floor and beside an upright plate, both of dummy particles.
#include <gtest/gtest.h>

#include <cmath>
#include <cstring>
#include <random>

#include "sph_solver/neighbours/pencils.h"
#include "sph_solver/pair_loops/views.h"

namespace tw {
namespace passes_test {

constexpr double dp = 0.1, h = 1.5 * dp, rho0 = 1000;

template <class T>
bool same_bits(const std::vector<T>& a, const std::vector<T>& b) {
    return a.size() == b.size() && std::memcmp(a.data(), b.data(), a.size() * sizeof(T)) == 0;
}

struct Basin {
    enum Bodies { floor_alone, plate_alone, both };

    FixedPoint fixed_point{Vec3(0.3, 0.3, 0.3), dp / (1 << 18)};
    PencilGrid grid{Box{Vec3::Constant(-0.4), Vec3::Constant(1.2)}, dp, 3, fixed_point, passes().lanes};
    std::vector<PackedPlace> place, wall_place;
    std::vector<std::int32_t> start, wall_start[2], body_end;
    std::vector<PackedVelocityDensity> motion;
    std::vector<PackedGradientPressure> stress;
    std::vector<PackedShiftSupport> shift;
    std::vector<PackedRate> rate;
    std::vector<PackedWallNormal> normal;
    std::vector<float> wall_p;
    std::vector<WallLoad> wall_load;
    std::vector<std::uint32_t> surface;
    std::vector<Cluster> clusters, wall_clusters;
    NeighbourLists lists, wall_lists, of_walls;
    FirstPairLoopData first;
    SecondPairLoopData second;

    explicit Basin(Bodies bodies = both) {
        std::mt19937 random(3);
        std::uniform_real_distribution<double> jitter(-0.2 * dp, 0.2 * dp);
        std::vector<WidePlace> raw;
        for (int k = 0; k < 8 * 8 * 6; ++k)
            raw.push_back(
                fixed_point.wide(Vec3{(k % 8 + 0.5) * dp + jitter(random), (k / 8 % 8 + 0.5) * dp + jitter(random),
                                      (k / 64 + 0.5) * dp + jitter(random)}));
        add_sorted(raw, place, start);
        const std::size_t n = place.size();
        std::vector<WidePlace> floor, plate;
        for (int x = -3; x < 11; ++x)
            for (int y = -3; y < 11; ++y)
                for (int z = -3; z < 0; ++z)
                    floor.push_back(fixed_point.wide(Vec3{(x + 0.5) * dp, (y + 0.5) * dp, (z + 0.5) * dp}));
        for (int x = -3; x < 0; ++x)
            for (int y = -3; y < 11; ++y)
                for (int z = 0; z < 9; ++z)
                    plate.push_back(fixed_point.wide(Vec3{(x + 0.5) * dp, (y + 0.5) * dp, (z + 0.5) * dp}));
        std::vector<Source> walls;
        if (bodies != plate_alone) add_sorted(floor, wall_place, wall_start[0]);
        body_end.push_back(static_cast<std::int32_t>(wall_place.size()));
        if (bodies != floor_alone) add_sorted(plate, wall_place, wall_start[1]);
        body_end.push_back(static_cast<std::int32_t>(wall_place.size()));
        for (int b = 0; b < 2; ++b)
            if (const std::int32_t from = b ? body_end[0] : 0; body_end[std::size_t(b)] > from)
                walls.push_back({&grid, wall_place.data() + from, &wall_start[b], from});

        std::uniform_real_distribution<float> any(-1, 1);
        for (std::size_t i = 0; i < n; ++i) {
            motion.push_back({any(random), any(random), any(random), any(random)});
            stress.push_back({0, 0, 0, 500 + 100 * any(random)});
            normal.push_back(place[i].x < place[i].z ? PackedWallNormal{1, 0, 0, 0.1f}
                                                     : PackedWallNormal{0, 0, 1, 0.1f});
        }
        for (std::size_t k = 0; k < wall_place.size(); ++k) wall_p.push_back(600);
        shift.resize(n), rate.resize(n), surface.assign(n / 32 + 2, 0);
        const Source water{&grid, place.data(), &start, 0};
        make_clusters(water, passes().lanes, clusters);
        const Reaches reaches{2 * h, 2 * h, 2 * h};
        lists.build(passes(), fixed_point, water, clusters, {water}, reaches);
        wall_lists.build(passes(), fixed_point, water, clusters, walls, reaches, &Cluster::wall_list);
        wall_load.resize(static_cast<std::size_t>(number_wall_loads(clusters, wall_lists.view(), body_end)));
        first.water = {.list = lists.view(),
                       .place = place.data(),
                       .motion = motion.data(),
                       .stress = stress.data(),
                       .surface = surface.data(),
                       .kernel = Kernel(h, 3),
                       .unit = static_cast<float>(fixed_point.size),
                       .rho0 = rho0,
                       .inv_mass = static_cast<float>(1 / (rho0 * dp * dp * dp))};
        first.walls = {.list = wall_lists.view(),
                       .place = wall_place.data(),
                       .p = wall_p.data(),
                       .body_end = body_end.data(),
                       .bodies = 2,
                       .normal = normal.data()};
        first.stress = stress.data(), first.shift = shift.data(), first.rate = rate.data();
        first.inv_W_dp = static_cast<float>(1 / first.water.kernel.W(dp));
        first.inv_void = 1;  // walls compress from no support on: here all do
        second = {.water = first.water,
                  .walls = first.walls,
                  .shift = shift.data(),
                  .rate = rate.data(),
                  .wall_load = wall_load.data()};
    }
    void add_sorted(const std::vector<WidePlace>& raw, std::vector<PackedPlace>& to, std::vector<std::int32_t>& at) {
        std::vector<std::int32_t> order;
        sort_by_pencil(grid, raw, order, at);
        for (const std::int32_t k : order)
            to.push_back(raw[static_cast<std::size_t>(k)].packed(static_cast<float>(dp * dp * dp)));
    }
    void move(float u, float v, float w) {
        for (PackedVelocityDensity& r : motion) r.u += u, r.v += v, r.w += w;
    }
    int count() const { return static_cast<int>(clusters.size()); }
    std::vector<PackedRate> continuity(const std::vector<WallVelocity>& of_walls_ = {}) {
        first.walls.velocity = of_walls_.empty() ? nullptr : of_walls_.data();
        passes().run(first, clusters.data(), count());
        return rate;
    }
    /// [N]
    Vec3 load_on(std::int32_t body) {
        Vec3 sum = Vec3::Zero();
        for (const WallLoad& l : wall_load)
            if (l.body == body) sum -= rho0 * dp * dp * dp * Vec3(l.ax, l.ay, l.az);
        return sum;
    }
    Vec3 moment_on(std::int32_t body) {
        Vec3 sum = Vec3::Zero();
        for (const Cluster& g : clusters)
            for (std::int32_t k = g.wall_load; k >= 0 && k < slots_end(g); ++k) {
                const WallLoad& l = wall_load[static_cast<std::size_t>(k)];
                if (l.body != body) continue;
                sum -= Vec3(l.mx, l.my, l.mz) +
                       (fixed_point.origin + fixed_point.size * Vec3(g.x, g.y, g.z)).cross(Vec3(l.ax, l.ay, l.az));
            }
        return rho0 * dp * dp * dp * sum;
    }
    std::int32_t slots_end(const Cluster& g) const {
        std::int32_t end = static_cast<std::int32_t>(wall_load.size());
        for (const Cluster& other : clusters)
            if (other.wall_load > g.wall_load) end = std::min(end, other.wall_load);
        return end;
    }
};

double largest_rate(const std::vector<PackedRate>& rates) {
    double most = 0;
    for (const PackedRate& r : rates) most = std::max(most, std::abs(double(r.drho)));
    return most;
}

TEST(MovingWalls, AtRestAreTheWallsThatDoNotMoveBitByBit) {
    Basin a, b;
    a.continuity();
    b.continuity(std::vector<WallVelocity>(b.wall_place.size(), {0, 0, 0}));
    EXPECT_TRUE(same_bits(a.rate, b.rate));
    EXPECT_TRUE(same_bits(a.shift, b.shift));
    EXPECT_TRUE(same_bits(a.stress, b.stress));
    Basin c;
    c.continuity(std::vector<WallVelocity>(c.wall_place.size(), {0.1f, 0, 0.1f}));
    EXPECT_FALSE(same_bits(a.rate, c.rate));
}

TEST(MovingWalls, ThatGoWithTheWaterCompressNothing) {
    Basin basin;
    for (PackedVelocityDensity& r : basin.motion) r = {3, -1, -2, r.drho};
    const std::vector<WallVelocity> along(basin.wall_place.size(), {3, -1, -2});
    const double scale = rho0 * 3 / h;
    EXPECT_LT(largest_rate(basin.continuity(along)), 1e-5 * scale);
    EXPECT_GT(largest_rate(basin.continuity()), 0.1 * scale);  // water that falls on a floor at rest
}

TEST(MovingWalls, CompressWaterAtRestAsWaterThatMovesAgainstThem) {
    Basin basin;
    for (PackedVelocityDensity& r : basin.motion) r = {0, 0, 0, r.drho};
    const std::vector<PackedRate> pushed =
        basin.continuity(std::vector<WallVelocity>(basin.wall_place.size(), {0.5f, 0, 1.5f}));
    basin.move(-0.5f, 0, -1.5f);
    const std::vector<PackedRate> falls = basin.continuity();
    for (std::size_t i = 0; i < falls.size(); ++i) EXPECT_NEAR(pushed[i].drho, falls[i].drho, 1e-5 * rho0 * 1.5 / h);
}

TEST(MovingWalls, GiveARateThatIsTheSameInAnyFrame) {
    Basin basin;
    std::vector<WallVelocity> walls;
    for (std::size_t k = 0; k < basin.wall_place.size(); ++k)
        walls.push_back({0.1f * static_cast<float>(k % 7), 0.2f, -0.3f * static_cast<float>(k % 3)});
    const std::vector<PackedRate> here = basin.continuity(walls);
    basin.move(5, -7, 3);
    for (WallVelocity& u : walls) u.u += 5, u.v -= 7, u.w += 3;
    const std::vector<PackedRate> there = basin.continuity(walls);
    for (std::size_t i = 0; i < here.size(); ++i) EXPECT_NEAR(here[i].drho, there[i].drho, 1e-5 * rho0 * 7 / h);
}

struct Extrapolated {
    std::vector<float> p, support;
};
Extrapolated to_walls(Basin& basin, const std::vector<WallAcceleration>& acceleration) {
    std::vector<Cluster> clusters;
    const Source walls{&basin.grid, basin.wall_place.data(), &basin.wall_start[0], 0};
    make_clusters(walls, passes().lanes, clusters);
    basin.of_walls.build(passes(), basin.fixed_point, walls, clusters,
                         {{&basin.grid, basin.place.data(), &basin.start, 0}}, {2 * h, 2 * h, 2 * h});
    Extrapolated r;
    r.p.resize(basin.wall_place.size()), r.support.resize(basin.wall_place.size());
    ExtrapolateData e;
    e.list = basin.of_walls.view();
    e.at = basin.wall_place.data();
    e.water = basin.first.water;
    e.acceleration = acceleration.empty() ? nullptr : acceleration.data();
    e.p = r.p.data(), e.support = r.support.data();
    e.gx = 0.3f, e.gz = -9.81f;
    passes().run(e, clusters.data(), static_cast<int>(clusters.size()));
    return r;
}

TEST(AcceleratedWalls, WithoutAccelerationAreWallsAtRestBitByBit) {
    Basin basin(Basin::floor_alone);
    const Extrapolated rest = to_walls(basin, {}),
                       zero = to_walls(basin, std::vector<WallAcceleration>(basin.wall_place.size(), {0, 0, 0}));
    EXPECT_TRUE(same_bits(rest.p, zero.p));
    EXPECT_TRUE(same_bits(rest.support, zero.support));
}

TEST(AcceleratedWalls, ThatFallFreelyCarryNoHydrostaticDifference) {
    Basin basin(Basin::floor_alone);
    for (PackedGradientPressure& r : basin.stress) r.p = 700;
    const Extrapolated falls =
                           to_walls(basin, std::vector<WallAcceleration>(basin.wall_place.size(), {0.3f, 0, -9.81f})),
                       rest = to_walls(basin, {});
    double largest = 0;
    for (std::size_t k = 0; k < falls.p.size(); ++k) {
        if (falls.support[k] < 0.005f) continue;
        EXPECT_NEAR(falls.p[k], 700, 1e-3);
        largest = std::max(largest, double(rest.p[k] - 700));
    }
    EXPECT_GT(largest, rho0 * 9.81 * dp);
}

TEST(AcceleratedWalls, UpwardsBearMore) {
    Basin basin(Basin::floor_alone);
    for (PackedGradientPressure& r : basin.stress) r.p = 700;
    const Extrapolated up = to_walls(basin, std::vector<WallAcceleration>(basin.wall_place.size(), {0.3f, 0, 9.81f})),
                       rest = to_walls(basin, std::vector<WallAcceleration>(basin.wall_place.size(), {0.3f, 0, 0}));
    for (std::size_t k = 0; k < up.p.size(); ++k)
        if (up.support[k] > 0.005f) { EXPECT_NEAR(up.p[k] - 700, 2 * (rest.p[k] - 700), 0.01); }
}

TEST(BodyLoads, OfTwoBodiesAreThoseOfEachAlone) {
    Basin two(Basin::both), floor(Basin::floor_alone), plate(Basin::plate_alone);
    for (Basin* basin : {&two, &floor, &plate}) passes().run(basin->second, basin->clusters.data(), basin->count());
    EXPECT_GT(two.wall_load.size(), floor.wall_load.size());
    for (std::int32_t body : {0, 1}) {
        Basin& alone = body ? plate : floor;
        EXPECT_GT(alone.load_on(body).norm(), 1);
        EXPECT_LT((two.load_on(body) - alone.load_on(body)).norm(), 1e-6 * alone.load_on(body).norm());
        EXPECT_LT((two.moment_on(body) - alone.moment_on(body)).norm(), 1e-6 * alone.moment_on(body).norm());
    }
    EXPECT_LT(two.load_on(0).z(), -1);  // the floor bears water, the plate is pressed towards -x
    EXPECT_LT(two.load_on(1).x(), -1);
}

TEST(BodyLoads, OfAllWallsAsOneBodyAreTheSumAndTheWaterFeelsTheSame) {
    Basin two, one;
    const std::int32_t end = two.body_end.back();
    one.second.walls.body_end = &end, one.second.walls.bodies = 1;
    one.wall_load.resize(static_cast<std::size_t>(number_wall_loads(one.clusters, one.wall_lists.view(), {end})));
    for (Basin* basin : {&two, &one}) passes().run(basin->second, basin->clusters.data(), basin->count());
    EXPECT_LT((one.load_on(0) - two.load_on(0) - two.load_on(1)).norm(), 1e-6 * one.load_on(0).norm());
    double largest = 0;
    for (std::size_t i = 0; i < one.rate.size(); ++i) {
        const Vec3 a(one.rate[i].ax, one.rate[i].ay, one.rate[i].az), b(two.rate[i].ax, two.rate[i].ay, two.rate[i].az);
        largest = std::max(largest, a.norm());
        EXPECT_LT((a - b).norm(), 1e-4);
    }
    EXPECT_GT(largest, 1);
    Basin without;  // no table of bodies: one body
    without.second.walls.body_end = nullptr, without.second.walls.bodies = 1;
    without.wall_load.resize(
        static_cast<std::size_t>(number_wall_loads(without.clusters, without.wall_lists.view(), {end})));
    passes().run(without.second, without.clusters.data(), without.count());
    EXPECT_TRUE(same_bits(one.rate, without.rate));
    EXPECT_TRUE(same_bits(one.wall_load, without.wall_load));
}

}  // namespace passes_test
}  // namespace tw
