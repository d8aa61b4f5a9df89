#include "meshes/read/ply.h"

#include <vtkCellArray.h>
#include <vtkPoints.h>

#include <algorithm>
#include <bit>
#include <cstdint>
#include <limits>
#include <optional>
#include <string>

#include "base/errors.h"
#include "meshes/read/text.h"

namespace tw {
namespace {

struct Property {
    std::string name;
    std::size_t size = 0;                                       ///< bytes of a value
    std::size_t count_size = 0;                                 ///< bytes of a list's length; 0: a single value
    enum class Kind { integer, sign, real } kind = Kind::real;  ///< of its values; sign: integers below 0 too
    bool is_corners = false;                                    ///< the list of a face's vertices
    int axis = -1;                                              ///< of a vertex's place
};
struct Element {
    std::string name;
    std::uint64_t count = 0;
    std::vector<Property> properties;
};
enum class Format { ascii, little, big };

std::size_t size_of(std::string_view type) {
    for (const std::string_view t : {"char", "uchar", "int8", "uint8"})
        if (type == t) return 1;
    for (const std::string_view t : {"short", "ushort", "int16", "uint16"})
        if (type == t) return 2;
    for (const std::string_view t : {"int", "uint", "int32", "uint32", "float", "float32"})
        if (type == t) return 4;
    for (const std::string_view t : {"double", "float64"})
        if (type == t) return 8;
    return 0;
}

Property::Kind kind_of(std::string_view type) {
    if (type.starts_with("float") || type == "double") return Property::Kind::real;
    return type.starts_with('u') ? Property::Kind::integer : Property::Kind::sign;
}

std::uint64_t read_bits(std::string_view bytes, Format format) {
    std::uint64_t n = 0;
    for (std::size_t k = 0; k < bytes.size(); ++k) {
        const std::size_t at = format == Format::big ? k : bytes.size() - 1 - k;
        n = n << 8 | static_cast<unsigned char>(bytes[at]);
    }
    return n;
}

double read_value(std::string_view bytes, Property::Kind kind, Format format) {
    const std::uint64_t bits = read_bits(bytes, format);
    if (kind == Property::Kind::real)
        return bytes.size() == 4 ? static_cast<double>(std::bit_cast<float>(static_cast<std::uint32_t>(bits)))
                                 : std::bit_cast<double>(bits);
    const int unused = 64 - 8 * static_cast<int>(bytes.size());
    return kind == Property::Kind::sign ? static_cast<double>(static_cast<std::int64_t>(bits << unused) >> unused)
                                        : static_cast<double>(bits);
}

class PlyFile {
public:
    PlyFile(const std::filesystem::path& file, std::string_view content) : file_(file), text_(content) {}
    vtkSmartPointer<vtkPolyData> read() {
        read_header();
        vertices_ = require("vertex", {"x", "y", "z"}).count;
        const Element& faces = require("face", {});
        if (std::ranges::none_of(faces.properties, &Property::is_corners))
            fail("the faces have no list vertex_indices");
        if (faces.count == 0) fail("the file holds no faces");
        points_->SetDataTypeToDouble();
        format_ == Format::ascii ? walk_text() : walk_bytes(text_.rest());
        auto surface = vtkSmartPointer<vtkPolyData>::New();
        surface->SetPoints(points_);
        surface->SetPolys(polygons_);
        return surface;
    }

private:
    [[noreturn]] void fail(const std::string& what) const {
        throw InputError(file_.string() + ": not a sound PLY file: " + what + "; export the hull again");
    }

    void read_header() {
        std::string_view line;
        if (!text_.line(line) || line != "ply") fail("its first line is not \"ply\"");
        std::optional<Format> format;
        for (int n = 0; n < 1000; ++n) {
            if (!text_.line(line)) fail("its header has no \"end_header\"");
            const auto w = words(line);
            if (w.empty() || w[0] == "comment" || w[0] == "obj_info") continue;
            if (w[0] == "end_header") {
                if (!format) fail("its header has no \"format\" line");
                format_ = *format;
                return;
            }
            if (w[0] == "format" && w.size() == 3) {
                if (w[1] == "ascii")
                    format = Format::ascii;
                else if (w[1] == "binary_little_endian")
                    format = Format::little;
                else if (w[1] == "binary_big_endian")
                    format = Format::big;
                else
                    fail("unknown format \"" + std::string(w[1]) + "\"");
            } else if (w[0] == "element" && w.size() == 3) {
                std::uint64_t count = 0;
                if (!to_number(w[2], count)) fail("line " + std::to_string(text_.number()) + ": a count was expected");
                elements_.push_back({std::string(w[1]), count, {}});
            } else if (w[0] == "property" && !elements_.empty() &&
                       (w.size() == 3 || (w.size() == 5 && w[1] == "list"))) {
                const bool is_list = w.size() == 5;
                Property p{std::string(w.back()), size_of(w[w.size() - 2]), is_list ? size_of(w[2]) : 0};
                p.kind = kind_of(w[w.size() - 2]);
                if (elements_.back().name == "vertex" && !is_list && p.name.size() == 1)
                    p.axis = static_cast<int>(std::string_view("xyz").find(p.name[0]));  // -1: of another meaning
                p.is_corners = elements_.back().name == "face" && is_list &&
                               (p.name == "vertex_indices" || p.name == "vertex_index");
                const auto whole = [](std::string_view type) { return kind_of(type) != Property::Kind::real; };
                if (p.size == 0 || (is_list && (p.count_size == 0 || !whole(w[2]))) || (p.is_corners && !whole(w[3])))
                    fail("line " + std::to_string(text_.number()) + ": unknown type");
                elements_.back().properties.push_back(std::move(p));
            } else {
                fail("line " + std::to_string(text_.number()) + ": \"" + std::string(line.substr(0, 60)) +
                     "\" is no header line");
            }
        }
        fail("its header does not end");
    }

    const Element& require(std::string_view name, std::initializer_list<std::string_view> properties) const {
        const auto e = std::ranges::find(elements_, name, &Element::name);
        if (e == elements_.end()) fail("it has no element \"" + std::string(name) + "\"");
        for (const std::string_view p : properties)
            if (std::ranges::find(e->properties, p, &Property::name) == e->properties.end())
                fail("its element \"" + std::string(name) + "\" has no property \"" + std::string(p) + "\"");
        return *e;
    }

    [[noreturn]] void truncated(const Element& e, std::uint64_t at) const {
        fail("truncated at " + e.name + " " + std::to_string(at) + " of " + std::to_string(e.count));
    }

    void take_vertex(const double x[3]) { points_->InsertNextPoint(x); }
    void take_face(std::uint64_t face, const std::vector<vtkIdType>& corners) {
        for (const vtkIdType corner : corners)
            if (corner < 0 || static_cast<std::uint64_t>(corner) >= vertices_)
                fail("face " + std::to_string(face) + " uses point " + std::to_string(corner) + " of " +
                     std::to_string(vertices_));
        if (!corners.empty()) polygons_->InsertNextCell(static_cast<vtkIdType>(corners.size()), corners.data());
    }
    void take_row(const Element& e, std::uint64_t row, const double place[3], const std::vector<vtkIdType>& corners) {
        if (e.name == "vertex") take_vertex(place);
        if (e.name == "face") take_face(row, corners);
    }

    void walk_text() {
        std::string_view line;
        for (const Element& e : elements_)
            for (std::uint64_t i = 0; i < e.count; ++i) {
                if (!text_.line(line)) truncated(e, i);
                const auto w = words(line);
                std::vector<double> numbers;
                for (const std::string_view word : w)
                    if (!to_number(word, numbers.emplace_back()))
                        fail("line " + std::to_string(text_.number()) + ": \"" + std::string(word.substr(0, 30)) +
                             "\" is not a number");
                double place[3] = {};
                std::vector<vtkIdType> corners;
                std::size_t at = 0;
                for (const Property& p : e.properties) {
                    if (at >= w.size()) truncated(e, i);
                    if (p.axis >= 0) place[p.axis] = numbers[at];
                    if (p.count_size > 0) {
                        std::size_t n = 0;
                        if (!to_number(w[at], n) || n >= w.size() - at) truncated(e, i);
                        for (std::size_t k = 1; k <= n && p.is_corners; ++k)
                            if (!to_number(w[at + k], corners.emplace_back(-1))) corners.back() = -1;
                        at += n;
                    }
                    at += 1;
                }
                take_row(e, i, place, corners);
            }
    }

    void walk_bytes(std::string_view bytes) {
        std::size_t at = 0;
        for (const Element& e : elements_) {
            if (e.count > bytes.size()) truncated(e, bytes.size());  // every row takes at least a byte
            for (std::uint64_t i = 0; i < e.count; ++i) {
                double place[3] = {};
                std::vector<vtkIdType> corners;
                for (const Property& p : e.properties) {
                    std::uint64_t n = 1;
                    if (p.count_size > 0) {
                        if (at + p.count_size > bytes.size()) truncated(e, i);
                        n = read_bits(bytes.substr(at, p.count_size), format_);
                        at += p.count_size;
                    }
                    if (n > (bytes.size() - at) / p.size) truncated(e, i);
                    const auto value = [&](std::uint64_t k) {
                        return read_value(bytes.substr(at + k * p.size, p.size), p.kind, format_);
                    };
                    if (p.axis >= 0) place[p.axis] = value(0);
                    for (std::uint64_t k = 0; k < n && p.is_corners; ++k)
                        corners.push_back(static_cast<vtkIdType>(value(k)));
                    at += n * p.size;
                }
                take_row(e, i, place, corners);
            }
        }
    }

    std::filesystem::path file_;
    TextCursor text_;
    Format format_ = Format::ascii;
    std::vector<Element> elements_;
    std::uint64_t vertices_ = 0;
    vtkNew<vtkPoints> points_;
    vtkNew<vtkCellArray> polygons_;
};

}  // namespace

vtkSmartPointer<vtkPolyData> read_ply(const std::filesystem::path& file, std::string_view content) {
    return PlyFile(file, content).read();
}

}  // namespace tw
