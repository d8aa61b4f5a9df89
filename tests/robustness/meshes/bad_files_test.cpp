#include <gtest/gtest.h>
#include <unistd.h>

#include <ctime>
#include <filesystem>
#include <fstream>
#include <random>

#include "base/atomic_file.h"
#include "base/errors.h"
#include "meshes/generate.h"
#include "meshes/health.h"
#include "meshes/mass_properties.h"
#include "meshes/surface.h"
#include "tests/unit/meshes/gzipped.h"

// What a user may hand over instead of a sound surface file: every one gets a message that names the file and the
// fault; never a crash, a hang or an empty hull.
namespace tw {
namespace fs = std::filesystem;
namespace bad_files_test {

class BadFiles : public testing::Test {
protected:
    BadFiles() { fs::create_directories(folder); }
    ~BadFiles() override { fs::remove_all(folder); }

    fs::path file(const std::string& name, std::string_view content) const {
        std::ofstream(folder / name, std::ios::binary) << content;
        return folder / name;
    }
    /// The complaint about a file; empty when it was read.
    static std::string complaint(const fs::path& file) {
        std::string message;
        testing::internal::CaptureStderr();
        try {
            read_surface(file);
        } catch (const InputError& e) {
            message = e.what();
            EXPECT_NE(message.find(file.filename().string()), std::string::npos) << message;
        }
        EXPECT_EQ(testing::internal::GetCapturedStderr(), "") << file;  // a library's complaints stay off the terminal
        return message;
    }
    static void expect_complaint(const fs::path& file, const std::string& part) {
        const std::string message = complaint(file);
        EXPECT_NE(message.find(part), std::string::npos) << file << ": " << message;
    }
    std::string good_stl() const {
        write_stl(folder / "good.stl", make_hull("box", {}));
        return read_text(folder / "good.stl");
    }
    static std::string garbage(std::size_t n, unsigned seed) {
        std::mt19937 random(seed);
        std::string bytes(n, '\0');
        for (char& c : bytes) c = static_cast<char>(random());
        return bytes;
    }

    fs::path folder = fs::temp_directory_path() / ("twinwake bad $(files) #" + std::to_string(::getpid()));
};

constexpr const char* ascii_triangle =
    "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\nendfacet\nendsolid "
    "s\n";

TEST_F(BadFiles, MissingEmptyFolderOrUnknownType) {
    expect_complaint(folder / "none.stl", "no such file");
    expect_complaint(file("empty.stl", ""), "empty");
    expect_complaint(file("empty.vtp", ""), "empty");
    fs::create_directory(folder / "folder.stl");
    expect_complaint(folder / "folder.stl", "not a file");
    expect_complaint(file("hull.dwg", "AC1032"), ".stl, .obj, .ply, .vtp, .step and .iges");
    expect_complaint(file("hull", "solid"), ".stl");
}

TEST_F(BadFiles, TruncatedBinaryStl) {
    const std::string good = good_stl();
    for (const std::size_t n : {1u, 79u, 83u, 84u, 100u, 1000u}) {
        ASSERT_LT(n, good.size());
        EXPECT_NE(complaint(file("cut.stl", good.substr(0, n))), "") << n;
    }
    expect_complaint(file("cut.stl", good.substr(0, good.size() - 1)), "truncated");
    expect_complaint(file("long.stl", good + "x"), "promises");
}

TEST_F(BadFiles, BinaryStlWithAnAbsurdCount) {
    std::string bytes = good_stl();
    for (std::size_t i = 80; i < 84; ++i) bytes[i] = '\xff';
    expect_complaint(file("many.stl", bytes), "4294967295 triangles");
    for (std::size_t i = 80; i < 84; ++i) bytes[i] = '\0';
    EXPECT_NE(complaint(file("none.stl", bytes)), "");
}

TEST_F(BadFiles, GarbageOfEverySizeUnderEveryName) {
    for (const char* type : {"stl", "obj", "ply", "vtp"})
        for (unsigned seed = 0; seed < 40; ++seed) {
            const std::string name = std::string("garbage.") + type;
            EXPECT_NE(complaint(file(name, garbage(1u << seed % 14, seed))), "") << type << " " << seed;
        }
    EXPECT_NE(complaint(file("solid.stl", "solid " + garbage(5000, 99))), "");
}

TEST_F(BadFiles, BinaryStlWithNumbersThatAreNone) {
    std::string bytes = good_stl();
    for (std::size_t i = 0; i < 4; ++i) bytes[84 + 12 + i] = '\xff';  // x of the first corner: NaN
    expect_complaint(file("nan.stl", bytes), "not a finite number");
}

TEST_F(BadFiles, AsciiStl) {
    const std::string good = ascii_triangle;
    EXPECT_EQ(complaint(file("good.stl", good)), "");
    expect_complaint(file("cut.stl", good.substr(0, good.find("endsolid"))), "without \"endsolid\"");
    expect_complaint(file("cut.stl", good.substr(0, good.find("vertex 0 1") + 9)), "cut.stl:6:");
    for (std::size_t n = 1; n < good.find("endsolid"); ++n)
        EXPECT_NE(complaint(file("cut.stl", good.substr(0, n))), "") << n;
    expect_complaint(file("bad.stl", "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 zero 0\n"), "bad.stl:4:");
    expect_complaint(
        file("four.stl",
             "solid s\nfacet normal 0 0 1\nouter loop\nvertex 0 0 0\nvertex 1 0 0\nvertex 1 1 0\nvertex 0 1 0\n"
             "endloop\nendfacet\nendsolid s\n"),
        "4 vertices");
    expect_complaint(file("empty.stl", "solid s\nendsolid s\n"), "no triangles");
    expect_complaint(
        file("nan.stl",
             "solid s\nfacet normal 0 0 1\nouter loop\nvertex nan 0 0\nvertex 1 0 0\nvertex 0 1 0\nendloop\n"
             "endfacet\nendsolid s\n"),
        "not a finite number");
    expect_complaint(file("html.stl", "solid<html><body>404 not found</body></html>\n"), "html.stl");
}

TEST_F(BadFiles, Obj) {
    EXPECT_EQ(complaint(file("good.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 3\n")), "");
    expect_complaint(file("index.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 4\n"), "index.obj:4:");
    expect_complaint(file("index.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 -9\n"), "index.obj:4:");
    expect_complaint(file("index.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 0\n"), "index.obj:4:");
    expect_complaint(file("index.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nf 1 2 99999999999999999999\n"), "index.obj:4:");
    expect_complaint(file("short.obj", "v 0 0 0\nv 1 0\n"), "short.obj:2:");
    expect_complaint(file("normal.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nf 1//1 2//1 3//700\n"),
                     "700 of 1 normals");
    expect_complaint(file("texture.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvt 0 0\nf 1/1 2/1 3/-2\n"), "texture points");
    expect_complaint(file("none.obj", "v 0 0 0\n"), "no triangles");
    expect_complaint(file("nan.obj", "v 0 0 nan\nv 1 0 0\nv 0 1 0\nf 1 2 3\n"), "nan.obj:1:");
}

std::string ply(const std::string& format, long vertices, long faces, const std::string& body) {
    return "ply\nformat " + format + " 1.0\nelement vertex " + std::to_string(vertices) +
           "\nproperty float x\nproperty float y\nproperty float z\nelement face " + std::to_string(faces) +
           "\nproperty list uchar int vertex_indices\nend_header\n" + body;
}

TEST_F(BadFiles, Ply) {
    const std::string body = "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n";
    EXPECT_EQ(complaint(file("good.ply", ply("ascii", 3, 1, body))), "");
    EXPECT_EQ(complaint(file("no_last_newline.ply", ply("ascii", 3, 1, body.substr(0, body.size() - 1)))), "");
    expect_complaint(file("few.ply", ply("ascii", 3, 2, body)), "truncated at face 1 of 2");
    expect_complaint(file("few.ply", ply("ascii", 1000000000000, 1, body)), "truncated");
    expect_complaint(file("index.ply", ply("ascii", 3, 1, "0 0 0\n1 0 0\n0 1 0\n3 0 1 7\n")), "point 7 of 3");
    expect_complaint(file("index.ply", ply("ascii", 3, 1, "0 0 0\n1 0 0\n0 1 0\n3 0 1 -2\n")), "point -2 of 3");
    expect_complaint(file("binary.ply", ply("binary_little_endian", 3, 1, std::string(30, '\0'))),
                     "truncated at vertex 2");
    expect_complaint(file("binary.ply", ply("binary_big_endian", 3000000000, 1, std::string(40, '\0'))), "truncated");
    expect_complaint(
        file("list.ply", ply("binary_little_endian", 3, 1, std::string(36, '\0') + "\xff" + std::string(12, '\0'))),
        "truncated at face 0");
    expect_complaint(
        file("noz.ply",
             "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nelement face 1\n"
             "property list uchar int vertex_indices\nend_header\n0 0\n3 0 0 0\n"),
        "no property \"z\"");
    expect_complaint(file("header.ply", "ply\nformat ascii 1.0\nelement vertex many\n"), "line 3");
    expect_complaint(file("header.ply", "ply\nformat ascii 1.0\n"), "end_header");
    expect_complaint(
        file("noface.ply",
             "ply\nformat ascii 1.0\nelement vertex 1\nproperty float x\nproperty float y\nproperty float z\n"
             "end_header\n0 0 0\n"),
        "no element \"face\"");
}

/// The elements of a PLY file stand in any order and beside others; all of these are one triangle.
TEST_F(BadFiles, PlyWithElementsInAnyOrderIsTheSameSurface) {
    const std::string points = "element vertex 3\nproperty float x\nproperty double y\nproperty float z\n",
                      faces = "element face 1\nproperty uchar red\nproperty list uchar uint vertex_indices\n",
                      edges = "element edge 2\nproperty int vertex1\nproperty int vertex2\n",
                      camera = "element camera 1\nproperty float view\nproperty list uchar float matrix\n";
    const auto text = [](const std::string& elements, const std::string& body) {
        return "ply\nformat ascii 1.0\n" + elements + "end_header\n" + body;
    };
    const std::string p = "0 0 0\n1 0.25 0\n0 1 0\n", f = "255 3 0 1 2\n", e = "0 1\n1 2\n", c = "1.5 2 7 8\n";
    const auto bytes = [](auto... values) {
        std::string out;
        (out.append(reinterpret_cast<const char*>(&values), sizeof values), ...);
        return out;
    };
    using Byte = unsigned char;
    const std::string bp = bytes(0.F, 0.0, 0.F) + bytes(1.F, 0.25, 0.F) + bytes(0.F, 1.0, 0.F),
                      bf = bytes(Byte{255}, Byte{3}) + bytes(0U, 1U, 2U), be = bytes(0, 1) + bytes(1, 2);
    for (const std::string& content :
         {text(points + faces, p + f), text(faces + points, f + p), text(camera + points + faces, c + p + f),
          text(points + edges + faces, p + e + f), text(points + faces + edges, p + f + e),
          "ply\nformat binary_little_endian 1.0\n" + points + edges + faces + "end_header\n" + bp + be + bf,
          "ply\nformat binary_little_endian 1.0\n" + faces + points + "end_header\n" + bf + bp}) {
        const fs::path ordered = file("ordered.ply", content);
        ASSERT_EQ(complaint(ordered), "") << content;
        const Surface s = read_surface(ordered);
        ASSERT_EQ(s.points.size(), 3u) << content;
        ASSERT_EQ(s.triangles.size(), 1u) << content;
        EXPECT_EQ(s.corner(0, 1), Vec3(1, 0.25, 0)) << content;
    }
    expect_complaint(file("late.ply", text(faces + points, "255 3 0 1 9\n" + p)), "point 9 of 3");
}

std::string vtp(const std::string& connectivity, const std::string& offsets,
                const std::string& points = "0 0 0 1 0 0 0 1 0") {
    return "<?xml version=\"1.0\"?>\n<VTKFile type=\"PolyData\" version=\"0.1\" "
           "byte_order=\"LittleEndian\">\n<PolyData>\n"
           "<Piece NumberOfPoints=\"3\" NumberOfVerts=\"0\" NumberOfLines=\"0\" NumberOfStrips=\"0\" "
           "NumberOfPolys=\"1\">\n"
           "<Points><DataArray type=\"Float32\" NumberOfComponents=\"3\" format=\"ascii\">" +
           points +
           "</DataArray></Points>\n"
           "<Polys><DataArray type=\"Int64\" Name=\"connectivity\" format=\"ascii\">" +
           connectivity +
           "</DataArray>"
           "<DataArray type=\"Int64\" Name=\"offsets\" format=\"ascii\">" +
           offsets +
           "</DataArray></Polys>\n"
           "</Piece>\n</PolyData>\n</VTKFile>\n";
}

TEST_F(BadFiles, Vtp) {
    EXPECT_EQ(complaint(file("good.vtp", vtp("0 1 2", "3"))), "");
    expect_complaint(file("index.vtp", vtp("0 1 5", "3")), "point 5 of 3");
    EXPECT_NE(complaint(file("offset.vtp", vtp("0 1 2", "3000000"))), "");
    EXPECT_NE(complaint(file("offset.vtp", vtp("0 1 2", "-3"))), "");
    EXPECT_NE(complaint(file("points.vtp", vtp("0 1 2", "3", "0 0 0 1"))), "");
    const std::string good = vtp("0 1 2", "3");
    expect_complaint(file("cut.vtp", good.substr(0, good.size() - 20)), "truncated");
    EXPECT_NE(complaint(file("xml.vtp", "<VTKFile type=\"PolyData\"><PolyData></Piece></PolyData></VTKFile>")), "");
    expect_complaint(file("grid.vtp", "<VTKFile type=\"ImageData\"></VTKFile>"), "no PolyData");
    EXPECT_NE(
        complaint(file("empty.vtp", "<VTKFile type=\"PolyData\" version=\"0.1\"><PolyData></PolyData></VTKFile>")), "");
}

TEST_F(BadFiles, VtpThatPromisesMoreThanItHolds) {
    const std::clock_t start = std::clock();
    const std::string good = vtp("0 1 2", "3");
    for (const auto& [from, to] : {std::pair("NumberOfComponents=\"3\"", "NumberOfComponents=\"1000000000\""),
                                   std::pair("NumberOfComponents=\"3\"", "NumberOfComponents = '1e300'"),
                                   std::pair("NumberOfComponents=\"3\"", "NumberOfComponents=\"-3\""),
                                   std::pair("NumberOfComponents=\"3\"", "NumberOfComponents=\""),
                                   std::pair("NumberOfPoints=\"3\"", "NumberOfPoints=\"1000000000000\""),
                                   std::pair("NumberOfPolys=\"1\"", "NumberOfPolys=\"1000000000\""),
                                   std::pair("NumberOfVerts=\"0\"", "NumberOfVerts=\"9999999999999999999\"")}) {
        std::string bad = good;
        bad.replace(bad.find(from), std::string_view(from).size(), to);
        expect_complaint(file("promise.vtp", bad), std::string(to).substr(0, std::string(to).find_first_of(" =")));
    }
    EXPECT_LT(std::clock() - start, 5 * CLOCKS_PER_SEC) << "of processor time: refused before it is read";
}

TEST_F(BadFiles, CompressedFiles) {
    const std::string packed = gzipped(good_stl());
    EXPECT_EQ(complaint(file("good.stl.gz", packed)), "");
    for (const std::size_t n : {std::size_t{5}, std::size_t{20}, packed.size() / 2, packed.size() - 1})
        expect_complaint(file("cut.stl.gz", packed.substr(0, n)), "truncated");
    expect_complaint(file("plain.stl.gz", good_stl()), "not a gzip file");
    std::string damaged = packed;
    for (std::size_t k = 30; k < 60; ++k) damaged[k] = static_cast<char>(damaged[k] ^ 0x5a);
    EXPECT_NE(complaint(file("damaged.stl.gz", damaged)), "");
    expect_complaint(file("bomb.stl.gz", gzipped(std::string(300'000'000, ' '))), "unpacks to more than");
    expect_complaint(file("empty.stl.gz", gzipped("")), "nothing is in it");
    expect_complaint(file("hull.dwg.gz", packed), "not from \".dwg.gz\"");
    expect_complaint(file("hull.gz", packed), ".stl.gz");
}

TEST_F(BadFiles, SingleBytesOfASmallFileChanged) {
    // None may crash; those that are still read are triangles with finite corners.
    write_stl(folder / "plain.stl", make_hull("box", {}));
    const std::vector<std::pair<std::string, std::string>> files{
        {"change.stl", ascii_triangle},
        {"change.ply", ply("ascii", 3, 1, "0 0 0\n1 0 0\n0 1 0\n3 0 1 2\n")},
        {"change.obj", "v 0 0 0\nv 1 0 0\nv 0 1 0\nvn 0 0 1\nvt 0 0\nf 1/1/1 2/1/1 3/1/1\n"},
        {"change2.ply",
         ply("binary_little_endian", 3, 1,
             std::string("\0\0\0\0\0\0\0\0\0\0\0\0\0\0\200\077\0\0\0\0\0\0\0\0\0\0\0\0\0\0\200\077\0\0\0\0"
                         "\3\0\0\0\0\1\0\0\0\2\0\0\0",
                         49))},
        {"change.stl2.stl", read_text(folder / "plain.stl")},
        {"change.vtp", vtp("0 1 2", "3")}};
    std::mt19937 random(11);
    for (const auto& [name, good] : files)
        for (std::size_t i = 0; i < good.size(); i += name == "change.vtp" ? 7 : 1) {  // each is read in a child
            std::string bad = good;
            bad[i] = static_cast<char>(random());
            try {
                const Surface s = read_surface(file(name, bad));
                ASSERT_FALSE(s.triangles.empty());
                for (const Vec3& p : s.points) ASSERT_TRUE(p.allFinite());
            } catch (const InputError&) {}
        }
}

TEST_F(BadFiles, SoundFilesOfUnsoundHullsAreReadAndJudged) {
    const Surface hull = make_hull("prismatic", {});
    const auto judged = [&](const Surface& s, std::string_view unit = "m") {
        write_stl(folder / "hull.stl", s);
        std::string names;
        for (const Finding& f : check_surface(read_surface(folder / "hull.stl", unit))) names += f.name + " ";
        return names;
    };
    Surface millimetres = hull, open = hull, flipped = hull, inverted = hull, nested = hull;
    for (Vec3& p : millimetres.points) p *= 1000;
    EXPECT_EQ(judged(millimetres), "suspicious_size ");
    EXPECT_EQ(judged(millimetres, "mm"), "");
    open.triangles.pop_back();
    EXPECT_EQ(judged(open), "open_edges ");
    std::swap(flipped.triangles[3][0], flipped.triangles[3][1]);
    EXPECT_EQ(judged(flipped), "flipped_normals ");
    for (auto& t : inverted.triangles) std::swap(t[0], t[1]);
    EXPECT_EQ(judged(inverted), "inverted ");
    const int n = static_cast<int>(hull.points.size());
    for (const Vec3& p : hull.points) nested.points.push_back(0.9 * (p - Vec3(0, 0, 0.4)) + Vec3(0, 0, 0.4));
    for (const auto& t : hull.triangles) nested.triangles.push_back({t[0] + n, t[2] + n, t[1] + n});
    EXPECT_EQ(judged(nested), "nested_shells ");
}
}  // namespace bad_files_test
}  // namespace tw
