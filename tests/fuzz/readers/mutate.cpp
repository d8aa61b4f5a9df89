#include "tests/fuzz/readers/mutate.h"

#include <algorithm>
#include <array>
#include <cstdint>
#include <cstring>
#include <limits>
#include <string_view>

namespace tw::readers {
namespace {

constexpr std::array<std::string_view, 24> extreme_texts{"0",
                                                         "-1",
                                                         "-0",
                                                         "1",
                                                         "255",
                                                         "256",
                                                         "65536",
                                                         "2147483647",
                                                         "-2147483648",
                                                         "4294967295",
                                                         "4294967296",
                                                         "1e9",
                                                         "1e-320",
                                                         "nan",
                                                         "-inf",
                                                         "1e308",
                                                         "-1e308",
                                                         "1e999",
                                                         "9223372036854775807",
                                                         "-9223372036854775808",
                                                         "18446744073709551615",
                                                         "18446744073709551616",
                                                         "0.1",
                                                         ""};
constexpr double infinity = std::numeric_limits<double>::infinity();
constexpr std::array extreme_doubles{
    0.0, -1.0, 1e308, -1e308, 1e-320, infinity, std::numeric_limits<double>::quiet_NaN()};
constexpr std::array<std::uint64_t, 10> extreme_wholes{
    0, 1, 0x7f, 0xff, 0xffff, 0x7fffffff, 0x80000000, 0xffffffff, 0x7fffffffffffffff, 0xffffffffffffffff};

class Mutation {
public:
    Mutation(const std::vector<std::string>& seeds, std::mt19937_64& random)
        : seeds_(seeds), random_(random), text_(seeds[below(seeds.size())]), longest_(text_.size() + 65536) {}

    std::string changed() {
        for (std::size_t n = 1 + below(below(8) + 1); n > 0; --n) change();
        if (text_.size() > longest_) text_.resize(longest_);
        return text_;
    }

private:
    struct Block {
        std::size_t begin = 0, size = 0;
    };

    // std::uniform_int_distribution is another one in every library.
    std::size_t below(std::size_t n) { return n < 2 ? 0 : static_cast<std::size_t>(random_() % n); }
    template <class List>
    auto one_of(const List& list) {
        return list[below(list.size())];
    }
    Block block(std::size_t longest) {
        const std::size_t begin = below(text_.size() + 1);
        return {begin, below(std::min(longest, text_.size() - begin) + 1)};
    }
    Block line() {
        const std::size_t at = below(text_.size() + 1), before = text_.rfind('\n', at > 0 ? at - 1 : 0);
        const std::size_t begin = at > 0 && before != std::string::npos ? before + 1 : 0;
        const std::size_t end = text_.find('\n', begin);
        return {begin, (end == std::string::npos ? text_.size() : end + 1) - begin};
    }

    void change() {
        switch (below(12)) {
            case 0: return change_bit();
            case 1: return change_byte();
            case 2: return put_number_as_text();
            case 3: return put_bytes(one_of(extreme_wholes), std::size_t{1} << below(4));
            case 4:
                return below(2) == 0 ? put_bytes(one_of(extreme_doubles), 8)
                                     : put_bytes(static_cast<float>(one_of(extreme_doubles)), 4);
            case 5: return take_out(block(64));
            case 6: return take_out(line());
            case 7: return repeat(block(64));
            case 8: return repeat(line());
            case 9: return move(line());
            case 10: return splice();
            default: text_.resize(below(text_.size() + 1));
        }
    }

    void change_bit() {
        if (text_.empty()) return;
        char& c = text_[below(text_.size())];
        c = static_cast<char>(static_cast<unsigned char>(c) ^ (1u << below(8)));
    }
    void change_byte() {
        const char byte = static_cast<char>(random_());
        const std::size_t at = below(text_.size() + 1);
        if (at < text_.size() && below(2) == 0)
            text_[at] = byte;
        else
            text_.insert(at, 1, byte);
    }
    void put_number_as_text() {
        constexpr std::string_view digits = "0123456789";
        const std::size_t found = text_.find_first_of(digits, below(text_.size() + 1));
        if (found == std::string::npos) return;
        const std::size_t end = std::min(text_.find_first_not_of("0123456789.eE+-", found), text_.size());
        text_.replace(found, end - found, one_of(extreme_texts));
    }
    template <class Number>
    void put_bytes(Number number, std::size_t size) {
        if (text_.size() < size) return;
        std::memcpy(&text_[below(text_.size() - size + 1)], &number, size);
    }
    void take_out(Block b) { text_.erase(b.begin, b.size); }
    void repeat(Block b) {
        const std::string part = text_.substr(b.begin, b.size);
        std::string more;
        for (std::size_t n = std::size_t{1} << below(10); n > 0 && more.size() < 65536; --n) more += part;
        text_.insert(b.begin, more);
    }
    void move(Block b) {
        const std::string part = text_.substr(b.begin, b.size);
        take_out(b);
        text_.insert(line().begin, part);
    }
    void splice() {
        const std::string& other = seeds_[below(seeds_.size())];
        const std::size_t from = below(other.size() + 1);
        text_.insert(below(text_.size() + 1), other, from, below(other.size() - from + 1));
    }

    const std::vector<std::string>& seeds_;
    std::mt19937_64& random_;
    std::string text_;
    std::size_t longest_;
};

}  // namespace

std::string mutated(const std::vector<std::string>& seeds, std::mt19937_64& random) {
    return Mutation(seeds, random).changed();
}

}  // namespace tw::readers
