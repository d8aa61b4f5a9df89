#include "foam_cases/read/number_rows.h"

#include <algorithm>
#include <charconv>
#include <fstream>
#include <map>

namespace tw {
namespace fs = std::filesystem;

std::vector<double> numbers_in(std::string_view line) {
    std::vector<double> out;
    const char *p = line.data(), *end = p + line.size();
    while (p < end) {
        const bool begins = (*p >= '0' && *p <= '9') || *p == '-' || *p == '+' || *p == '.' || *p == 'n' || *p == 'i';
        double value = 0;
        const char* from = p + (*p == '+' ? 1 : 0);
        const auto [after, error] =
            begins ? std::from_chars(from, end, value) : std::from_chars_result{p, std::errc::invalid_argument};
        if (error == std::errc{}) {
            out.push_back(value);
            p = after;
        } else {
            ++p;
        }
    }
    return out;
}

std::optional<double> time_of(std::string_view name) {
    double value = 0;
    if (name.empty() || name[0] < '0' || name[0] > '9') return std::nullopt;
    const auto [after, error] = std::from_chars(name.data(), name.data() + name.size(), value);
    if (error != std::errc{} || after != name.data() + name.size()) return std::nullopt;
    return value;
}

std::vector<std::vector<double>> joined_rows(const fs::path& function_object, const std::string& file) {
    std::map<double, fs::path> starts;
    std::error_code none;
    for (const auto& e : fs::directory_iterator(function_object, none))
        if (const auto t = time_of(e.path().filename().string()); t && fs::exists(e.path() / file))
            starts[*t] = e.path() / file;
    std::vector<std::vector<double>> rows;
    std::size_t width = 0;
    for (const auto& [start, path] : starts) {
        std::ifstream in(path, std::ios::binary);
        std::string line;
        while (std::getline(in, line)) {
            if (line.empty() || line[0] == '#' || in.eof()) continue;  // a last line without its end was being written
            std::vector<double> row = numbers_in(line);
            if (row.empty()) continue;
            width = std::max(width, row.size());
            if (row.size() != width) continue;
            while (!rows.empty() && rows.back()[0] >= row[0]) rows.pop_back();
            rows.push_back(std::move(row));
        }
    }
    return rows;
}

}  // namespace tw
