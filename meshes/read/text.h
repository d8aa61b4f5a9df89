#pragma once
#include <charconv>
#include <string_view>
#include <vector>

namespace tw {

/// Takes lines and words off a text, counting lines.
class TextCursor {
public:
    explicit TextCursor(std::string_view text) : rest_(text) {}
    /// The next line without its end, false at the end of the text.
    bool line(std::string_view& out) {
        if (rest_.empty()) return false;
        const std::size_t end = rest_.find('\n');
        out = rest_.substr(0, end);
        if (!out.empty() && out.back() == '\r') out.remove_suffix(1);
        rest_.remove_prefix(end == std::string_view::npos ? rest_.size() : end + 1);
        ++number_;
        return true;
    }
    std::size_t number() const { return number_; }  ///< of the line last taken, from 1
    std::string_view rest() const { return rest_; }

private:
    std::string_view rest_;
    std::size_t number_ = 0;
};

inline std::vector<std::string_view> words(std::string_view line) {
    std::vector<std::string_view> result;
    constexpr std::string_view blanks = " \t\r\v\f";
    for (std::size_t begin = line.find_first_not_of(blanks); begin != std::string_view::npos;) {
        const std::size_t end = line.find_first_of(blanks, begin);
        result.push_back(line.substr(begin, end - begin));
        begin = end == std::string_view::npos ? end : line.find_first_not_of(blanks, end);
    }
    return result;
}

/// The whole word as a number of type T; false when it is not one. Independent of the locale.
template <class T>
bool to_number(std::string_view word, T& value) {
    if (!word.empty() && word.front() == '+') word.remove_prefix(1);
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), value);
    return error == std::errc() && end == word.data() + word.size();
}

}  // namespace tw
