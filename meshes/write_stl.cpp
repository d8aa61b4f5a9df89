#include <bit>
#include <cctype>
#include <cstdint>

#include "base/atomic_file.h"
#include "meshes/surface.h"

namespace tw {
namespace {
void append(std::string& bytes, std::uint32_t value) {  // little-endian on every machine
    for (int shift = 0; shift < 32; shift += 8) bytes += static_cast<char>(value >> shift & 0xff);
}
void append(std::string& bytes, const Vec3& v) {
    for (const double x : v) append(bytes, std::bit_cast<std::uint32_t>(static_cast<float>(x)));
}
}  // namespace

void write_stl(const std::filesystem::path& file, const Surface& surface, std::string_view name) {
    // The header must not begin with "solid": readers take that for the ascii form.
    std::string bytes = "binary STL [m]: ";
    for (const char c : name.substr(0, 80 - bytes.size()))
        bytes += std::isprint(static_cast<unsigned char>(c)) != 0 ? c : '_';
    bytes.resize(80, ' ');
    append(bytes, static_cast<std::uint32_t>(surface.triangles.size()));
    bytes.reserve(84 + 50 * surface.triangles.size());
    for (int t = 0; t < static_cast<int>(surface.triangles.size()); ++t) {
        append(bytes, surface.area_vector2(t).stableNormalized());
        for (int k = 0; k < 3; ++k) append(bytes, surface.corner(t, k));
        bytes.append(2, '\0');
    }
    write_text_atomically(file, bytes);
}

}  // namespace tw
