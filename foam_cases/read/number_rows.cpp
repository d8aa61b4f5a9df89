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

namespace {

/// The time in "force_0.25.dat" for the table "force.dat"; nothing for other names.
std::optional<double> time_behind(const std::string& name, const fs::path& table) {
    const std::string before = table.stem().string() + "_", after = table.extension().string();
    if (name.size() <= before.size() + after.size() || !name.starts_with(before) || !name.ends_with(after)) return {};
    return time_of(std::string_view(name).substr(before.size(), name.size() - before.size() - after.size()));
}

std::vector<std::vector<double>> rows_of(const fs::path& file) {
    std::vector<std::vector<double>> rows;
    std::ifstream in(file, std::ios::binary);
    std::string line;
    while (std::getline(in, line)) {
        if (line.empty() || line[0] == '#' || in.eof()) continue;  // a last line without its end was being written
        if (std::vector<double> row = numbers_in(line); !row.empty()) rows.push_back(std::move(row));
    }
    return rows;
}

}  // namespace

std::vector<Segment> segments(const fs::path& function_object, const std::string& file) {
    std::map<std::pair<double, double>, Segment> in_order;  // by the folder's time and the one behind the name
    std::error_code none;
    for (const auto& folder : fs::directory_iterator(function_object, none)) {
        const auto start = time_of(folder.path().filename().string());
        if (!start) continue;
        for (const auto& entry : fs::directory_iterator(folder.path(), none)) {
            const std::string name = entry.path().filename().string();
            const std::optional<double> again = name == file ? std::optional(-1.0) : time_behind(name, file);
            if (again) in_order[{*start, *again}] = {*start, entry.path()};
        }
    }
    std::vector<Segment> out;
    for (auto& [order, segment] : in_order) out.push_back(std::move(segment));
    return out;
}

std::vector<std::vector<double>> joined_rows(const fs::path& function_object, const std::string& file) {
    std::vector<std::vector<double>> rows;
    std::map<std::size_t, std::size_t> widths;
    std::vector<std::pair<double, std::vector<std::vector<double>>>> starts;
    for (const Segment& segment : segments(function_object, file)) {
        starts.emplace_back(segment.start, rows_of(segment.file));
        for (const auto& row : starts.back().second) ++widths[row.size()];
    }
    const auto usual = std::ranges::max_element(widths, {}, [](const auto& w) { return w.second; });
    for (auto& [start, of_start] : starts) {
        const double gone_on_from = start * (1 + time_name_precision);
        std::erase_if(rows, [&](const auto& row) { return row[0] > gone_on_from; });
        for (auto& row : of_start) {
            if (row.size() != usual->first) continue;
            while (!rows.empty() && rows.back()[0] >= row[0]) rows.pop_back();
            rows.push_back(std::move(row));
        }
    }
    return rows;
}

}  // namespace tw
