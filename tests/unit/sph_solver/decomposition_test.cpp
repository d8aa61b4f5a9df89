// How the pencils of a level are shared by ranks, and who holds copies of them. What the ranks then do with it is in
// tests/robustness/runs/ranks_test.cpp.
#include <gtest/gtest.h>

#include <random>

#include "sph_solver/fields/particles.h"
#include "sph_solver/parallel/decomposition.h"
#include "sph_solver/parallel/halo.h"

namespace tw {
namespace decomposition_test {

const double dp = 0.1;
const FixedPoint fixed_point(Vec3(2, 1, 0), dp / (1 << 18));
const Box domain{Vec3(0, 0, 0), Vec3(4, 2, 1)};

PencilGrid grid_over_domain() {
    Box area = domain;
    area.min.array() -= 4 * dp;
    area.max.array() += 4 * dp;
    return PencilGrid(area, dp, 3, fixed_point, 8);
}
/// Water that stands thrice as high in one half, and dry pencils all round it.
std::vector<std::int64_t> work_of(const PencilGrid& grid) {
    std::vector<std::int64_t> work(static_cast<std::size_t>(grid.count()), 0);
    for (int y = 2; y < grid.ny - 2; ++y)
        for (int x = 2; x < grid.nx - 2; ++x)
            work[static_cast<std::size_t>(grid.pencil(x, y, 0))] = x < grid.nx / 2 ? 300 : 100;
    return work;
}

TEST(Decomposition, ItsPartsHaveTheSameWorkToWithinAPencil) {
    const PencilGrid grid = grid_over_domain();
    const std::vector<std::int64_t> work = work_of(grid);
    for (const int ranks : {1, 2, 3, 4, 7, 16}) {
        const Decomposition pencils(grid, grid, work, ranks);
        std::vector<std::int64_t> of_rank(static_cast<std::size_t>(ranks), 0);
        std::int64_t all = 0;
        for (int c = 0; c < grid.count(); ++c) {
            ASSERT_LT(pencils.owner(c), ranks);
            of_rank[static_cast<std::size_t>(pencils.owner(c))] += work[static_cast<std::size_t>(c)];
            all += work[static_cast<std::size_t>(c)];
        }
        // each cut is wrong by half a pencil at most, and there are four one after another for 16 parts
        for (const std::int64_t own : of_rank) EXPECT_NEAR(double(own), double(all) / ranks, 300) << ranks << " ranks";
    }
}

TEST(Decomposition, NoRankIsLeftWithoutWaterWhileThereArePencils) {
    const PencilGrid grid = grid_over_domain();
    std::vector<std::int64_t> work(static_cast<std::size_t>(grid.count()), 0);
    work[static_cast<std::size_t>(grid.pencil(3, 3, 0))] = 1000000;  // of three pencils one has nearly all
    work[static_cast<std::size_t>(grid.pencil(4, 3, 0))] = work[static_cast<std::size_t>(grid.pencil(9, 3, 0))] = 1;
    const Decomposition pencils(grid, grid, work, 3);
    EXPECT_NE(pencils.owner(grid.pencil(3, 3, 0)), pencils.owner(grid.pencil(4, 3, 0)));
    EXPECT_NE(pencils.owner(grid.pencil(4, 3, 0)), pencils.owner(grid.pencil(9, 3, 0)));
}

TEST(Decomposition, ThePencilsOfABlockGoToOneRank) {
    const PencilGrid grid = grid_over_domain(), blocks = grid.scaled(2);
    const auto block = [&](int c) { return blocks.of(grid.centre(c)); };
    const Decomposition pencils(grid, blocks, work_of(grid), 5), apart(grid, grid, work_of(grid), 5);
    std::vector<std::int64_t> of_rank(5, 0);
    bool cut = false;
    for (int c = 0; c < grid.count(); ++c) {
        of_rank[static_cast<std::size_t>(pencils.owner(c))] += work_of(grid)[static_cast<std::size_t>(c)];
        for (int other = 0; other < c; ++other) {
            if (block(c) != block(other)) continue;
            ASSERT_EQ(pencils.owner(c), pencils.owner(other)) << c << " " << other;
            cut = cut || apart.owner(c) != apart.owner(other);
        }
    }
    EXPECT_TRUE(cut) << "no block would be cut anyhow";
    for (const std::int64_t own : of_rank) EXPECT_GT(own, 0);
}

TEST(Decomposition, ACopyIsHeldByAllWhoHaveAPlaceWithinReachOfItOrOfItsImage) {
    const PencilGrid grid = grid_over_domain();
    Mirrors mirrors;
    mirrors.on[0] = {true, false};
    mirrors.on[1] = {true, true};
    const double reach = 3.7 * dp;
    Decomposition pencils(grid, grid, work_of(grid), 5);
    pencils.find_holders(grid, mirrors, fixed_point.wide(domain.min), fixed_point.wide(domain.max),
                         static_cast<std::int64_t>(reach * fixed_point.per_metre) + 1);
    std::mt19937 random(1);
    std::uniform_real_distribution<double> x(0, 4), y(0, 2), apart(-reach, reach);
    int across = 0, by_image = 0;
    for (int n = 0; n < 20000; ++n) {
        const Vec3 of(x(random), y(random), 0.5);
        Vec3 seen = of;  // itself or its image
        if (n % 2 == 0 && of.x() < reach) seen.x() *= -1;
        if (n % 3 == 0 && of.y() < reach) seen.y() *= -1;
        if (n % 5 == 0 && 2 - of.y() < reach) seen.y() = 4 - seen.y();
        const Vec3 from = seen + Vec3(apart(random), apart(random), 0);
        if ((from - seen).norm() > reach) continue;
        const int owner = pencils.owner(grid.of(fixed_point.wide(from))), pencil = grid.of(fixed_point.wide(of));
        EXPECT_TRUE(pencils.holds(owner, pencil)) << of.transpose() << " is seen from " << from.transpose();
        across += owner != pencils.owner(pencil);
        by_image += owner != pencils.owner(pencil) && seen != of;
    }
    EXPECT_GT(across, 100);
    EXPECT_GT(by_image, 10);
    int copies = 0;
    for (int c = 0; c < grid.count(); ++c) copies += static_cast<int>(pencils.holders(c).size());
    EXPECT_LT(copies, grid.count());  // or all hold all
}

TEST(Comm, OfOneProcessGivesBackWhatItGets) {
    const Comm& one = Comm::alone();
    EXPECT_TRUE(one.first());
    EXPECT_FALSE(one.many());
    EXPECT_EQ(one.sum(3), 3);
    EXPECT_EQ(one.largest(-2), -2);
    EXPECT_EQ(one.gathered(std::vector{1, 2}), (std::vector{1, 2}));
    EXPECT_EQ(one.broadcast_from(0, "text"), "text");
    EXPECT_THROW(one.on_first([] { throw std::runtime_error("seen"); }), std::runtime_error);
    EXPECT_EQ(one.traffic().messages, 0);
}

TEST(FieldTable, AParticlePackedAndUnpackedIsTheSame) {
    Particles from, to;
    for (Particles* p : {&from, &to}) p->allocate(With::ventilation);
    from.add(1, 2, 3, 4, 5, 6, Kind::outlet);
    from.aired[0] = Aired::yes, from.w[0] = -7;
    std::vector<std::byte> bytes(from.moved_bytes());
    EXPECT_EQ(bytes.size(), 3 * 8 + 4 * 4 + 8 + 1 + 1);
    from.pack(0, bytes.data());
    to.resize(2);
    to.unpack(1, bytes.data());
    EXPECT_EQ(to.x[1], 1);
    EXPECT_EQ(to.z[1], 3);
    EXPECT_EQ(to.w[1], -7);
    EXPECT_EQ(to.drho[1], 5);
    EXPECT_EQ(to.id[1], 6);
    EXPECT_EQ(to.kind[1], Kind::outlet);
    EXPECT_EQ(to.aired[1], Aired::yes);
}

TEST(Pencils, WhatHasOnePlaceIsOrderedByItsId) {
    const PencilGrid grid = grid_over_domain();
    const std::vector<std::int64_t> ids{5, 3, 9, 1};
    std::vector<WidePlace> places(4, fixed_point.wide({1, 1, 0.5}));
    places[2] = fixed_point.wide({1, 1, 0.2});
    std::vector<std::int32_t> order, start;
    sort_by_pencil(grid, places, order, start);
    EXPECT_EQ(order, (std::vector<std::int32_t>{2, 0, 1, 3}));
    order_coincident(
        places, start, [&](std::int32_t k) { return ids[static_cast<std::size_t>(k)]; }, order);
    EXPECT_EQ(order, (std::vector<std::int32_t>{2, 3, 1, 0}));
}

}  // namespace decomposition_test
}  // namespace tw
