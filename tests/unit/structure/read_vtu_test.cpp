#include "structure/read_vtu.h"

#include <vtkNew.h>
#include <vtkUnstructuredGrid.h>
#include <vtkXMLUnstructuredGridReader.h>
#include <vtkXMLUnstructuredGridWriter.h>

#include "mesh_text.h"

namespace tw::structure {
namespace read_vtu_test {

/// Two squares side by side; the points of the left edge are marked.
const std::string plate = R"(<VTKFile type="UnstructuredGrid" version="1.0" byte_order="LittleEndian">
<UnstructuredGrid><Piece NumberOfPoints="6" NumberOfCells="2">
<PointData>
<DataArray type="Int32" Name="left" format="ascii">1 0 0 1 0 0</DataArray>
<DataArray type="Float64" Name="normals" NumberOfComponents="3" format="ascii">
0 0 1 0 0 1 0 0 1 0 0 1 0 0 1 0 0 1</DataArray>
</PointData>
<Points><DataArray type="Float64" NumberOfComponents="3" format="ascii">
0 0 0 1000 0 0 1000 1000 0 0 1000 0 2000 0 0 2000 1000 0</DataArray></Points>
<Cells>
<DataArray type="Int64" Name="connectivity" format="ascii">0 1 2 3 1 4 5 2</DataArray>
<DataArray type="Int64" Name="offsets" format="ascii">4 8</DataArray>
<DataArray type="UInt8" Name="types" format="ascii">9 9</DataArray>
</Cells></Piece></UnstructuredGrid></VTKFile>
)";

TEST(Vtu, IsReadWithMarkedPointsAsNodeSets) {
    const MeshFile m = read_mesh(written(plate, ".vtu"), 1e-3);
    ASSERT_EQ(m.shell.quads.size(), 2u);
    EXPECT_EQ(m.shell.nodes[2], Vec3(1, 1, 0));
    EXPECT_EQ(m.shell.quads[1], (std::array{1, 4, 5, 2}));
    EXPECT_EQ(m.shell.sets.at("left"), (std::vector{0, 3}));
    EXPECT_FALSE(m.shell.sets.contains("normals")) << "three values per point mark nothing";
}

TEST(Vtu, ThatIsUnsoundIsRefused) {
    EXPECT_EQ(refusal(plate, ".vtu"), "");
    EXPECT_NE(refusal(with(plate, ">9 9<", ">9 8<"), ".vtu").find("element 1 is a cell of type 8"), std::string::npos);
    EXPECT_NE(refusal(plate.substr(0, plate.size() / 2), ".vtu").find("truncated"), std::string::npos);
    EXPECT_NE(refusal("no XML", ".vtu").find("not a file of VTK"), std::string::npos);
    EXPECT_THROW(read_mesh("no_such_mesh.vtu"), InputError);
}

TEST(Vtu, WhoseCellsAreNotOfItsPointsIsRefused) {
    for (const char* corner : {"99", "-7", "9000000000000000000"})
        EXPECT_NE(refusal(with(plate, "4 5 2<", std::string("4 ") + corner + " 2<"), ".vtu"), "") << corner;
    EXPECT_NE(refusal(with(plate, ">9 9<", ">9 255<"), ".vtu"), "");
    EXPECT_NE(refusal(with(plate, ">9 9<", ">9 12<"), ".vtu"), "") << "a hexahedron of four corners";
    for (const char* ends : {"4 9", "8 4", "-4 8", "4 4", "4 800000"})
        EXPECT_NE(refusal(with(plate, ">4 8<", ">" + std::string(ends) + "<"), ".vtu"), "") << ends;
}

/// As other programs write it, with every bit of some bytes turned: read, or refused in words.
TEST(Vtu, WithOneBitTurnedIsReadOrRefused) {
    const auto file = written(plate, ".vtu");
    vtkNew<vtkXMLUnstructuredGridReader> reader;
    reader->SetFileName(file.c_str());
    reader->Update();
    vtkNew<vtkXMLUnstructuredGridWriter> writer;
    writer->SetInputData(reader->GetOutput());
    writer->SetDataModeToAppended();
    writer->EncodeAppendedDataOff();
    writer->SetWriteToOutputString(true);
    writer->Write();
    const std::string good = writer->GetOutputString();
    EXPECT_EQ(refusal(good, ".vtu"), "");
    int refused = 0;
    const std::size_t data = good.find('_', good.find("<AppendedData"));
    for (std::size_t k = data + 1; k + 30 < good.size(); k += 23) {
        std::string bad = good;
        bad[k] = static_cast<char>(bad[k] ^ (1 << k % 8));
        if (!refusal(bad, ".vtu").empty()) ++refused;
    }
    EXPECT_GT(refused, 0);
}

}  // namespace read_vtu_test
}  // namespace tw::structure
