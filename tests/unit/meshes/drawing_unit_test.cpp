#include "meshes/read/drawing_unit.h"

#include <gtest/gtest.h>

#include "test_paths.h"

namespace tw {
namespace drawing_unit_test {

const std::filesystem::path drawings = std::filesystem::path(TWINWAKE_TEST_DATA) / "drawings";

TEST(DrawingUnit, IsWhatTheHeaderOfAStepFileSays) {
    const auto of = [](const std::string& unit) {
        return unit_of_step("DATA;\n#1=CARTESIAN_POINT('',(0.,0.,0.));\n" + unit + "\nENDSEC;\n");
    };
    EXPECT_EQ(of("#2=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));"), "millimetres");
    EXPECT_EQ(of("#2 = ( LENGTH_UNIT ( ) NAMED_UNIT ( * ) SI_UNIT ( $ , .METRE. ) );"), "metres");
    EXPECT_EQ(of("#2=(LENGTH_UNIT()\nNAMED_UNIT(*)\nSI_UNIT(.CENTI.,.METRE.));"), "centimetres");
    // an inch is so many millimetres, whose unit is in the file too
    EXPECT_EQ(
        of("#2=(LENGTH_UNIT()NAMED_UNIT(*)SI_UNIT(.MILLI.,.METRE.));\n#3=LENGTH_MEASURE_WITH_UNIT(LENGTH_MEASURE(25.4),"
           "#2);\n#4=(CONVERSION_BASED_UNIT('INCH',#3)LENGTH_UNIT()NAMED_UNIT(#5));"),
        "inches");
    EXPECT_EQ(of("#2=(NAMED_UNIT(*)PLANE_ANGLE_UNIT()SI_UNIT($,.RADIAN.));"), "units that it does not name");
    EXPECT_EQ(unit_of_step(""), "units that it does not name");
}

TEST(DrawingUnit, IsTheFlagInTheGlobalSectionOfAnIgesFile) {
    const auto of = [](const std::string& flag) {
        std::string text = "1H,,1H;,7Htest,hu,5Hh.igs,4Htest,1H1,32,38,7,38,15,,1.," + flag + ",2HMM,1,0.01,;";
        std::string lines = std::string(72, ' ') + "S      1\n";
        for (std::size_t at = 0; at < text.size(); at += 72) {
            std::string line = text.substr(at, 72);
            line.resize(72, ' ');
            lines += line + "G      1\n";
        }
        return unit_of_iges(lines + std::string(72, ' ') + "D      1\n");
    };
    EXPECT_EQ(of("2"), "millimetres");
    EXPECT_EQ(of("6"), "metres");
    EXPECT_EQ(of("1"), "inches");
    EXPECT_EQ(of("4"), "feet");
    EXPECT_EQ(of("3"), "the unit \"MM\"");
    EXPECT_EQ(of(""), "inches");  // the standard's default
    EXPECT_EQ(of("99"), "units that it does not name");
    EXPECT_EQ(unit_of_iges("no lines of 80 columns"), "units that it does not name");
}

TEST(DrawingUnit, OfTheDrawingsOfTheTests) {
    EXPECT_TRUE(is_drawing("a/b.STEP"));
    EXPECT_TRUE(is_drawing("b.igs.gz"));
    EXPECT_FALSE(is_drawing("b.stl"));
    EXPECT_EQ(unit_of_drawing(drawings / "cylinder.step"), "millimetres");
    EXPECT_EQ(unit_of_drawing(drawings / "two_boxes_inch.step"), "inches");
    EXPECT_EQ(unit_of_drawing(drawings / "cylinder.igs"), "millimetres");
}

}  // namespace drawing_unit_test
}  // namespace tw
