#include "record/recorded_checks.h"
#include "record/body_work.h"
#include "record/tank_table.h"

#include <gtest/gtest.h>

#include <cmath>

namespace tw {
namespace validity_checks_test {

TEST(ValidityChecks, KeepsTheWorstWithItsTimeAndPlace) {
    RunRecord r;
    note_worst(r, {"Mach number", "-", 0.1, 1, 0.5, {1, 0, 0}});
    note_worst(r, {"Mach number", "-", 0.3, 1, 0.7, {2, 0, 0}});
    note_worst(r, {"Mach number", "-", 0.2, 1, 0.9, {3, 0, 0}});
    ASSERT_EQ(r.validity_checks.size(), 1u);
    EXPECT_EQ(r.validity_checks[0].value, 0.3);
    EXPECT_EQ(r.validity_checks[0].time, 0.7);
    EXPECT_EQ(r.validity_checks[0].place.x(), 2);
    EXPECT_TRUE(r.validity_checks[0].met());
    note_worst(r, {"Mach number", "-", std::nan(""), 1, 1.0});
    EXPECT_FALSE(r.validity_checks[0].met());  // not a number is the worst of all
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

TEST(ValidityChecks, EnergyThatTurnsIntoMotionIsNotMade) {
    const RunRecord r = tank({0, 20, 40}, 0);
    ASSERT_EQ(r.validity_checks.size(), 1u);
    EXPECT_NEAR(r.validity_checks[0].value, 0, 1e-12);
    EXPECT_TRUE(r.validity_checks[0].met());
}

TEST(ValidityChecks, EnergyFromNothingIsToldWithItsTime) {
    const RunRecord r = tank({0, 20, 40}, 3);
    EXPECT_NEAR(r.validity_checks[0].value, 3, 1e-12);
    EXPECT_NEAR(r.validity_checks[0].time, 0.2, 1e-12);
    EXPECT_FALSE(r.validity_checks[0].met());
}

TEST(ValidityChecks, WhatATankThatMovesHasGivenIsNotMade) {
    RunRecord r = tank({0, 20, 40}, 3);
    Table& t = r.table(tank_table);
    t.time = r.tables.at("samples").time;
    t.column(tank_work, "J").values = {1, 1, 4};  // 3 J between the first frame and the last
    r.validity_checks.clear();
    watch_energy(r);
    EXPECT_NEAR(r.validity_checks[0].value, 0, 1e-12);
}

TEST(ValidityChecks, WhatBodiesHaveGivenTheWaterIsNotMade) {
    RunRecord r = tank({0, 20, 40}, 3);
    Table& body = r.table(body_table("stone"));
    body.time = {0.0, 0.05, 0.15, 0.2};  // rows of its own, one at each frame but the second
    body.column(body_work, "J").values = {1, 0, -1, -2};
    r.validity_checks.clear();
    watch_energy(r);
    EXPECT_NEAR(r.validity_checks[0].value, 0, 1e-12);
    r.validity_checks.clear();
    body.column(body_work, "J").values.back() = 1;  // it has not slowed
    watch_energy(r);
    EXPECT_NEAR(r.validity_checks[0].value, 3, 1e-12);
}

TEST(ValidityChecks, ASurfaceThatShrinksGivesItsEnergyAndNoMore) {
    RunRecord r = tank({0, 20, 40}, 30);
    r.validity_checks.clear();
    r.numbers[energy_of_surface] = 25;
    watch_energy(r);
    EXPECT_NEAR(r.validity_checks[0].value, 100 * 5.0 / 125, 1e-12);
    r.validity_checks.clear();
    r.numbers[energy_of_surface] = 40;
    watch_energy(r);
    EXPECT_TRUE(r.validity_checks[0].met());
    // without weight it is all the energy that there is
    for (double& p : r.table("samples").column("potential_energy", "J").values) p = 0;
    r.validity_checks.clear();
    r.numbers[energy_of_surface] = 10;
    watch_energy(r);
    ASSERT_EQ(r.validity_checks.size(), 1u);
    EXPECT_NEAR(r.validity_checks[0].value, 100 * 30.0 / 10, 1e-12);
}

TEST(ValidityChecks, AStreamBringsItsOwnEnergy) {
    RunRecord r = tank({0, 20}, 50);
    r.validity_checks.clear();
    r.attributes["motion"] = "stream";
    watch_energy(r);
    EXPECT_TRUE(r.validity_checks.empty());
}

}  // namespace validity_checks_test
}  // namespace tw
