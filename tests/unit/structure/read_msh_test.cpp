#include "structure/read_msh.h"

#include "mesh_text.h"

namespace tw::structure {
namespace read_msh_test {

/// Two squares side by side, the left edge and the surface as physical groups, in Gmsh's two formats.
const std::string four = R"($MeshFormat
4.1 0 8
$EndMeshFormat
$PhysicalNames
2
1 7 "left edge"
2 8 "PLATE"
$EndPhysicalNames
$Entities
1 1 1 0
1 0 0 0 0
3 0 0 0 0 1 0 1 7 0
5 0 0 0 2 1 0 1 8 1 3
$EndEntities
$Comments
whatever 1 2
$EndComments
$Nodes
2 6 1 12
1 3 0 2
1
4
0 0 0
0 1000. 0
2 5 0 4
2
3
11
12
1000 0 0
1000 1e3 0
2000 0 0
2000 1000 0
$EndNodes
$Elements
2 3 1 3
1 3 1 1
1 1 4
2 5 3 2
2 1 2 3 4
3 2 11 12 3
$EndElements
)";
const std::string two = R"($MeshFormat
2.2 0 8
$EndMeshFormat
$PhysicalNames
2
1 7 "left edge"
2 8 "PLATE"
$EndPhysicalNames
$Nodes
6
1 0 0 0
2 1000 0 0
3 1000 1000 0
4 0 1000 0
11 2000 0 0
12 2000 1000 0
$EndNodes
$Elements
3
1 1 2 7 3 1 4
2 3 2 8 5 1 2 3 4
3 3 2 8 5 2 11 12 3
$EndElements
)";

TEST(Msh, BothVersionsGiveTheSameMeshWithItsGroups) {
    for (const std::string& text : {four, two}) {
        const MeshFile m = read_mesh(written(text, ".msh"), 1e-3);
        ASSERT_EQ(m.shell.quads.size(), 2u);
        EXPECT_EQ(m.shell.nodes.size(), 6u);
        EXPECT_EQ(m.shell.nodes[2], Vec3(1, 1, 0));
        EXPECT_EQ(m.shell.quads[1], (std::array{1, 4, 5, 2}));  // nodes 2, 11, 12, 3
        EXPECT_EQ(m.shell.sets.at("left edge"), (std::vector{0, 3}));
        EXPECT_EQ(m.shell.sets.at("PLATE").size(), 6u);
        EXPECT_EQ(m.quad_numbers, (std::vector{2, 3}));
    }
}

TEST(Msh, HexahedraHaveTheMaterialOfTheirGroup) {
    std::string text = with(two, "2 8 \"PLATE\"", "3 8 \"RUBBER\"");
    text = with(text, "6\n1 0", "8\n5 0 0 500\n6 1000 0 500\n1 0");
    text = with(text, "11 2000 0 0\n12 2000 1000 0", "11 1000 1000 500\n12 0 1000 500");
    text = with(text, "3\n1 1 2", "2\n1 1 2");
    text = with(text, "2 3 2 8 5 1 2 3 4\n3 3 2 8 5 2 11 12 3", "2 5 2 8 5 1 2 3 4 5 6 11 12");
    const MeshFile m = read_mesh(written(text, ".msh"));
    ASSERT_EQ(m.solid.hexahedra.size(), 1u);
    EXPECT_EQ(m.materials, (std::vector<std::string>{"RUBBER"}));
    EXPECT_EQ(m.solid.sets.at("left edge"), (std::vector{0, 3}));
}

TEST(Msh, ThatIsUnsoundIsRefusedByLine) {
    EXPECT_EQ(refusal(four, ".msh"), "");
    EXPECT_EQ(refusal(with(four, "4.1 0 8", "4.1 1 8"), ".msh"),
              ":2: version 4.1, or binary; expected the ASCII format 4.1 or 2.2");
    EXPECT_EQ(refusal(with(four, "4.1 0 8", "3.0 0 8"), ".msh"),
              ":2: version 3.0, or binary; expected the ASCII format 4.1 or 2.2");
    EXPECT_EQ(refusal(with(two, "1000 1000 0", "1000 nan 0"), ".msh"), ":13: \"nan\"; expected a number");
    EXPECT_EQ(refusal(with(two, "3 1000 1000", "2 1000 1000"), ".msh"), ":13: node 2 is given twice");
    EXPECT_EQ(refusal(with(two, "2 11 12 3\n", "2 11 99 3\n"), ".msh"), ":22: element 3: node 99 is not given above");
    EXPECT_NE(
        refusal(with(two, "3 3 2 8 5 2 11 12 3", "3 2 2 8 5 2 11 12"), ".msh").find(":22: element 3 is of type 2"),
        std::string::npos);
    EXPECT_EQ(refusal(with(two, "3\n1 1 2", "4\n1 1 2"), ".msh"), ":23: \"$EndElements\"; expected a number");
    EXPECT_EQ(refusal(two.substr(0, two.find("$EndElements")), ".msh"), ":23: \"\"; expected $EndElements");
    EXPECT_NE(refusal("solid ascii\n", ".msh").find("expected $MeshFormat"), std::string::npos);
    EXPECT_NE(refusal(two.substr(0, two.find("$Elements")), ".msh").find("no quadrilaterals or hexahedra"),
              std::string::npos);
    EXPECT_THROW(read_mesh("no_such_mesh.msh"), InputError);
    EXPECT_NE(refusal(two, ".stl").find("expected one of these endings"), std::string::npos);
}

}  // namespace read_msh_test
}  // namespace tw::structure
