#include "text/units.h"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace tw {
namespace units_test {

TEST(Units, AreWhatTheStandardsSay) {
    constexpr double exact = 1e-15;
    EXPECT_DOUBLE_EQ(quantity("30 m/s", "m/s"), 30);
    EXPECT_NEAR(quantity("5 deg", "rad"), 5 * std::numbers::pi / 180, exact);
    EXPECT_NEAR(quantity("80 kn", "m/s"), 80 * 1852.0 / 3600, 1e-13);  // international knot
    EXPECT_NEAR(quantity("300 km/h", "m/s"), 300 / 3.6, 1e-13);
    EXPECT_DOUBLE_EQ(quantity("2 GPa", "Pa"), 2e9);
    EXPECT_DOUBLE_EQ(quantity("12 mm", "m"), 0.012);
    EXPECT_NEAR(quantity("1 ft", "m"), 0.3048, exact);
    EXPECT_NEAR(quantity("1 in", "m"), 0.0254, exact);
    EXPECT_NEAR(quantity("62.42796 lb/ft^3", "kg/m3"), 1000, 1e-3);  // water in US units
    EXPECT_NEAR(quantity("1 psi", "Pa"), 6894.757293168, 1e-9);
    EXPECT_NEAR(quantity("1 cm^2/s", "m2/s"), 1e-4, 1e-18);  // the stokes
    EXPECT_NEAR(quantity("72 mN/m", "N/m"), 0.072, exact);
    EXPECT_NEAR(quantity("72.8e-3 kg/s²", "N/m"), 0.0728, exact);
    EXPECT_NEAR(quantity("1 kg m^2 s^-2", "N m"), 1, exact);
    EXPECT_NEAR(quantity("5°", "rad"), quantity("5 deg", "rad"), 0);
}

TEST(Units, TheSpellingsThatPeopleUseAreKnown) {
    constexpr double knot = 1852.0 / 3600, slug = 0.45359237 * 9.80665 / 0.3048;
    for (const char* text : {"1 kn", "1 kt", "1 kts", "1 knot", "1 knots"})
        EXPECT_NEAR(quantity(text, "m/s"), knot, 1e-15) << text;
    EXPECT_NEAR(quantity("100 kph", "m/s"), 100 / 3.6, 1e-13);
    EXPECT_NEAR(quantity("10 fps", "m/s"), 3.048, 1e-14);
    EXPECT_NEAR(quantity("1 slug", "kg"), slug, 1e-13);
    EXPECT_NEAR(slug, 14.593903, 1e-6);  // NIST SP 811
    EXPECT_NEAR(quantity("1.9403203 slug/ft3", "kg/m3"), 1000, 1e-4);
    EXPECT_NEAR(quantity("2 slugs ft^2", "kg m2"), 2 * slug * 0.3048 * 0.3048, 1e-13);
    EXPECT_NEAR(quantity("1 cSt", "m2/s"), 1e-6, 1e-20);
    EXPECT_NEAR(quantity("1 St", "m2/s"), 1e-4, 1e-18);
    EXPECT_NEAR(quantity("1 cP", "Pa s"), 1e-3, 1e-17);
    EXPECT_NEAR(quantity("1 mPa s", "Pa s"), 1e-3, 1e-17);
    EXPECT_NEAR(quantity("1 mPa·s", "Pa s"), 1e-3, 1e-17);
    EXPECT_NEAR(quantity("60 rpm", "rad/s"), 2 * std::numbers::pi, 1e-14);
    EXPECT_NEAR(quantity("30 degrees", "rad"), std::numbers::pi / 6, 1e-15);
    for (const char* text : {"10 μm", "10 µm", "10 um"}) EXPECT_NEAR(quantity(text, "m"), 1e-5, 1e-19) << text;
}

TEST(Units, PlainNumbersAreSi) {
    EXPECT_DOUBLE_EQ(quantity(" 1.5e-3 ", "m"), 1.5e-3);
    EXPECT_DOUBLE_EQ(quantity("+2", "-"), 2);
    EXPECT_DOUBLE_EQ(quantity("25 %", "-"), 0.25);
}

std::string error_of(const std::string& text, const std::string& unit) {
    try {
        quantity(text, unit);
    } catch (const UnitError& e) { return e.what(); }
    return {};
}

TEST(Units, WrongDimensionIsRefusedWithTheUnitsThatFit) {
    EXPECT_EQ(error_of("30 m", "m/s"), "'m' does not measure the right thing; expected a unit like m/s, kn, kt, mph");
    EXPECT_NE(error_of("5 deg", "-"), "");  // an angle is no plain number here
    EXPECT_NE(error_of("5 deg", "m"), "");
    EXPECT_NE(error_of("2 kg", "N"), "");
    EXPECT_NE(error_of("3 m^2", "m"), "");
    EXPECT_EQ(error_of("3 m^2/m", "m"), "");
}

TEST(Units, ADynamicViscosityIsNoKinematicOne) {
    for (const char* text : {"1e-3 Pa s", "1 cP", "1 mPa s"})
        EXPECT_NE(error_of(text, "m2/s").find("is a unit of the dynamic viscosity mu; expected the kinematic one"),
                  std::string::npos)
            << text;
    EXPECT_EQ(error_of("1 cSt", "m2/s"), "");
}

TEST(Units, NonsenseIsRefused) {
    for (const char* text : {"", "fast", "nan m", "inf", "1e999 m", "3 m/", "3 m//s", "3 m^", "3 m^99", "0x10 m",
                             "1,5 m", "3 m; rm -rf", "3 #calc"})
        EXPECT_NE(error_of(text, "m"), "") << text;
    EXPECT_NE(error_of("3 furlong", "m").find("unknown unit 'furlong'"), std::string::npos);
}

}  // namespace units_test
}  // namespace tw
