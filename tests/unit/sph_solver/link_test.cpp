#include <gtest/gtest.h>

#include "sph_solver/ghosts/ghosts.h"
#include "sph_solver/ghosts/open_boundaries.h"

namespace tw {
namespace link_test {

const Box box{Vec3(-1, 0, -1), Vec3(1, 1, 1)};
const FixedPoint fixed_point(Vec3::Zero(), 1e-6);

/// The map by which a particle at `x`, near the planes or faces `mirrors` alone, has its only image.
LinkMap map_at(const Vec3& x, const Mirrors& mirrors) {
    Particles p;
    p.add(x.x(), x.y(), x.z(), 0, 0, 0, Kind::fluid);
    const std::vector<Link> found = find_images(mirrors, box, p, 0.1);
    EXPECT_EQ(found.size(), 1u);
    EXPECT_EQ(found.at(0).index, 0);
    return LinkMaps(mirrors, box, fixed_point)[found.at(0)];
}
LinkMap behind_the_floor() {
    Mirrors mirrors;
    mirrors.on[2][0] = true;
    return map_at(Vec3(0, 0.5, -0.95), mirrors);
}
LinkMap beyond_a_periodic_side() {
    Mirrors mirrors;
    mirrors.periodic[0] = true;
    return map_at(Vec3(0.95, 0.5, 0), mirrors);
}

TEST(Link, ACornerParticleHasSevenImages) {
    Mirrors mirrors;
    mirrors.on = {{{true, false}, {true, false}, {true, false}}};
    Particles p;
    p.add(0.1, 0.1, 0.1, 1, 0, 0, Kind::fluid);
    const Box domain{Vec3::Zero(), Vec3::Constant(10)};
    EXPECT_EQ(find_images(mirrors, domain, p, 0.2).size(), 7u);
    EXPECT_EQ(find_images(mirrors, domain, p, 0.05).size(), 0u);
}

TEST(Link, AMirrorImageIsAsFarBehindThePlane) {
    const WidePlace image = behind_the_floor().place({100000, 250000, -950000});
    EXPECT_EQ(image.x, 100000);
    EXPECT_EQ(image.y, 250000);
    EXPECT_EQ(image.z, -1050000);
}

TEST(Link, APeriodicImageIsALengthOnAndUnturned) {
    const LinkMap map = beyond_a_periodic_side();
    EXPECT_EQ(map.place({950000, 250000, -3}).x, -1050000);
    EXPECT_EQ(map.place({950000, 250000, -3}).y, 250000);
    const PackedVelocityDensity u = seen<Law::vector>(PackedVelocityDensity{1, 2, 3, 4}, map);
    EXPECT_EQ(Vec3(u.u, u.v, u.w), Vec3(1, 2, 3));
    EXPECT_TRUE(map.repeats[0]);
}

TEST(Link, EachLawByValueBehindTheFloor) {
    const LinkMap map = behind_the_floor();
    EXPECT_EQ(seen<Law::scalar>(5.0f, map), 5);
    const PackedVelocityDensity u = seen<Law::vector>(PackedVelocityDensity{1, 2, 3, 4}, map);
    EXPECT_EQ(Vec3(u.u, u.v, u.w), Vec3(1, 2, -3));
    EXPECT_EQ(u.drho, 4);
    const CarriedShare t = seen<Law::tensor>(CarriedShare{1, 2, 3, 4, 5, 6}, map);
    EXPECT_EQ(Vec3(t.xx, t.yy, t.zz), Vec3(1, 4, 6));
    EXPECT_EQ(Vec3(t.xy, t.xz, t.yz), Vec3(2, -3, -5)) << "once for each index that is z";
    // 0.1 m further down under g = 10, c0 = 20: 1000 Pa and 2.5 kg/m3 more; what exceeds the line's gradient is turned
    const HydrostaticLine line{{0, 0, -25}, 2.5, 1000};
    const PackedVelocityDensity r = seen_on(line, PackedVelocityDensity{1, 2, 3, 4}, map);
    EXPECT_EQ(Vec3(r.u, r.v, r.w), Vec3(1, 2, -3));
    EXPECT_EQ(r.drho, 6.5f);
    const PackedGradientPressure s = seen_on(line, PackedGradientPressure{1, 2, -20, 300}, map);
    EXPECT_EQ(Vec3(s.gx, s.gy, s.gz), Vec3(1, 2, -30));
    EXPECT_EQ(s.p, 1300);
}

TEST(Link, BehindAWallThatHoldsTheWaterEverythingMovesAgainstIt) {
    Mirrors mirrors;
    mirrors.on[0] = mirrors.on[2] = {true, true};
    mirrors.holding[2][0] = true;
    Particles p;
    p.add(-0.95, 0.5, -0.95, 0, 0, 0, Kind::fluid);  // by the side and the floor: three images
    p.add(0, 0.5, 0.95, 0, 0, 0, Kind::fluid);       // under the lid
    const LinkMaps maps(mirrors, box, fixed_point);
    std::vector<Vec3> seen_of_first, seen_of_second;
    for (const Link& link : find_images(mirrors, box, p, 0.1)) {
        const PackedVelocityDensity u = seen<Law::held>(PackedVelocityDensity{1, 2, 3, 4}, maps[link]);
        (link.index == 0 ? seen_of_first : seen_of_second).emplace_back(u.u, u.v, u.w);
    }
    ASSERT_EQ(seen_of_first.size(), 3u);
    EXPECT_EQ(seen_of_first[0], Vec3(-1, 2, 3)) << "the side does not hold";
    EXPECT_EQ(seen_of_first[1], Vec3(-1, -2, -3)) << "the floor does";
    EXPECT_EQ(seen_of_first[2], Vec3(1, -2, -3)) << "in their corner: the side's mirror image of the floor's";
    ASSERT_EQ(seen_of_second.size(), 1u);
    EXPECT_EQ(seen_of_second[0], Vec3(1, 2, -3)) << "nor does the lid";
}

// Water at rest over a floor: the image of a particle 0.05 m above it is 0.1 m below the particle and carries the
// weight between the two. Beyond a periodic side nothing changes.
TEST(Ghosts, AreRefreshedByEachQuantitysLaw) {
    Surroundings around;
    around.domain = box;
    around.gravity = Vec3(0, 0, -10);
    around.mirrors.on[2][0] = around.mirrors.periodic[0] = true;
    LevelSetup level;
    level.dp = 0.05;
    level.rho0 = 1000;
    level.state_equation.c0 = 20;
    const FixedPoint fine(Vec3::Zero(), level.dp / (1 << 18));
    Ghosts ghosts(around, level, fine);
    Particles p;
    p.add(0, 0.5, -0.95, 0, 0, 0, Kind::fluid);
    p.add(0.95, 0.5, 0, 0, 0, 1, Kind::fluid);
    ghosts.find(p, PencilGrid(box, level.dp, 3, fine, 8), 0.1);
    ASSERT_EQ(ghosts.count(), 2u);
    p.make_room(ghosts.count());
    ASSERT_EQ(p.place.size(), 4u);
    EXPECT_EQ(p.rate.size(), 2u) << "images have no rates";
    for (std::size_t i = 0; i < 2; ++i) {
        p.place[i] = fine.wide(Vec3(p.x[i], p.y[i], p.z[i])).packed(1);
        p.velocity_density[i] = {1, 2, 3, 4};
    }
    ghosts.refresh(p, 0, p.velocity_density);
    EXPECT_TRUE(p.carried.empty()) << "without a control volume";
    for (std::size_t k = 0; k < 2; ++k) {
        const PackedVelocityDensity& seen = p.velocity_density[2 + k];
        const bool floor = ghosts.links()[k].index == 0;
        EXPECT_EQ(seen.w, floor ? -3 : 3);
        EXPECT_NEAR(double(seen.drho), floor ? 4 + 1000 * 10 * 0.1 / (20 * 20) : 4, 1e-5);
        const Vec3 x = floor ? Vec3(0, 0.5, -1.05) : Vec3(-1.05, 0.5, 0);
        EXPECT_NEAR(fine.metres(p.place[2 + k].x, 0, x.x()), x.x(), 1e-6);
        EXPECT_NEAR(fine.metres(p.place[2 + k].z, 2, x.z()), x.z(), 1e-6);
    }
    float mu[] = {7, 8, 0, 0};
    const SeeScalars see{ghosts.links().data(), ghosts.maps().data(), 2, mu};
    for (std::size_t k = 0; k < 2; ++k) see(k);
    for (std::size_t k = 0; k < 2; ++k) EXPECT_EQ(mu[2 + k], ghosts.links()[k].index == 0 ? 7 : 8);
}

TEST(Mirrors, AParticleThatCrossedAPlaneIsReturned) {
    Mirrors mirrors;
    mirrors.on = {{{false, false}, {true, true}, {false, false}}};
    Particles p;
    p.add(0, -0.02, 0, 1, 0, 0, Kind::fluid);
    p.v[0] = -3;
    EXPECT_EQ(return_from_mirrors(mirrors, {Vec3(-1, 0, -1), Vec3(1, 1, 1)}, p), 1);
    EXPECT_DOUBLE_EQ(p.y[0], 0.02);
    EXPECT_EQ(p.v[0], 3);
}

}  // namespace link_test
}  // namespace tw
