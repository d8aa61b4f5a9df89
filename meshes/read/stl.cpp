#include "meshes/read/stl.h"

#include <algorithm>
#include <array>
#include <bit>
#include <cctype>
#include <cstdint>
#include <string>

#include "base/errors.h"
#include "meshes/read/text.h"

namespace tw {
namespace {
bool same_word(std::string_view a, std::string_view b) {
    return std::ranges::equal(a, b,
                              [](unsigned char x, unsigned char y) { return std::tolower(x) == std::tolower(y); });
}
/// Three corners of their own for each triangle.
void add_triangle(Surface& surface, const std::array<Vec3, 3>& corners) {
    const int first = static_cast<int>(surface.points.size());
    surface.points.insert(surface.points.end(), corners.begin(), corners.end());
    surface.triangles.push_back({first, first + 1, first + 2});
}

std::uint64_t promised_triangles(std::string_view content) {
    std::uint64_t n = 0;
    for (std::size_t k = 4; k-- > 0;) n = n << 8 | static_cast<unsigned char>(content[80 + k]);
    return n;
}
}  // namespace

bool is_binary_stl(std::string_view content) {
    return content.size() >= 84 && content.size() == 84 + 50 * promised_triangles(content);
}

bool is_ascii_stl(std::string_view content) {
    if (is_binary_stl(content)) return false;
    const auto begin = content.find_first_not_of(" \t\r\n");
    if (begin == std::string_view::npos || !same_word(content.substr(begin, 5), "solid")) return false;
    const std::string_view start = content.substr(0, 1000);
    return start.find('\0') == std::string_view::npos;
}

Surface read_binary_stl(const std::filesystem::path& file, std::string_view content) {
    if (content.size() < 84)
        throw InputError(file.string() + ": not an STL file: " + std::to_string(content.size()) +
                         " bytes, neither the text \"solid\" nor a binary header of 84 bytes; export the hull again");
    const std::uint64_t n = promised_triangles(content), expected = 84 + 50 * n;
    if (n == 0) throw InputError(file.string() + ": the binary STL file holds no triangles; export the hull again");
    if (content.size() < expected)
        throw InputError(file.string() + ": truncated or not an STL file: its header promises " + std::to_string(n) +
                         " triangles = " + std::to_string(expected) + " bytes, the file has " +
                         std::to_string(content.size()) + "; copy or export the hull again");
    if (content.size() > expected)
        throw InputError(file.string() + ": not a sound STL file: its header promises " + std::to_string(n) +
                         " triangles = " + std::to_string(expected) + " bytes, but the file has " +
                         std::to_string(content.size()) + "; export the hull again");
    const auto coordinate = [&](std::size_t at) {
        std::uint32_t bits = 0;
        for (std::size_t k = 4; k-- > 0;) bits = bits << 8 | static_cast<unsigned char>(content[at + k]);
        return static_cast<double>(std::bit_cast<float>(bits));
    };
    Surface surface;
    for (std::size_t facet = 84; facet + 50 <= content.size(); facet += 50) {
        std::array<Vec3, 3> corners;
        for (std::size_t k = 0; k < 3; ++k) {
            const std::size_t at = facet + 12 + 12 * k;  // the facet's own normal comes first and is not used
            corners[k] = {coordinate(at), coordinate(at + 4), coordinate(at + 8)};
        }
        add_triangle(surface, corners);
    }
    return surface;
}

Surface read_ascii_stl(const std::filesystem::path& file, std::string_view content) {
    TextCursor text(content);
    std::string_view line;
    Surface surface;
    std::array<Vec3, 3> corners;
    int vertices = -1;  // of the open facet; -1: outside
    bool ended = false;
    const auto fail = [&](const std::string& what) {
        throw InputError(file.string() + ":" + std::to_string(text.number()) + ": " + what + "; export the hull again");
    };
    while (text.line(line)) {
        const auto w = words(line);
        if (w.empty()) continue;
        if (same_word(w[0], "facet")) {
            if (vertices >= 0) fail("a facet begins inside a facet");
            vertices = 0;
        } else if (same_word(w[0], "vertex")) {
            double x = 0, y = 0, z = 0;
            if (vertices < 0) fail("a vertex outside of a facet");
            if (w.size() != 4 || !to_number(w[1], x) || !to_number(w[2], y) || !to_number(w[3], z))
                fail("found \"" + std::string(line.substr(0, 60)) + "\", expected \"vertex x y z\"");
            // single precision, as binary STL has it
            if (vertices < 3) corners[static_cast<std::size_t>(vertices)] = Vec3(x, y, z).cast<float>().cast<double>();
            ++vertices;
        } else if (same_word(w[0], "endfacet")) {
            if (vertices != 3) fail("a facet has " + std::to_string(std::max(vertices, 0)) + " vertices, expected 3");
            vertices = -1;
            add_triangle(surface, corners);
        } else if (same_word(w[0], "endsolid")) {
            ended = true;
        } else if (same_word(w[0], "solid")) {
            ended = false;
        } else if (!same_word(w[0], "outer") && !same_word(w[0], "endloop")) {
            fail("found \"" + std::string(line.substr(0, 60)) + "\", expected an STL facet, loop or vertex");
        }
    }
    if (!ended || vertices >= 0)
        fail("truncated: the STL text ends after " + std::to_string(surface.triangles.size()) +
             " facets without \"endsolid\"");
    if (surface.triangles.empty()) fail("the STL text holds no triangles");
    return surface;
}

}  // namespace tw
