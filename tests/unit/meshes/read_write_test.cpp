#include <gtest/gtest.h>
#include <vtkCellArray.h>
#include <vtkNew.h>
#include <vtkOBJWriter.h>
#include <vtkPLYWriter.h>
#include <vtkPoints.h>
#include <vtkPolyData.h>
#include <vtkSTLWriter.h>
#include <vtkXMLPolyDataWriter.h>

#include <filesystem>
#include <fstream>

#include "base/atomic_file.h"
#include "base/errors.h"
#include "meshes/generate.h"
#include "meshes/health.h"
#include "meshes/mass_properties.h"
#include "meshes/read/solids_of_file.h"
#include "meshes/surface.h"
#include "tests/unit/meshes/gzipped.h"

namespace tw {
namespace fs = std::filesystem;
namespace read_write_test {

class ReadWrite : public testing::Test {
protected:
    ReadWrite() {
        fs::create_directories(folder);
        vtkNew<vtkPoints> points;
        vtkNew<vtkCellArray> cells;
        for (const Vec3& p : hull.points) points->InsertNextPoint(p.data());
        for (const auto& t : hull.triangles) {
            const vtkIdType ids[3] = {t[0], t[1], t[2]};
            cells->InsertNextCell(3, ids);
        }
        data->SetPoints(points);
        data->SetPolys(cells);
    }
    ~ReadWrite() override { fs::remove_all(folder); }

    template <class Writer>
    fs::path written(const std::string& name, int binary = -1) {
        vtkNew<Writer> writer;
        const fs::path file = folder / name;
        writer->SetFileName(file.c_str());
        writer->SetInputData(data);
        if constexpr (requires { writer->SetFileTypeToBinary(); }) {
            if (binary == 1)
                writer->SetFileTypeToBinary();
            else
                writer->SetFileTypeToASCII();
        }
        writer->Write();
        return file;
    }
    void expect_the_hull(const Surface& read, double scale = 1) const {
        ASSERT_EQ(read.triangles.size(), hull.triangles.size());
        EXPECT_EQ(read.points.size(), hull.points.size());  // corners are shared again
        for (int t = 0; t < static_cast<int>(hull.triangles.size()); ++t)
            for (int k = 0; k < 3; ++k)
                ASSERT_LT((read.corner(t, k) - scale * hull.corner(t, k)).norm(), 1e-6 * scale * 36.9);
        EXPECT_TRUE(check_surface(read).empty());
    }

    fs::path folder = fs::temp_directory_path() / ("twinwake_meshes_" + std::to_string(::getpid()));
    Surface hull = make_hull("seaplane", {});
    vtkNew<vtkPolyData> data;
};

TEST_F(ReadWrite, CompressedFilesAreTheSameSurface) {
    const auto packed = [&](const fs::path& file) {
        const fs::path gz = file.string() + ".gz";
        std::ofstream(gz, std::ios::binary) << gzipped(read_text(file));
        return read_surface(gz);
    };
    write_stl(folder / "hull.stl", hull);
    EXPECT_EQ(surface_hash(packed(folder / "hull.stl")), surface_hash(read_surface(folder / "hull.stl")));
    for (const fs::path& file : {written<vtkSTLWriter>("text.stl", 0), written<vtkOBJWriter>("hull.obj"),
                                 written<vtkPLYWriter>("hull.ply", 1), written<vtkXMLPolyDataWriter>("hull.vtp")})
        EXPECT_EQ(surface_hash(packed(file)), surface_hash(read_surface(file))) << file;
    // Two members one after the other are one file.
    const std::string text = read_text(folder / "text.stl");
    std::ofstream(folder / "two.STL.GZ", std::ios::binary)
        << gzipped(text.substr(0, 5000)) << gzipped(text.substr(5000));
    EXPECT_EQ(surface_hash(read_surface(folder / "two.STL.GZ")), surface_hash(read_surface(folder / "text.stl")));
}

TEST_F(ReadWrite, OwnBinaryStlComesBack) {
    write_stl(folder / "hull.stl", hull,
              "solid name with 100 letters ......................................................................");
    expect_the_hull(read_surface(folder / "hull.stl"));
    EXPECT_EQ(fs::file_size(folder / "hull.stl"), 84 + 50 * hull.triangles.size());
}

TEST_F(ReadWrite, FilesOfOtherProgramsComeBack) {
    expect_the_hull(read_surface(written<vtkSTLWriter>("binary.stl", 1)));
    expect_the_hull(read_surface(written<vtkSTLWriter>("ascii.STL", 0)));
    expect_the_hull(read_surface(written<vtkOBJWriter>("hull.obj")));
    expect_the_hull(read_surface(written<vtkPLYWriter>("binary.ply", 1)));
    expect_the_hull(read_surface(written<vtkPLYWriter>("ascii.ply", 0)));
    expect_the_hull(read_surface(written<vtkXMLPolyDataWriter>("hull.vtp")));
}

TEST_F(ReadWrite, BinaryStlThatCallsItselfSolidIsNotTakenForText) {
    // Coordinates 0 and 2 have no byte above 127, by which some readers tell binary from text.
    const Surface box = make_hull("box", {{"length", 4}, {"beam", 4}, {"height", 2}});
    write_stl(folder / "box.stl", box);
    std::fstream(folder / "box.stl", std::ios::in | std::ios::out | std::ios::binary) << "solid box";
    EXPECT_NEAR(mass_properties(read_surface(folder / "box.stl")).volume, 32, 1e-12);
}

TEST_F(ReadWrite, TextStlWithLettersOfAnotherCodeIsText) {
    // Bytes above 127, by which some readers tell binary from text, where a binary file has its number of triangles.
    std::string text = read_text(written<vtkSTLWriter>("plain.stl", 0));
    const std::size_t place = text.find("outer loop") + std::string("outer loop").size();
    std::ofstream(folder / "foreign.stl", std::ios::binary) << text.insert(place, " " + std::string(100, '\xfc'));
    EXPECT_EQ(surface_hash(read_surface(folder / "foreign.stl")), surface_hash(read_surface(folder / "plain.stl")));
}

// Editors begin a text in UTF-8 with a mark of three bytes; it made of a text STL a "damaged binary" one.
TEST_F(ReadWrite, TextsThatBeginWithAByteOrderMarkAreRead) {
    const fs::path plain = folder / "plain.stl", marked = folder / "marked.stl", wide = folder / "wide.stl";
    const std::string text =
        "solid s\n facet normal 0 0 1\n  outer loop\n   vertex 0 0 0\n   vertex 1 0 0\n   vertex 0 1 0\n  endloop\n "
        "endfacet\nendsolid\n";
    std::ofstream(plain) << text;
    std::ofstream(marked) << "\xEF\xBB\xBF" << text;
    EXPECT_EQ(surface_hash(read_surface(marked)), surface_hash(read_surface(plain)));
    const std::string obj = "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n";
    std::ofstream(folder / "marked.obj") << "\xEF\xBB\xBF" << obj;
    EXPECT_EQ(read_surface(folder / "marked.obj").triangles.size(), 1u);
    std::ofstream(wide) << "\xFF\xFEs" << '\0' << "o" << '\0';
    try {
        read_surface(wide);
        FAIL() << "read";
    } catch (const InputError& e) {
        EXPECT_NE(std::string(e.what()).find("byte order mark of UTF-16"), std::string::npos) << e.what();
    }
    // A binary file may begin with any bytes.
    write_stl(folder / "binary.stl", hull, "\xEF\xBB\xBF name");
    write_stl(folder / "named.stl", hull, "name");
    EXPECT_EQ(surface_hash(read_surface(folder / "binary.stl")), surface_hash(read_surface(folder / "named.stl")));
}

TEST_F(ReadWrite, MillimetresBecomeMetres) {
    write_stl(folder / "hull.stl", hull);
    expect_the_hull(read_surface(folder / "hull.stl", "mm"), 1e-3);
    EXPECT_THROW(read_surface(folder / "hull.stl", "furlong"), InputError);
}

TEST_F(ReadWrite, AxesAreTurnedAndNormalsStayOutward) {
    // The file has y up and x forward; with z to starboard in both, that is a plain turn.
    Surface turned = hull;
    for (Vec3& p : turned.points) p = Vec3(-p.x(), p.z(), p.y());
    write_stl(folder / "turned.stl", turned);
    const Surface read = read_surface(folder / "turned.stl", "m", "-xzy");
    EXPECT_LT((read.bounds().min - hull.bounds().min).norm(), 1e-5);
    EXPECT_LT((read.bounds().max - hull.bounds().max).norm(), 1e-5);
    EXPECT_NEAR(mass_properties(read).volume / mass_properties(turned).volume, 1, 1e-5);
    EXPECT_GT(mass_properties(read_surface(folder / "turned.stl", "m", "-x-zy")).volume, 0);  // mirrored
    for (const char* bad : {"", "xy", "xyy", "xyzx", "x+-", "abc", "xyz-", "x y z"})
        EXPECT_THROW(read_surface(folder / "turned.stl", "m", bad), InputError) << bad;
}

TEST_F(ReadWrite, PolygonsBecomeTrianglesAndTextureSeamsClose) {
    // A cube of quadrilaterals, every face with corners of its own, in the words of modelling programs.
    std::ofstream(folder / "cube.obj")
        << "# cube\nmtllib none.mtl\no cube\n"
           "v 0 0 0\nv 1 0 0\nv 1 1 0\nv 0 1 0\nv 0 0 1\nv 1 0 1\nv 1 1 1\nv 0 1 1\nvt 0 0\nvt 1 0\nvn 0 0 1\n"
           "f 4/1/1 3/2/1 2/1/1 1/2/1\nf 5/1/1 6/2/1 7/1/1 8/1/1\nf -8/1/1 -7/2/1 -3/2/1 -4/1/1\n"
           "f 2/2/1 3/1/1 7/2/1 6/1/1\nf 3/1/1 4/2/1 8/1/1 7/2/1\nf 4/1/1 1/1/1 5/1/1 8/2/1\n";
    const Surface cube = read_surface(folder / "cube.obj");
    EXPECT_EQ(cube.triangles.size(), 12u);
    EXPECT_EQ(cube.points.size(), 8u);
    EXPECT_NEAR(mass_properties(cube).volume, 1, 1e-7);
    EXPECT_TRUE(check_surface(cube).empty());
}

TEST_F(ReadWrite, OneOfSeveralSolidsIsTakenByItsName) {
    const std::string tetrahedra[] = {"0 0 0", "1 0 0", "0 1 0", "0 0 1"};
    const int faces[4][3] = {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}};
    std::string stl, obj;
    for (int body = 0; body < 2; ++body) {  // the second one twice as large
        const std::string name = body == 0 ? "keel" : "Left fin", scale = body == 0 ? "1" : "2";
        const auto corner = [&](int k) {
            std::string c = tetrahedra[k];
            for (char& x : c)
                if (x == '1') x = scale[0];
            return c;
        };
        stl += "solid " + name + "\n", obj += "o " + name + "\n";
        for (int k = 0; k < 4; ++k) obj += "v " + corner(k) + "\n";
        for (const auto& f : faces) {
            stl += "facet normal 0 0 0\nouter loop\n";
            for (const int k : f) stl += "vertex " + corner(k) + "\n";
            stl += "endloop\nendfacet\n";
            obj += "f";
            for (const int k : f) obj += " " + std::to_string(4 * body + k + 1);
            obj += "\n";
        }
        stl += "endsolid " + name + "\n";
    }
    const auto volume_of = [&](const std::string& file) {
        const Surface s = read_surface(folder / file);
        EXPECT_EQ(s.points.size(), file.find('#') == std::string::npos ? 7u : 4u) << file;
        return mass_properties(s).volume;
    };
    const auto complaint = [&](const std::string& file) -> std::string {
        try {
            read_surface(folder / file);
            return {};
        } catch (const InputError& e) { return e.what(); }
    };
    std::ofstream(folder / "boat.stl") << stl;
    std::ofstream(folder / "boat.obj") << obj;
    for (const std::string file : {"boat.stl", "boat.obj"}) {
        EXPECT_NEAR(volume_of(file + "#keel"), 1.0 / 6, 1e-7);
        EXPECT_NEAR(volume_of(file + "#Left fin"), 8.0 / 6, 1e-7);
        EXPECT_NE(complaint(file + "#rudder").find("called \"rudder\"; it has: keel, Left fin"), std::string::npos)
            << complaint(file + "#rudder");
        EXPECT_NE(complaint(file + "#").find("expected the name of a solid"), std::string::npos);
        EXPECT_EQ(solids_of_file(folder / file), (std::vector<SolidNames>{{"keel"}, {"Left fin"}}));
    }
    std::ofstream(folder / "a#b.stl") << stl;  // a file's own name may have the sign
    EXPECT_EQ(complaint("a#b.stl"), "");
    EXPECT_NEAR(volume_of("a#b.stl#keel"), 1.0 / 6, 1e-7);
    stl.replace(stl.find("Left fin"), 8, "fin #2");  // and so may a solid's
    std::ofstream(folder / "fins.stl") << stl;
    EXPECT_NEAR(volume_of("fins.stl#fin #2"), 8.0 / 6, 1e-7);
    write_stl(folder / "binary.stl", hull);
    EXPECT_EQ(solids_of_file(folder / "binary.stl"), std::vector<SolidNames>{});
    EXPECT_NE(complaint("binary.stl#keel").find("names no solids"), std::string::npos);
    EXPECT_NE(complaint("none.stl#keel").find("none.stl: no such file"), std::string::npos);
}

TEST_F(ReadWrite, AnUnwritableFolderIsSaidAndLeavesNothing) {
    EXPECT_THROW(write_stl(folder / "no such folder" / "hull.stl", hull), RunError);
    EXPECT_TRUE(fs::is_empty(folder));
}
}  // namespace read_write_test
}  // namespace tw
