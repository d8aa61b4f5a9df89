#pragma once
#include <array>
#include <initializer_list>
#include <string>
#include <string_view>
#include <type_traits>
#include <utility>
#include <vector>

#include "base/vec3.h"

namespace tw {

class Dictionary;

/// Tokens that OpenFOAM reads as they stand: `patch`, `uniform (0 0 0)`, `Gauss linear limited corrected 0.5`.
/// Letters, digits, blanks and _ . : + - ( ) , only: nothing that ends an entry, opens a dictionary or a string, starts
/// a directive (#calc, #include), a variable ($) or a comment. Throws InputError that shows the text.
struct Word {
    explicit Word(std::string_view tokens);
    std::string text;
};
/// A string in quotes: the characters of Word and / < >, so that it means itself in every version (but for "<case>", in
/// openfoam.com alone, or "$FOAM_CASE" at its beginning, the case folder).
struct Quoted {
    explicit Quoted(std::string_view content);
    std::string text;
};
/// Physical dimensions [kg m s K mol A cd].
struct Dimensions {
    std::array<int, 7> exponents{};
};
inline constexpr Dimensions dimensionless{}, velocity{{0, 1, -1}}, pressure{{1, -1, -2}}, specific_energy{{0, 2, -2}},
    per_second{{0, 0, -1}}, diffusivity{{0, 2, -1}}, acceleration{{0, 1, -2}}, metres{{0, 1}}, density_units{{1, -3}},
    surface_tension_units{{1, 0, -2}};

/// The right-hand side of an entry, already spelled as OpenFOAM text. Numbers go through std::to_chars: the same value
/// gives the same bytes in any locale. A number that is not finite throws InputError.
class Value {
public:
    Value(const Word& word);
    Value(const Quoted& quoted);
    Value(double number);
    template <class T>
    requires std::is_integral_v<T> Value(T whole) : Value(whole_number(static_cast<long long>(whole))) {}
    Value(bool yes_or_no);
    Value(const Vec3& vector);
    Value(const Dimensions& dimensions);
    Value(const std::vector<Value>& list);
    Value(const Dictionary& dictionary);
    /// An element `name { ... }` of a list, as in blockMeshDict's boundary.
    static Value named(const Word& name, const Dictionary& dictionary);
    /// Values one behind the other: `hex (0 1 2 3 4 5 6 7) (4 5 6) simpleGrading (1 1 1)`.
    static Value sequence(const std::vector<Value>& parts);
    /// One vector or number per cell: `nonuniform List<vector> 2 ((0 0 0) (1 0 0))`.
    static Value nonuniform(const std::vector<Vec3>& cells);
    static Value nonuniform(const std::vector<double>& cells);

    const std::string& text() const { return text_; }
    bool is_block() const { return block_; }  ///< ends in a brace: takes no semicolon

private:
    Value() = default;
    static Value whole_number(long long whole);
    std::string text_;
    bool block_ = false;
};
using List = std::vector<Value>;

/// Key of an entry: a single word, or a quoted regular expression such as "alpha.water.*".
struct Key {
    Key(const char* word) : Key(std::string_view(word)) {}
    Key(const std::string& word) : Key(std::string_view(word)) {}
    Key(std::string_view word);
    static Key pattern(std::string_view expression);
    std::string text;

private:
    Key() = default;
};

/// OpenFOAM's dictionary as a value: keys keep their order. This class and Value hold the only code that spells it as
/// text.
class Dictionary {
public:
    using Entry = std::pair<Key, Value>;
    Dictionary() = default;
    Dictionary(std::initializer_list<Entry> entries);
    Dictionary& add(const Key& key, const Value& value);  ///< throws InputError when the key is there already
    Dictionary& add(const Dictionary& other);             ///< all its entries, in their order
    bool empty() const { return entries_.empty(); }
    std::string text() const;  ///< one entry per line

private:
    std::vector<Entry> entries_;
};

/// A whole file: the FoamFile header (version, format, class, object) and the entries.
std::string foam_file(std::string_view foam_class, std::string_view object, const Dictionary& entries);

/// A whole file that is one list, such as a table of parcels: the header and one element per line.
std::string foam_list_file(std::string_view foam_class, std::string_view object, const List& elements);

/// A word made from any text (a part's name, say): characters other than letters and digits become _, and what does not
/// begin with a letter gets the prefix part_. Empty text gives `fallback`.
std::string word_from(std::string_view text, std::string_view fallback);

}  // namespace tw
