#include "meshes/read/opened_surface.h"

#include <algorithm>
#include <array>
#include <cctype>
#include <cstdint>
#include <utility>

#include "base/atomic_file.h"
#include "base/errors.h"
#include "meshes/read/stl.h"

namespace tw {
namespace fs = std::filesystem;
namespace {

std::string lower_case(std::string text) {
    std::ranges::transform(text, text.begin(), [](unsigned char c) { return static_cast<char>(std::tolower(c)); });
    return text;
}

/// Length of the mark with which editors begin a text in UTF-8, 0 where there is none; UTF-16 is refused. A binary STL may
/// begin with any bytes.
std::size_t byte_order_mark(const fs::path& file, const std::string& type, const std::string& content) {
    if (type == ".stl" && is_binary_stl(content)) return 0;
    if (content.starts_with("\xFF\xFE") || content.starts_with("\xFE\xFF"))
        throw InputError(
            file.string() +
            ":1: begins with the byte order mark of UTF-16; expected plain text: save it as UTF-8 or ASCII, "
            "or export the hull again");
    return content.starts_with("\xEF\xBB\xBF") ? 3 : 0;
}

}  // namespace

bool OpenedSurface::names_solids() const {
    return step() || type == ".obj" || (type == ".stl" && is_ascii_stl(content));
}

void OpenedSurface::go_on_with(std::string other) {
    content = std::move(other);
    memory = std::make_unique<MemoryFile>(content);
    readable = memory->path();
}

OpenedSurface opened_surface(const fs::path& file) {
    constexpr std::array<std::string_view, 4> meshes{".stl", ".obj", ".ply", ".vtp"};
    OpenedSurface opened;
    const bool packed = lower_case(file.extension().string()) == ".gz";
    const std::string& type = opened.type = lower_case((packed ? file.stem() : file.filename()).extension().string());
    if (!opened.drawing() && std::ranges::find(meshes, type) == meshes.end())
        throw InputError(file.string() +
                         ": surfaces are read from .stl, .obj, .ply, .vtp, .step and .iges files (also compressed, as "
                         ".stl.gz), not from \"" +
                         type + (packed ? ".gz\"" : "\""));
    std::error_code error;
    if (!fs::exists(file, error)) throw InputError(file.string() + ": no such file; check the name and the folder");
    if (!fs::is_regular_file(file, error)) throw InputError(file.string() + ": is not a file");
    constexpr std::uintmax_t largest = 4'000'000'000;  // 80 million STL triangles; indices are 32 bit
    if (fs::file_size(file, error) > largest)
        throw InputError(file.string() + ": larger than 4 GB; coarsen the surface first");
    opened.content = read_text(file);
    opened.readable = file;
    if (opened.content.empty()) throw InputError(file.string() + ": the file is empty; export the hull again");
    if (packed) {
        // Text of surfaces shrinks to a tenth, of very regular ones to a fiftieth; what grows a thousandfold is no
        // hull.
        const std::size_t most = std::min<std::size_t>(largest, 200 * opened.content.size() + 1'000'000);
        opened.go_on_with(unpacked(file, opened.content, most));
        if (opened.content.empty()) throw InputError(file.string() + ": nothing is in it; export the hull again");
    }
    if (const std::size_t mark = byte_order_mark(file, type, opened.content); mark > 0)
        opened.go_on_with(opened.content.substr(mark));
    return opened;
}

}  // namespace tw
