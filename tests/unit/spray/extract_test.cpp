#include <gtest/gtest.h>

#include <algorithm>

#include "base/errors.h"
#include "spray/extract/extract.h"

namespace tw::spray {
namespace extract_test {

const UniformAir still_air{AirState{}};
constexpr double dp = 0.01;

Element particle(const Vec3& place, const Vec3& velocity = Vec3::Zero()) { return {place, velocity, dp * dp * dp, dp}; }

/// A block of n^3 particles whose lowest corner is at `corner`.
void add_block(WaterFrame& frame, const Vec3& corner, int n, const Vec3& velocity = Vec3::Zero()) {
    for (int i = 0; i < n * n * n; ++i)
        frame.elements.push_back(particle(corner + dp * Vec3(i % n, i / n % n, i / n / n), velocity));
}

/// A sea of 1000 particles below z = 0.1, and above it a lump of 8, a pair that moves about itself and a single one.
WaterFrame sea_with_spray(double time = 0) {
    WaterFrame frame;
    frame.time = time;
    add_block(frame, {0, 0, 0}, 10);
    add_block(frame, {0, 0, 0.2}, 2, {1, 0, 5});
    frame.elements.push_back(particle({0.05, 0.05, 0.3}, {0, 2, 4}));
    frame.elements.push_back(particle({0.06, 0.05, 0.3}, {0, -1, 4}));
    frame.elements.push_back(particle({0.09, 0.09, 0.4}, {3, 0, 3}));
    return frame;
}

ExtractOptions options() {
    ExtractOptions o;
    o.link = 1.5;
    return o;
}

void expect_equal(const Budget& a, const Budget& b, double scale) {
    EXPECT_NEAR(a.volume, b.volume, 1e-14 * scale * b.volume + 1e-300);
    EXPECT_LT((a.momentum - b.momentum).norm(), 1e-14 * scale * (1 + b.momentum.norm()));
}

TEST(Components, AreWhatHangsTogetherByDistance) {
    const WaterFrame frame = sea_with_spray();
    const auto number = components(frame.elements, 1.5);
    EXPECT_EQ(*std::ranges::max_element(number), 3);
    EXPECT_EQ(std::ranges::count(number, 0), 1000);
    EXPECT_EQ(std::ranges::count(number, 1), 8);
    EXPECT_EQ(std::ranges::count(number, 2), 2);
    EXPECT_EQ(number[1008], number[1009]);
    // with links of 15 spacings everything is one
    EXPECT_EQ(std::ranges::count(components(frame.elements, 15), 0), 1011);
}

/// Sizes of more than one octave: a coarse cell reaches farther than a fine one, by the mean of the two.
TEST(Components, LinkByTheMeanOfTheSizes) {
    std::vector<Element> pair{{Vec3::Zero(), Vec3::Zero(), 1, 1.0}, {{1, 0, 0}, Vec3::Zero(), 1e-3, 0.1}};
    EXPECT_EQ(components(pair, 1.9)[1], 0);  // reach 1.045
    EXPECT_EQ(components(pair, 1.8)[1], 1);  // reach 0.99
    std::swap(pair[0], pair[1]);
    EXPECT_EQ(components(pair, 1.9)[0], 0);
    EXPECT_EQ(components(pair, 1.8)[0], 1);
}

TEST(Extraction, KeepsVolumeMomentumAndEnergy) {
    Extractor extractor(options(), still_air);
    extractor.look_at(sea_with_spray());
    const Extraction& e = extractor.result();
    ASSERT_EQ(e.droplets.size(), 3u);
    EXPECT_NEAR(e.droplets[0].diameter, sphere_diameter(8e-6), 1e-15);
    EXPECT_LT((e.droplets[0].place - Vec3(0.005, 0.005, 0.205)).norm(), 1e-15);
    expect_equal(e.ledger.droplets, e.ledger.taken, 10);
    // the pair turns about itself at 1.5 m/s: what a sphere does not carry is written down
    EXPECT_NEAR(e.ledger.inner_energy, 1000 * 2e-6 / 2 * 1.5 * 1.5, 1e-12);
    EXPECT_NEAR(e.ledger.droplets.kinetic_energy + e.ledger.inner_energy, e.ledger.taken.kinetic_energy, 1e-12);
    EXPECT_NEAR(e.ledger.droplets.potential_energy, e.ledger.taken.potential_energy, 1e-12);
    Budget sum = e.ledger.body;
    for (const Budget& b : {e.ledger.before_gate, e.ledger.lumps, e.ledger.crumbs, e.ledger.earlier, e.ledger.taken})
        sum += b;
    expect_equal(sum, e.ledger.all, 100);
    EXPECT_EQ(sum.pieces, 1011u);
}

TEST(Extraction, OneDropletForEachParticleCarriesAllTheKineticEnergy) {
    ExtractOptions o = options();
    o.size = DropletSize::element;
    Extractor extractor(o, still_air);
    extractor.look_at(sea_with_spray());
    EXPECT_EQ(extractor.result().droplets.size(), 11u);
    EXPECT_NEAR(extractor.result().ledger.droplets.kinetic_energy, extractor.result().ledger.taken.kinetic_energy,
                1e-13);
}

TEST(Extraction, SizeLimitsLeaveTheRestInTheLedger) {
    ExtractOptions o = options();
    o.fewest = 2;
    o.largest_diameter = 0.02;
    Extractor extractor(o, still_air);
    extractor.look_at(sea_with_spray());
    const Ledger& l = extractor.result().ledger;
    EXPECT_EQ(l.taken.pieces, 2u);
    EXPECT_EQ(l.crumbs.pieces, 1u);
    EXPECT_EQ(l.lumps.pieces, 8u);
}

TEST(Breakup, FragmentsKeepVolumeMomentumAndCentreAndObeyTheWeberLimit) {
    ExtractOptions o = options();
    o.size = DropletSize::breakup;
    const UniformAir wind{AirState{.velocity = {30, 0, 0}}};
    Extractor extractor(o, wind);
    extractor.look_at(sea_with_spray());
    const Extraction& e = extractor.result();
    EXPECT_GT(e.droplets.size(), 20u);
    expect_equal(e.ledger.droplets, e.ledger.taken, 1e3);
    for (const Droplet& d : e.droplets) {
        const double slip = (d.velocity - Vec3(30, 0, 0)).norm();
        EXPECT_LE(1.225 * slip * slip * d.diameter / 0.0728, 12 * (1 + 1e-12));
    }
    EXPECT_NEAR(e.ledger.shifted_energy, 0, 1e-12);  // the centre of mass stays
}

/// The volume of many fragments follows Rosin and Rammler's law within what 1e4 of them can show.
TEST(Breakup, VolumesFollowRosinAndRammler) {
    std::mt19937_64 random(3);
    const BreakupOptions o;
    const double d_max = 2e-3, volume = 4e-5;
    const auto d = fragments(volume, d_max, o, random);
    double sum = 0;
    for (const double one : d) sum += sphere_volume(one);
    EXPECT_NEAR(sum, volume, 1e-12 * volume);
    const double x = d_max / std::cbrt(std::log(1000.0));
    for (const double share : {0.3, 0.5, 0.7}) {
        double below = 0;
        for (const double one : d) below += one < share * d_max ? sphere_volume(one) : 0;
        EXPECT_NEAR(below / volume, 1 - std::exp(-std::pow(share * d_max / x, 3)), 0.02) << share;
    }
    // the same seed gives the same fragments
    std::mt19937_64 again(3);
    EXPECT_EQ(fragments(volume, d_max, o, again), d);
}

/// Particles thrown up through a plane, seen at frames of 0.01 s: each is taken once, at the frame after its passage.
TEST(Gate, FreelyFlyingWaterIsTakenOnce) {
    ExtractOptions o = options();
    o.gate = Gate::plane({0, 0, 1}, {0, 0, 1});
    Extractor extractor(o, still_air);
    const Vec3 g(0, 0, -9.81);
    std::vector<Element> thrown;
    for (int i = 0; i < 40; ++i) thrown.push_back(particle({0.1 * i, 0, 0.5 - 0.02 * i}, {0, 0, 3.0 + 0.1 * i}));
    int pass = 0;
    const auto at = [&](double t) {
        WaterFrame frame;
        frame.time = t;
        add_block(frame, {-5, -5, -5}, 10);
        for (Element e : thrown) {
            e.place += t * e.velocity + 0.5 * t * t * g;
            e.velocity += t * g;
            frame.elements.push_back(e);
        }
        return frame;
    };
    for (int n = 0; n <= 60; ++n) extractor.look_at(at(0.01 * n));
    double back = 0;
    for (const Element& e : thrown) {
        const auto height = [&](int n) { return e.place.z() + 0.01 * n * e.velocity.z() - 0.5 * 1e-4 * n * n * 9.81; };
        bool went = false;
        for (int n = 1; n <= 60; ++n) {
            went = went || (height(n) > 1 && height(n - 1) <= 1);
            if (height(n) <= 1 && height(n - 1) > 1) back += e.volume;
        }
        pass += went;
    }
    EXPECT_GT(pass, 10);
    EXPECT_LT(pass, 40);
    EXPECT_EQ(static_cast<int>(extractor.result().droplets.size()), pass);
    EXPECT_NEAR(extractor.result().ledger.returned, back, 1e-15);
    EXPECT_GT(back, 0);
}

/// 400 particles of the sea stand above z = 0.055, and the eleven of the spray.
TEST(Extraction, AttachedWaterBeyondTheGateIsTakenParticleByParticle) {
    ExtractOptions o = options();
    o.gate = Gate::plane({0, 0, 0.055}, {0, 0, 1});
    o.already_beyond = true;
    Extractor detached(o, still_air);
    detached.look_at(sea_with_spray());
    EXPECT_EQ(detached.result().droplets.size(), 3u);
    o.attached = true;
    Extractor attached(o, still_air);
    attached.look_at(sea_with_spray());
    const Ledger& l = attached.result().ledger;
    EXPECT_EQ(attached.result().droplets.size(), 411u);
    EXPECT_EQ(l.taken.pieces, 411u);
    EXPECT_EQ(l.before_gate.pieces, 600u);
    EXPECT_EQ(l.body.pieces, 0u);
    expect_equal(l.droplets, l.taken, 1000);
    EXPECT_NEAR(l.droplets.kinetic_energy, l.taken.kinetic_energy, 1e-12);
    EXPECT_EQ(l.inner_energy, 0);
}

/// What stands beyond the gate from the start counts once or never, as is asked.
TEST(Gate, WhatIsBeyondAtTheFirstFrameIsTakenOnlyIfAsked) {
    for (const bool asked : {false, true}) {
        ExtractOptions o = options();
        o.gate = Gate::plane({0, 0, 0.15}, {0, 0, 1});
        o.gravity = Vec3::Zero();
        o.already_beyond = asked;
        Extractor extractor(o, still_air);
        extractor.look_at(sea_with_spray(0));
        EXPECT_EQ(extractor.result().droplets.size(), asked ? 3u : 0u);
        WaterFrame later = sea_with_spray(0.01);
        for (Element& e : later.elements) e.place += 0.01 * e.velocity;
        extractor.look_at(later);
        EXPECT_EQ(extractor.result().droplets.size(), asked ? 3u : 0u);
    }
}

TEST(Gate, ASurfaceIsPassedFromInside) {
    const Surface box{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}, {1, 0, 1}, {1, 1, 1}, {0, 1, 1}},
                      {{0, 2, 1},
                       {0, 3, 2},
                       {4, 5, 6},
                       {4, 6, 7},
                       {0, 1, 5},
                       {0, 5, 4},
                       {2, 3, 7},
                       {2, 7, 6},
                       {0, 4, 7},
                       {0, 7, 3},
                       {1, 2, 6},
                       {1, 6, 5}}};
    const Gate gate = Gate::surface(box);
    EXPECT_FALSE(gate.beyond({0.5, 0.5, 0.5}));
    EXPECT_TRUE(gate.beyond({0.5, 0.5, 1.5}));
}

TEST(Extraction, RefusesToTakeTheSameWaterTwice) {
    Extractor open(options(), still_air);
    open.look_at(sea_with_spray(0));
    EXPECT_THROW(open.look_at(sea_with_spray(1)), InputError);
    ExtractOptions o = options();
    o.gate = Gate::plane({0, 0, 1}, {0, 0, 1});
    Extractor gated(o, still_air);
    gated.look_at(sea_with_spray(1));
    EXPECT_THROW(gated.look_at(sea_with_spray(1)), InputError);
    o.link = 0;
    Extractor wrong(o, still_air);
    EXPECT_THROW(wrong.look_at(sea_with_spray()), InputError);
}

}  // namespace extract_test
}  // namespace tw::spray
