#include "structure/check_mesh.h"

#include "mesh_text.h"

namespace tw::structure {
namespace check_mesh_test {

const std::string nodes =
    "*NODE\n1, 0, 0, 0\n2, 1, 0, 0\n3, 1, 1, 0\n4, 0, 1, 0\n5, 2, 0, 0\n6, 2, 1, 0\n"
    "11, 0, 0, 1\n12, 1, 0, 1\n13, 1, 1, 1\n14, 0, 1, 1\n"
    "21, 5, 0, 0\n22, 6, 0, 0\n23, 6, 1, 0\n24, 5, 1, 0\n";
std::string shell(const std::string& elements) { return refusal(nodes + "*ELEMENT, TYPE=S4\n" + elements, ".inp"); }
std::string solid(const std::string& elements) { return refusal(nodes + "*ELEMENT, TYPE=C3D8\n" + elements, ".inp"); }

TEST(CheckMesh, LetsSoundMeshesPass) {
    EXPECT_EQ(shell("7, 1, 2, 3, 4\n8, 2, 5, 6, 3\n"), "");
    EXPECT_EQ(solid("7, 1, 2, 3, 4, 11, 12, 13, 14\n"), "");
}

TEST(CheckMesh, NamesElementsWithoutAreaOrTurnedInsideOut) {
    EXPECT_EQ(shell("7, 1, 2, 3, 4\n8, 2, 3, 3, 2\n"), ": element 8 has no area; remove it, or move its nodes apart");
    EXPECT_NE(shell("7, 1, 2, 4, 3\n").find(": element 7 "), std::string::npos) << "crossed";
    EXPECT_NE(solid("7, 1, 2, 3, 4, 1, 2, 3, 4\n").find(": element 7 has no volume"), std::string::npos);
    EXPECT_NE(solid("7, 11, 12, 13, 14, 1, 2, 3, 4\n").find(": element 7 is turned inside out"), std::string::npos);
}

TEST(CheckMesh, NamesElementsThatAreTurnedTheOtherWay) {
    const std::string turned = shell("7, 1, 2, 3, 4\n8, 2, 3, 6, 5\n");
    EXPECT_EQ(turned.find(": element 8 is turned the other way than element 7 beside it"), 0u) << turned;
}

TEST(CheckMesh, NamesPartsThatAreNotConnected) {
    const std::string apart = shell("7, 1, 2, 3, 4\n8, 21, 22, 23, 24\n");
    EXPECT_NE(apart.find(": element 8 hangs together with element 7 by no node"), std::string::npos) << apart;
}

}  // namespace check_mesh_test
}  // namespace tw::structure
