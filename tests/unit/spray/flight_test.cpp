#include <gtest/gtest.h>

#include <atomic>
#include <mutex>

#include "base/errors.h"
#include "meshes/generate.h"
#include "spray/flight/fly.h"

namespace tw::spray {
namespace flight_test {

const UniformAir still_air{AirState{}};

/// A panel of 1 m in the plane x = 2, of two triangles.
Surface panel() { return {{{2, -0.5, -0.5}, {2, 0.5, -0.5}, {2, 0.5, 0.5}, {2, -0.5, 0.5}}, {{0, 1, 2}, {0, 2, 3}}}; }

FlightOptions without_water(double end_time) {
    FlightOptions o;
    o.end_time = end_time;
    o.falls_back = false;
    return o;
}

TEST(Hits, APanelIsHitWhereThePathMeetsIt) {
    const FirstHit surface(panel());
    const Target target{"panel", &surface};
    FlightOptions o = without_water(1);
    o.forces.gravity = Vec3::Zero();
    const Droplet d{.velocity = {20, 0, 2}, .diameter = 2e-3};
    const Landing hit = fly({&d, 1}, still_air, {&target, 1}, o).front();
    ASSERT_EQ(hit.fate, Fate::hit);
    EXPECT_NEAR(hit.place.x(), 2, 1e-9);
    EXPECT_NEAR(hit.place.z(), 0.2, 1e-9);  // drag does not turn a path
    EXPECT_NEAR(hit.normal_speed, hit.velocity.x(), 1e-12);
    EXPECT_NEAR(hit.angle, std::atan2(10, 1), 1e-9);
    // the same flight without a target, ended at that time, is at the same place
    o.end_time = hit.time;
    EXPECT_LT((fly({&d, 1}, still_air, {}, o).front().place - hit.place).norm(), 1e-5);
}

/// A curved path over the panel's upper edge and down behind it: straight chords from start to end would hit.
TEST(Hits, ACurvedPathPassesOverAnEdge) {
    const FirstHit surface(panel());
    const Target target{"panel", &surface};
    const Droplet over{.place = {0, 0, -0.4}, .velocity = {4, 0, 6}, .diameter = 4e-3};
    const Landing end = fly({&over, 1}, still_air, {&target, 1}, without_water(1.2)).front();
    EXPECT_EQ(end.fate, Fate::flying);
    EXPECT_GT(end.place.x(), 2);
    const Droplet into{.place = {0, 0, -0.4}, .velocity = {4, 0, 3}, .diameter = 4e-3};
    EXPECT_EQ(fly({&into, 1}, still_air, {&target, 1}, without_water(1.2)).front().fate, Fate::hit);
}

TEST(Hits, EveryDropletOfAStreamAtAClosedSurfaceHitsItsFront) {
    const Surface ball = make_hull("sphere", {{"diameter", 1.0}});
    const FirstHit surface(ball);
    const Target target{"ball", &surface};
    const Vec3 centre = (surface.bounds().min + surface.bounds().max) / 2;
    std::vector<Droplet> stream;
    for (int i = -20; i <= 20; ++i)
        for (int j = -20; j <= 20; ++j)
            if (i * i + j * j < 19 * 19)
                stream.push_back(
                    {.place = centre + Vec3(-1, 0.025 * i, 0.025 * j), .velocity = {10, 0, 0}, .diameter = 1e-3});
    FlightOptions o = without_water(1);
    o.forces.gravity = Vec3::Zero();
    for (const Landing& l : fly(stream, still_air, {&target, 1}, o)) {
        ASSERT_EQ(l.fate, Fate::hit);
        EXPECT_LT(l.place.x(), centre.x());
    }
}

TEST(Flight, EndsAtTheWaterAndAtTheEdgeOfTheAir) {
    FlightOptions o;
    o.end_time = 5;
    const Droplet d{.place = {0, 0, 0.5}, .velocity = {1, 0, 4}, .diameter = 2e-3};
    const Landing back = fly({&d, 1}, still_air, {}, o).front();
    EXPECT_EQ(back.fate, Fate::fell_back);
    EXPECT_NEAR(back.place.z(), 0, 1e-9);
    EXPECT_LT(back.velocity.z(), 0);
    const AirTable low({{0, {}}, {1, {}}});
    const Landing out = fly({&d, 1}, low, {}, o).front();
    EXPECT_EQ(out.fate, Fate::left_air);
    EXPECT_NEAR(out.place.z(), 1, 1e-6);
    EXPECT_GT(out.velocity.z(), 0);
}

TEST(Flight, AirCarriesMistAlong) {
    const UniformAir wind{AirState{.velocity = {7, 0, 0}}};
    const Droplet mist{.diameter = 5e-5};
    FlightOptions o = without_water(0.5);
    o.forces.buoyancy = true;
    const Landing end = fly({&mist, 1}, wind, {}, o).front();
    EXPECT_NEAR(end.velocity.x(), 7, 7e-6);
    EXPECT_NEAR(end.velocity.z(), -0.0711696, 7e-6);  // its terminal speed; tolerance 1e-6 of the whole speed
}

TEST(Flight, BuoyancyIsTheWeightOfTheAir) {
    const Droplet drop{.diameter = 1e-4};
    FlightOptions o = without_water(5);
    const double dry = fly({&drop, 1}, still_air, {}, o).front().velocity.z();
    o.forces.buoyancy = true;
    const double buoyant = fly({&drop, 1}, still_air, {}, o).front().velocity.z();
    // 0.1 mm falls nearly by Stokes's law, where speed goes with weight
    EXPECT_NEAR(1 - buoyant / dry, 1.225e-3, 0.2e-3);
}

/// Places handed out between steps lie on the path that ends there.
TEST(Flight, SampledPlacesLieOnThePath) {
    FlightOptions o = without_water(0.4);
    o.sample = 0.1;
    const Droplet d{.velocity = {12, 0, 3}, .diameter = 1e-3, .time = 0.05};
    std::vector<std::pair<double, Vec3>> seen;
    fly({&d, 1}, still_air, {}, o, [&](std::size_t, double t, const Vec3& x, const Vec3&) { seen.emplace_back(t, x); });
    ASSERT_GE(seen.size(), 3u);
    EXPECT_NEAR(seen.front().first, 0.1, 1e-12);
    for (const auto& [time, place] : seen) {
        FlightOptions until = without_water(time);
        EXPECT_LT((fly({&d, 1}, still_air, {}, until).front().place - place).norm(), 2e-5) << time;
    }
}

TEST(Flight, RefusesDropletsThatCannotBe) {
    for (const double diameter : {0.0, -1e-3, std::nan("")}) {
        const Droplet d{.diameter = diameter};
        EXPECT_THROW(fly({&d, 1}, still_air, {}, without_water(1)), InputError);
    }
    const Droplet lost{.place = {std::nan(""), 0, 0}, .diameter = 1e-3};
    EXPECT_THROW(fly({&lost, 1}, still_air, {}, without_water(1)), InputError);
}

}  // namespace flight_test
}  // namespace tw::spray
