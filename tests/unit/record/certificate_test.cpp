#include "record/certificate.h"
#include "record/body_work.h"
#include "record/tank_table.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tw {
namespace certificate_test {

TEST(Certificate, KeepsTheWorstWithItsTimeAndPlace) {
    RunRecord r;
    note_worst(r, {"Mach number", "-", 0.1, 1, 0.5, {1, 0, 0}});
    note_worst(r, {"Mach number", "-", 0.3, 1, 0.7, {2, 0, 0}});
    note_worst(r, {"Mach number", "-", 0.2, 1, 0.9, {3, 0, 0}});
    ASSERT_EQ(r.certificate.size(), 1u);
    EXPECT_EQ(r.certificate[0].value, 0.3);
    EXPECT_EQ(r.certificate[0].time, 0.7);
    EXPECT_EQ(r.certificate[0].place.x(), 2);
    EXPECT_TRUE(r.certificate[0].met());
    note_worst(r, {"Mach number", "-", std::nan(""), 1, 1.0});
    EXPECT_FALSE(r.certificate[0].met());  // not a number is the worst of all
}

/// A tank's frames with the given kinetic energies; 100 J of potential energy turn into them.
RunRecord tank(const std::vector<double>& kinetic, double made) {
    RunRecord r;
    r.attributes["motion"] = "none";
    Table& t = r.table("samples");
    for (std::size_t i = 0; i < kinetic.size(); ++i) {
        t.time.push_back(0.1 * static_cast<double>(i));
        t.column("kinetic_energy", "J").values.push_back(kinetic[i]);
        t.column("potential_energy", "J").values.push_back(100 - kinetic[i] + (i + 1 == kinetic.size() ? made : 0));
        watch_energy(r);
    }
    return r;
}

TEST(Certificate, EnergyThatTurnsIntoMotionIsNotMade) {
    const RunRecord r = tank({0, 20, 40}, 0);
    ASSERT_EQ(r.certificate.size(), 1u);
    EXPECT_NEAR(r.certificate[0].value, 0, 1e-12);
    EXPECT_TRUE(r.certificate[0].met());
}

TEST(Certificate, EnergyFromNothingIsToldWithItsTime) {
    const RunRecord r = tank({0, 20, 40}, 3);
    EXPECT_NEAR(r.certificate[0].value, 3, 1e-12);
    EXPECT_NEAR(r.certificate[0].time, 0.2, 1e-12);
    EXPECT_FALSE(r.certificate[0].met());
}

TEST(Certificate, WhatATankThatMovesHasGivenIsNotMade) {
    RunRecord r = tank({0, 20, 40}, 3);
    Table& t = r.table(tank_table);
    t.time = r.tables.at("samples").time;
    t.column(tank_work, "J").values = {1, 1, 4};  // 3 J between the first frame and the last
    r.certificate.clear();
    watch_energy(r);
    EXPECT_NEAR(r.certificate[0].value, 0, 1e-12);
}

TEST(Certificate, WhatBodiesHaveGivenTheWaterIsNotMade) {
    RunRecord r = tank({0, 20, 40}, 3);
    Table& body = r.table(body_table("stone"));
    body.time = {0.0, 0.05, 0.15, 0.2};  // rows of its own, one at each frame but the second
    body.column(body_work, "J").values = {1, 0, -1, -2};
    r.certificate.clear();
    watch_energy(r);
    EXPECT_NEAR(r.certificate[0].value, 0, 1e-12);
    r.certificate.clear();
    body.column(body_work, "J").values.back() = 1;  // it has not slowed
    watch_energy(r);
    EXPECT_NEAR(r.certificate[0].value, 3, 1e-12);
}

TEST(Certificate, ASurfaceThatShrinksGivesItsEnergyAndNoMore) {
    RunRecord r = tank({0, 20, 40}, 30);
    r.certificate.clear();
    r.numbers[energy_of_surface] = 25;
    watch_energy(r);
    EXPECT_NEAR(r.certificate[0].value, 100 * 5.0 / 125, 1e-12);
    r.certificate.clear();
    r.numbers[energy_of_surface] = 40;
    watch_energy(r);
    EXPECT_TRUE(r.certificate[0].met());
    // without weight it is all the energy that there is
    for (double& p : r.table("samples").column("potential_energy", "J").values) p = 0;
    r.certificate.clear();
    r.numbers[energy_of_surface] = 10;
    watch_energy(r);
    ASSERT_EQ(r.certificate.size(), 1u);
    EXPECT_NEAR(r.certificate[0].value, 100 * 30.0 / 10, 1e-12);
}

TEST(Certificate, AStreamBringsItsOwnEnergy) {
    RunRecord r = tank({0, 20}, 50);
    r.certificate.clear();
    r.attributes["motion"] = "stream";
    watch_energy(r);
    EXPECT_TRUE(r.certificate.empty());
}

}  // namespace certificate_test
}  // namespace tw
