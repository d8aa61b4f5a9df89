#include <gtest/gtest.h>

#include "spray/flight/fly.h"
#include "tests/verification/spray/table.h"

namespace tw::spray {
namespace flight_test {

FlightOptions still(double end_time, bool gravity) {
    FlightOptions o;
    o.end_time = end_time;
    o.falls_back = false;
    if (!gravity) o.forces.gravity = Vec3::Zero();
    return o;
}

const UniformAir still_air{AirState{}};

/// A droplet that falls long enough reaches the speed at which drag carries its weight less the air's, which this table
/// (not the trajectories) takes off. Without it the speed is sqrt(1 + rho_a / rho_w) too high, 6e-4: the test sees that.
TEST(Flight, FallingDropletsReachTheirTerminalSpeed) {
    const auto t = table("droplet_terminal_velocity_schiller_naumann.csv");
    for (std::size_t i = 0; i < t.at("diameter_m").size(); ++i) {
        const Droplet d{.diameter = t.at("diameter_m")[i]};
        FlightOptions o = still(30, true);
        const double heavy = -fly({&d, 1}, still_air, {}, o).front().velocity.z();
        o.forces.buoyancy = true;
        const Landing end = fly({&d, 1}, still_air, {}, o).front();
        EXPECT_GT(heavy / t.at("v_terminal_m_per_s")[i], 1 + 5e-4);
        EXPECT_NEAR(-end.velocity.z() / t.at("v_terminal_m_per_s")[i], 1, 1e-5) << d.diameter << " m";
        EXPECT_EQ(end.velocity.x(), 0);
    }
}

TEST(Flight, DropletsSlowDownAlongALineAsTheClosedFormSays) {
    const auto t = table("droplet_1d_deceleration_no_gravity.csv");
    for (std::size_t i = 0; i < t.at("diameter_m").size(); ++i) {
        const Droplet d{.velocity = {t.at("v0_m_per_s")[i], 0, 0}, .diameter = t.at("diameter_m")[i]};
        const Landing end = fly({&d, 1}, still_air, {}, still(t.at("t_s")[i], false)).front();
        EXPECT_NEAR(end.velocity.x(), t.at("v_m_per_s")[i], 1e-5 * d.velocity.x());
        EXPECT_NEAR(end.place.x(), t.at("x_m")[i], 1e-5 * (1e-3 + t.at("x_m")[i]));
    }
}

/// Throws at an angle, with and without gravity; the largest difference of a place over the way flown.
double largest_difference(double tolerance) {
    const auto t = table("droplet_trajectories.csv");
    double worst = 0;
    for (std::size_t i = 0; i < t.at("diameter_m").size(); ++i) {
        const double angle = t.at("angle_deg")[i] * std::numbers::pi / 180, v0 = t.at("v0_m_per_s")[i];
        const Droplet d{.velocity = {v0 * std::cos(angle), 0, v0 * std::sin(angle)}, .diameter = t.at("diameter_m")[i]};
        FlightOptions o = still(t.at("t_s")[i], t.at("gravity_on")[i] > 0);
        o.tolerance = tolerance;
        const Landing end = fly({&d, 1}, still_air, {}, o).front();
        const Vec3 place(t.at("x_m")[i], 0, t.at("z_m")[i]), velocity(t.at("vx_m_per_s")[i], 0, t.at("vz_m_per_s")[i]);
        worst = std::max(worst, (end.place - place).norm() / (1e-3 + place.norm()));
        worst = std::max(worst, (end.velocity - velocity).norm() / v0);
    }
    return worst;
}

TEST(Flight, ThrownDropletsFollowTheTabledTrajectories) {
    const double fine = largest_difference(1e-6);
    RecordProperty("largest_difference", std::to_string(fine));
    EXPECT_LT(fine, 2e-6);
    EXPECT_GT(largest_difference(1e-3), 1e-5);  // or this test sees nothing of the integrator
}

/// Gravity makes a difference to these tables, so leaving it out (as Eq. 22 of the study does) would be seen.
TEST(Flight, GravityIsSeenInTheTables) {
    const Droplet d{.velocity = {10, 0, 10}, .diameter = 1e-3};
    const Landing with = fly({&d, 1}, still_air, {}, still(0.5, true)).front();
    const Landing without = fly({&d, 1}, still_air, {}, still(0.5, false)).front();
    EXPECT_GT(without.place.z() - with.place.z(), 0.5);
}

}  // namespace flight_test
}  // namespace tw::spray
