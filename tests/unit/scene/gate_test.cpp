// The gate at which a particle run loses its spray, as a scene may ask for it.
#include "scene_text.h"

namespace tw::test {
namespace gate_test {

const std::string tank =
    "[tank]\nsize = [1, 0.5, 0.8]\n[[water_block]]\nmin = [0, 0, 0]\nmax = [0.5, 0.5, 0.4]\n[resolution]\nnear_hull = "
    "0.05\n";
const std::string gate = "[sph]\ngate_point = [0, 0, 0.6]\ngate_normal = [0, 0, 1]\n";

TEST(Gate, IsAPlane) {
    const Scene scene = scene_of(tank + gate);
    EXPECT_EQ(scene.sph.gate_point, (std::vector<double>{0, 0, 0.6}));
    EXPECT_EQ(scene.sph.gate_link, 2);
    EXPECT_TRUE(scene_of(tank).sph.gate_point.empty());
}

TEST(Gate, ThatCannotBeNamesTheKeyAndWhatToDo) {
    const struct {
        std::string text, said;
    } wrong[] = {
        {tank + "[sph]\ngate_point = [0, 0, 0.6]\n", "a plane needs both gate_point and gate_normal"},
        {tank + "[sph]\ngate_normal = [0, 0, 1]\n", "a plane needs both gate_point and gate_normal"},
        {tank + "[sph]\ngate_point = [0, 0.6]\ngate_normal = [0, 0, 1]\n", "2 numbers; expected three"},
        {tank + "[sph]\ngate_point = [0, 0, 0.6]\ngate_normal = [0, 0, 0]\n", "expected a direction"},
        {tank + gate + "gate_link = 0.5\n", "gate_link"},
        {tank + gate + "[domain]\ndimensions = 2\n", "droplets need three dimensions"},
        {tank + gate + "[effects]\nair = \"on\"\n", "switch one of the two off"},
    };
    for (const auto& [text, said] : wrong) {
        const std::string message = complaint(text);
        EXPECT_NE(message.find(said), std::string::npos) << text << message;
        EXPECT_NE(message.find("[sph] gate_"), std::string::npos) << message;
    }
}

}  // namespace gate_test
}  // namespace tw::test
