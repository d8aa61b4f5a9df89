#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <string>

#include "base/errors.h"
#include "meshes/read/precheck.h"
#include "meshes/read/text.h"

namespace tw {

void check_obj(const std::filesystem::path& file, std::string_view content) {
    if (content.find('\0') != std::string_view::npos)
        throw InputError(file.string() + ": not an OBJ file: it holds binary data; export the hull again");
    TextCursor text(content);
    std::string_view line;
    // Corners refer to vertices, texture points and normals as v/vt/vn; the reader follows all three unchecked.
    struct List {
        std::string_view key, meaning;
        long count = 0, highest = 0;
        std::size_t highest_line = 0;
    };
    std::array<List, 3> lists{{{"v", "vertices"}, {"vt", "texture points"}, {"vn", "normals"}}};
    long faces = 0;
    const auto fail = [&](std::size_t number, const std::string& what) {
        throw InputError(file.string() + ":" + std::to_string(number) + ": " + what + "; export the hull again");
    };
    while (text.line(line)) {
        const auto w = words(line);
        if (w.empty()) continue;
        if (w.back() == "\\") fail(text.number(), "continued lines are not read");
        if (const auto list = std::ranges::find(lists, w[0], &List::key); list != lists.end()) {
            const std::size_t numbers = w[0] == "vt" ? 2 : 3;
            double x = 0;
            for (std::size_t k = 1; k <= numbers; ++k)
                if (k >= w.size() || !to_number(w[k], x) || !std::isfinite(x))
                    fail(text.number(), "found \"" + std::string(line.substr(0, 60)) + "\", expected \"" +
                                            std::string(w[0]) + "\" and " + std::to_string(numbers) +
                                            " finite numbers");
            ++list->count;
        } else if (w[0] == "f") {
            if (w.size() < 4) fail(text.number(), "a face of fewer than three corners");
            ++faces;
            for (std::size_t k = 1; k < w.size(); ++k) {
                std::string_view rest = w[k];
                for (List& of : lists) {
                    const std::string_view part = rest.substr(0, rest.find('/'));
                    rest.remove_prefix(std::min(rest.size(), part.size() + 1));
                    if (part.empty() && of.key != "v") continue;
                    long index = 0;
                    if (!to_number(part, index) || index == 0 || index < -of.count)
                        fail(text.number(), "the corner \"" + std::string(w[k].substr(0, 30)) +
                                                "\" does not name one of the " + std::string(of.meaning));
                    if (index > of.highest) {
                        of.highest = index;
                        of.highest_line = text.number();
                    }
                }
                if (!rest.empty())
                    fail(text.number(), "the corner \"" + std::string(w[k].substr(0, 30)) + "\" is not v/vt/vn");
            }
        } else if (w[0] == "l" || w[0] == "p") {
            fail(text.number(), "the file holds lines or points, which are no part of a surface");
        }
    }
    if (faces == 0 || lists[0].count == 0)
        throw InputError(file.string() + ": no triangles: " + std::to_string(lists[0].count) +
                         " vertices (\"v\") and " + std::to_string(faces) +
                         " faces (\"f\") found; is it an OBJ file? export the hull again");
    for (const List& of : lists)
        if (of.highest > of.count)
            fail(of.highest_line, "a face names number " + std::to_string(of.highest) + " of " +
                                      std::to_string(of.count) + " " + std::string(of.meaning) + " (truncated?)");
}

namespace {

/// The values of an attribute NAME="..." wherever it stands in an XML text.
std::vector<std::string_view> attribute_values(std::string_view content, std::string_view name) {
    std::vector<std::string_view> values;
    for (std::size_t at = content.find(name); at != std::string_view::npos; at = content.find(name, at + 1)) {
        std::string_view rest = content.substr(at + name.size());
        rest.remove_prefix(std::min(rest.find_first_not_of(" \t\r\n"), rest.size()));
        if (!rest.starts_with('=')) continue;
        rest.remove_prefix(std::min(rest.find_first_of("\"'", 1), rest.size()));
        if (rest.size() < 2) continue;
        values.push_back(rest.substr(1, rest.find(rest[0], 1) - 1));
    }
    return values;
}

}  // namespace

void check_vtk_xml(const std::filesystem::path& file, std::string_view content, const std::string& type) {
    const auto fail = [&](const std::string& what) {
        throw InputError(file.string() + ": " + what + "; write it again as VTK XML " + type);
    };
    if (content.substr(0, 2000).find("<VTKFile") == std::string_view::npos)
        fail("not a file of VTK: no <VTKFile> element at its beginning");
    if (content.substr(0, 4000).find(type) == std::string_view::npos) fail("it holds no " + type);
    // The reader makes room for what these promise, and names every component, before it reads a number.
    constexpr double most_components = 100;  // a tensor has nine
    constexpr double most_packed = 1100;     // bytes out of one byte of a compressed file (zlib's limit is 1032)
    const auto check_counts = [&](const char* name, double most) {
        for (const std::string_view value : attribute_values(content, name)) {
            double count = 0;
            const auto first = value.find_first_not_of(" \t\r\n"), end = value.find_last_not_of(" \t\r\n");
            if (first == std::string_view::npos || !to_number(value.substr(first, end - first + 1), count) ||
                !(count >= 0 && count <= most))
                fail(fmt::format("{} is \"{}\"; expected a number from 0 to {:.0f} in a file of {} bytes", name,
                                 value.substr(0, 40), most, content.size()));
        }
    };
    check_counts("NumberOfComponents", most_components);
    const double most_values = most_packed * static_cast<double>(content.size());
    for (const char* name : {"NumberOfPoints", "NumberOfVerts", "NumberOfLines", "NumberOfStrips", "NumberOfPolys",
                             "NumberOfCells", "NumberOfTuples"})
        check_counts(name, most_values);
    const auto last = content.find_last_not_of(" \t\r\n\0");
    constexpr std::string_view end = "</VTKFile>";
    if (last == std::string_view::npos || last + 1 < end.size() ||
        content.substr(last + 1 - end.size(), end.size()) != end)
        fail("truncated: the file does not end with </VTKFile>");
}

}  // namespace tw
