#include "structure/read_inp.h"

#include <gtest/gtest.h>

#include <fstream>

#include "base/errors.h"

namespace tw::structure {
namespace read_inp_test {

std::filesystem::path written(const std::string& text) {
    const std::string test = testing::UnitTest::GetInstance()->current_test_info()->name();
    const auto file = std::filesystem::temp_directory_path() / (test + ".inp");
    std::ofstream(file) << text;
    return file;
}

const std::string cube = R"(** a brick and a plate beside it
*Heading
 two parts
*Node, nset=ALL
 1, 0, 0, 0
 2, 1000., 0, 0
 3, 1000, 1e3, 0
 4, 0, 1000, 0
 5, 0, 0, 500
 6, 1000, 0, 500
 7, 1000, 1000, 500
 8, 0, 1000, 500
 20, 2000, 0, 0
 21, 2000, 1000, 0
*Element, type=C3D8R, elset=Rubber
 1, 1, 2, 3, 4,
 5, 6, 7, 8
*ELEMENT,TYPE=S4,ELSET=PLATE
 2, 2, 20, 21, 3
*Nset, nset=foot, generate
 1, 4, 1
*Nset, nset=edge
 foot, 20,
*Material, name=rubber
*Elastic
 1e6, 0.4
)";

TEST(Inp, IsReadWithItsSetsAndUnits) {
    const MeshFile m = read_inp(written(cube), 1e-3);
    ASSERT_EQ(m.solid.hexahedra.size(), 1u);
    ASSERT_EQ(m.shell.quads.size(), 1u);
    EXPECT_EQ(m.solid.nodes.size(), 8u);
    EXPECT_EQ(m.shell.nodes.size(), 4u);
    EXPECT_EQ(m.solid.nodes[6], Vec3(1, 1, 0.5));
    EXPECT_EQ(m.shell.quads[0], (std::array{0, 2, 3, 1}));  // nodes 2, 20, 21, 3 among 2, 3, 20, 21
    EXPECT_EQ(m.solid.sets.at("FOOT"), (std::vector{0, 1, 2, 3}));
    EXPECT_EQ(m.shell.sets.at("FOOT"), (std::vector{0, 1}));
    EXPECT_EQ(m.shell.sets.at("EDGE"), (std::vector{0, 1, 2}));
    EXPECT_EQ(m.solid.sets.at("ALL").size(), 8u);
    EXPECT_EQ(m.materials, (std::vector<std::string>{"RUBBER"}));
    EXPECT_EQ(m.solid.material, (std::vector{0}));
}

TEST(Inp, ThatIsUnsoundIsRefusedByLine) {
    const auto refusal = [](const std::string& text) {
        try {
            read_inp(written(text));
        } catch (const InputError& e) { return std::string(e.what()).substr(std::string(e.what()).rfind("inp") + 3); }
        return std::string();
    };
    const auto with = [](const std::string& from, const std::string& to) {
        std::string text = cube;
        return text.replace(text.find(from), from.size(), to);
    };
    EXPECT_EQ(refusal(cube), "");
    EXPECT_EQ(refusal(with("TYPE=S4", "TYPE=S3")),
              ":18: elements of type \"S3\"; expected S4, S4R, C3D8, C3D8R, C3D8H or C3D8I");
    EXPECT_EQ(refusal(with(" 2, 2, 20", " 2, 2, 30")), ":19: element 2: node 30 is not given above");
    EXPECT_EQ(refusal(with("5, 6, 7, 8", "5, 6, 7")), ":18: an element of 7 nodes; expected 8");
    EXPECT_EQ(refusal(with(" 3, 1000,", " 3, nan,")), ":7: \"nan\"; expected a number");
    EXPECT_EQ(refusal(with(" 3, 1000,", " 2, 1000,")), ":7: node 2 is given twice");
    EXPECT_EQ(refusal(with("foot, 20", "foot, 99")), ":23: set EDGE: node 99 is not given above");
    EXPECT_EQ(refusal("*NODE\n1, 0, 0, 0\n"), ":2: no elements S4 or C3D8 in this file");
    EXPECT_THROW(read_inp("no_such_mesh.inp"), InputError);
}

}  // namespace read_inp_test
}  // namespace tw::structure
