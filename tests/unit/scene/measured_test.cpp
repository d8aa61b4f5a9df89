// Sections [[measured]]: what is read of them, what they leave alone, and what is refused.
#include "record/measured_value.h"

#include <numbers>

#include "record/run_record.h"
#include "scene/hash.h"
#include "scene/new_record.h"
#include "scene_text.h"

namespace tw::test {
namespace measured_test {

std::string measured(const std::string& lines) { return planing + "[[measured]]\n" + lines; }
const std::string source = "source = \"Fridsma 1969\"\n";

TEST(Measured, StandInTheRecordInSIUnitsAndChangeNoHash) {
    const Scene scene = scene_of(
        measured("quantity = \"lift\"\nvalue = \"7.125 kN\"\nuncertainty = \"4 %\"\n" + source +
                 "[[measured]]\nquantity = \"running_trim\"\nvalue = \"4 deg\"\nuncertainty = \"0.1 deg\"\n" + source));
    const std::vector<MeasuredValue> values = measured_values(new_record(scene, "sph"));
    ASSERT_EQ(values.size(), 2u);
    EXPECT_EQ(values[0].quantity, "lift");
    EXPECT_EQ(values[0].unit, "kN");
    EXPECT_EQ(values[0].source, "Fridsma 1969");
    EXPECT_NEAR(values[0].value, 7125, 1e-9);
    EXPECT_NEAR(values[0].half_width, 285, 1e-9);
    EXPECT_NEAR(values[1].value, 4 * std::numbers::pi / 180, 1e-12);
    EXPECT_NEAR(values[1].half_width, 0.1 * std::numbers::pi / 180, 1e-12);
    EXPECT_EQ(scene.hash, scene_of(planing).hash) << "a measurement steers nothing";
    EXPECT_EQ(run_hash(scene, "sph"), run_hash(scene_of(planing), "sph"));
}

TEST(Measured, MayBeOfAQuantityOfABody) {
    const std::vector<MeasuredValue> values = measured_values(
        new_record(scene_of(measured("quantity = \"heave_response:hull\"\nvalue = \"1.23\"\n" + source)), "sph"));
    ASSERT_EQ(values.size(), 1u);
    EXPECT_EQ(values[0].quantity, "heave_response:hull");
    EXPECT_EQ(values[0].value, 1.23);
    for (const char* name : {"1lift", ":lift", "a b", "lift;rm", "../lift", "lift$(x)"})
        EXPECT_NE(complaint(measured("quantity = \"" + std::string(name) + "\"\nvalue = \"1\"\n" + source))
                      .find("of letters, digits, '_' and ':'"),
                  std::string::npos)
            << name;
}

TEST(Measured, ThatAreNotWholeAreRefusedInWords) {
    const std::string value = "quantity = \"lift\"\nvalue = \"71.25 N\"\n";
    const auto says = [&](const std::string& lines, const char* what) {
        const std::string message = complaint(measured(lines));
        EXPECT_NE(message.find(what), std::string::npos) << message;
    };
    says("value = \"71.25 N\"\n" + source, "missing; expected the name of a quantity");
    says("quantity = \"lift\"\n" + source, "missing; expected the measured value with its unit");
    says(value, "missing; expected who measured it");
    says("quantity = \"lift\"\nvalue = \"many N\"\n" + source, "value");
    says(value + "uncertainty = \"3 m\"\n" + source, "uncertainty");
    says(value + "uncertainty = \"-3 N\"\n" + source, "half width above 0");
    says(value + source + "[[measured]]\n" + value + source, "lift has a measured value already");
}

std::vector<double> values_of(const std::string& text, const SceneOverrides& changed = {}) {
    std::vector<double> values;
    for (const MeasuredValue& m : scene_of(text, changed).measured) values.push_back(m.value);
    return values;
}

TEST(Measured, BelongToTheirSpeed) {
    const auto at = [](const std::string& value, const std::string& speed) {
        return "[[measured]]\nquantity = \"lift\"\nvalue = \"" + value + "\"\n" + source +
               (speed.empty() ? "" : "speed = \"" + speed + "\"\n");
    };
    SceneOverrides slower, swapped;
    slower.speed = 6;
    swapped.trim = 0.1;
    const std::string own = planing + at("70 N", "");
    EXPECT_EQ(values_of(own), std::vector{70.0});
    EXPECT_TRUE(values_of(own, slower).empty()) << "what was measured at one speed is not shown at another";
    EXPECT_TRUE(values_of(own, swapped).empty()) << "nor at another trim";
    EXPECT_EQ(scene_of(own, slower).measured_of_others, 1u);
    const std::string two = planing + at("70 N", "8 m/s") + at("40 N", "6 m/s");
    EXPECT_EQ(values_of(two, slower), std::vector{40.0});
    EXPECT_NE(complaint(planing + at("70 N", "8 m/s") + at("71 N", "8.01 m/s")).find("its own speed or wave_length"),
              std::string::npos);
    EXPECT_NE(complaint(planing + at("70 N", "8 m/s") + at("71 N", "")).find("its own speed or wave_length"),
              std::string::npos);
    EXPECT_NE(complaint(planing + at("70 N", "") + "wave_length = 2\n").find("there is no regular wave"),
              std::string::npos);
}

TEST(Measured, BelongToTheirWave) {
    const std::string wave =
        "[motion]\nkind = \"stream\"\nspeed = 0.6\n[domain]\nx = [-1, 1]\nz = [-0.4, 0.15]\n"
        "dimensions = 2\n[water]\ndepth = 0.4\n[wave]\nheight = 0.04\nperiod = 0.8\n"
        "[resolution]\nnear_hull = 0.01\n";
    const auto in = [](const std::string& value, const std::string& length) {
        return "[[measured]]\nquantity = \"wave_drift_x\"\nvalue = \"" + value + "\"\n" + source +
               "wave_length = " + length + "\n";
    };
    SceneOverrides longer;
    longer.wave_length = 1.2;
    EXPECT_TRUE(values_of(wave + in("3 N/m", "0.8") + in("4 N/m", "1.2")).empty()) << "0.8 s are 1.0 m";
    EXPECT_EQ(values_of(wave + in("3 N/m", "0.8") + in("4 N/m", "1.2"), longer), std::vector{4.0});
    EXPECT_NEAR(scene_of(wave, longer).wave->length, 1.2, 1e-12);
    EXPECT_NE(complaint(planing, longer).find("a wave needs its height"), std::string::npos) << "there is none";
}

}  // namespace measured_test
}  // namespace tw::test
