#include "foam_cases/read/field_file.h"

#include <charconv>
#include <cstring>

#include "base/atomic_file.h"
#include "base/errors.h"
#include "foam_cases/read/number_rows.h"

namespace tw {
namespace {

/// Text between `key` and the next semicolon, blanks trimmed; empty when the key is not there.
std::string_view entry(std::string_view header, std::string_view key) {
    std::size_t at = header.find(key);
    if (at == std::string_view::npos) return {};
    header.remove_prefix(at + key.size());
    header = header.substr(0, header.find(';'));
    while (!header.empty() && (header.front() == ' ' || header.front() == '\t')) header.remove_prefix(1);
    return header;
}

template <class Real>
void take_binary(std::string_view bytes, std::vector<double>& out) {
    for (std::size_t i = 0; i < out.size(); ++i) {
        Real value;
        std::memcpy(&value, bytes.data() + i * sizeof(Real), sizeof(Real));
        out[i] = static_cast<double>(value);
    }
}

}  // namespace

FieldFile read_field(const std::filesystem::path& file) {
    const auto fail = [&](const std::string& why) -> RunError {
        return RunError(file.string() + ": " + why + "; the solver was probably stopped while it wrote");
    };
    if (!std::filesystem::exists(file)) throw fail("is not there");
    const std::string text = read_text(file);
    const std::size_t internal = text.find("internalField");
    if (internal == std::string::npos) throw fail("holds no internalField");
    const std::string_view header = std::string_view(text).substr(0, internal);
    FieldFile field;
    const std::string_view field_class = entry(header, "class ");
    if (field_class == "volVectorField")
        field.components = 3;
    else if (field_class != "volScalarField" && field_class != "volScalarField::Internal")
        throw fail("is a '" + std::string(field_class) + "', expected a volScalarField or volVectorField");
    const bool binary = entry(header, "format ") == "binary";
    const std::size_t width = header.find("scalar=32") != std::string_view::npos ? 4 : 8;

    std::string_view rest = std::string_view(text).substr(internal + std::strlen("internalField"));
    rest.remove_prefix(std::min(rest.find_first_not_of(" \t\n"), rest.size()));
    const auto n = static_cast<std::size_t>(field.components);
    if (rest.rfind("uniform", 0) == 0) {
        field.uniform = true;
        field.values = numbers_in(rest.substr(7, rest.find(';') - 7));
        if (field.values.size() != n)
            throw fail("holds a uniform value of " + std::to_string(field.values.size()) + " numbers");
        return field;
    }
    const std::size_t list = rest.find('>');
    if (rest.rfind("nonuniform", 0) != 0 || list == std::string_view::npos)
        throw fail("holds an internalField of an unknown form");
    rest.remove_prefix(list + 1);
    rest.remove_prefix(std::min(rest.find_first_not_of(" \t\n"), rest.size()));
    std::size_t cells = 0;
    const auto [after, error] = std::from_chars(rest.data(), rest.data() + rest.size(), cells);
    const std::size_t open = rest.find('(');
    if (error != std::errc{} || (cells > 0 && open == std::string_view::npos)) throw fail("is cut off");
    if (cells == 0) return field;
    rest.remove_prefix(open + 1);
    if (cells > text.size()) throw fail("claims more cells than it has bytes");
    if (binary) {
        if (rest.size() < cells * n * width + 1 || rest[cells * n * width] != ')') throw fail("is cut off");
        field.values.resize(cells * n);
        width == 8 ? take_binary<double>(rest, field.values) : take_binary<float>(rest, field.values);
    } else {
        const std::size_t close = rest.find("\n)");
        field.values = numbers_in(rest.substr(0, close));
        if (close == std::string_view::npos || field.values.size() != cells * n) throw fail("is cut off");
    }
    return field;
}

std::string cell_volumes_in(const std::filesystem::path& time_folder) {
    return std::filesystem::exists(time_folder / "Vc") ? "Vc" : "V";
}

}  // namespace tw
