#include <algorithm>
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
    long vertices = 0, faces = 0, highest = 0;
    std::size_t highest_line = 0;
    const auto fail = [&](std::size_t number, const std::string& what) {
        throw InputError(file.string() + ":" + std::to_string(number) + ": " + what + "; export the hull again");
    };
    while (text.line(line)) {
        const auto w = words(line);
        if (w.empty()) continue;
        if (w.back() == "\\") fail(text.number(), "continued lines are not read");
        if (w[0] == "v") {
            double x = 0;
            if (w.size() < 4 || !to_number(w[1], x) || !to_number(w[2], x) || !to_number(w[3], x))
                fail(text.number(), "found \"" + std::string(line.substr(0, 60)) + "\", expected \"v x y z\"");
            ++vertices;
        } else if (w[0] == "f") {
            if (w.size() < 4) fail(text.number(), "a face of fewer than three corners");
            ++faces;
            for (std::size_t k = 1; k < w.size(); ++k) {
                long index = 0;
                const bool is_number = to_number(w[k].substr(0, w[k].find('/')), index);
                if (!is_number || index == 0 || index < -vertices)
                    fail(text.number(),
                         "the corner \"" + std::string(w[k].substr(0, 30)) + "\" is not one of the vertices");
                if (index > highest) {
                    highest = index;
                    highest_line = text.number();
                }
            }
        }
    }
    if (faces == 0 || vertices == 0)
        throw InputError(file.string() + ": no triangles: " + std::to_string(vertices) + " vertices (\"v\") and " +
                         std::to_string(faces) + " faces (\"f\") found; is it an OBJ file? export the hull again");
    if (highest > vertices)
        fail(highest_line, "corner " + std::to_string(highest) + " of a face does not exist: the file has " +
                               std::to_string(vertices) + " vertices (truncated?)");
}

void check_vtp(const std::filesystem::path& file, std::string_view content) {
    const auto fail = [&](const std::string& what) {
        throw InputError(file.string() + ": " + what + "; write the surface again as VTK XML PolyData");
    };
    if (content.substr(0, 2000).find("<VTKFile") == std::string_view::npos)
        fail("not a VTP file: no <VTKFile> element at its beginning");
    if (content.substr(0, 4000).find("PolyData") == std::string_view::npos)
        fail("not a VTP file: it holds no PolyData");
    const auto last = content.find_last_not_of(" \t\r\n\0");
    constexpr std::string_view end = "</VTKFile>";
    if (last == std::string_view::npos || last + 1 < end.size() ||
        content.substr(last + 1 - end.size(), end.size()) != end)
        fail("truncated: the file does not end with </VTKFile>");
}

}  // namespace tw
