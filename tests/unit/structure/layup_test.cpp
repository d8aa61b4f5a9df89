#include <gtest/gtest.h>

#include <numbers>

#include "base/errors.h"
#include "structure/laminate.h"

namespace tw::structure {
namespace layup_test {
const std::vector<std::pair<std::string, Ply>> materials{{"C1", {isotropic(1e9, 0.3, 1500), 0, 0.3e-3}},
                                                         {"C2", {isotropic(2e9, 0.3, 1600), 0, 0.1e-3}}};

std::vector<double> degrees(std::string_view text) {
    std::vector<double> all;
    for (const Ply& p : read_layup(text, materials)) all.push_back(p.angle * 180 / std::numbers::pi);
    return all;
}

std::string refusal(std::string_view text) {
    try {
        read_layup(text, materials);
    } catch (const InputError& e) { return e.what(); }
    return {};
}

TEST(Layup, OfThePlateStudyIsReadAsPrinted) {
    const auto plies = read_layup("[45 C1/0C2/45 C2/90 C2]s", materials);
    ASSERT_EQ(plies.size(), 8u);
    EXPECT_EQ(degrees("[45 C1/0C2/45 C2/90 C2]s"), (std::vector<double>{45, 0, 45, 90, 90, 45, 0, 45}));
    EXPECT_EQ(plies[0].thickness, 0.3e-3);
    EXPECT_EQ(plies[1].material.E1, 2e9);
    EXPECT_EQ(plies[7].material.E1, 1e9);
}

TEST(Layup, MayRepeatLayersAndNeedNotBeMirrored) {
    EXPECT_EQ(degrees("[-45 C1/30.5 3*C2]"), (std::vector<double>{-45, 30.5, 30.5, 30.5}));
}

TEST(Layup, ThatCannotBeReadNamesTheLayer) {
    EXPECT_EQ(refusal("[0 C1/90 C3]s"), "layup \"[0 C1/90 C3]s\": layer \"90 C3\": no material is named \"C3\"");
    EXPECT_NE(refusal("[0 C1//0 C1]").find("layer \"\""), std::string::npos);
    EXPECT_NE(refusal("[C1]").find("angle"), std::string::npos);
    EXPECT_NE(refusal("[0 0*C1]").find("count"), std::string::npos);
    EXPECT_NE(refusal("0 C1").find("brackets"), std::string::npos);
    EXPECT_NE(refusal("[0 C1]t").find("\"t\" after the bracket"), std::string::npos);
}

}  // namespace layup_test
}  // namespace tw::structure
