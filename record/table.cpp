#include "record/table.h"

#include <algorithm>
#include <limits>

namespace tw {
namespace {

constexpr double unknown = std::numeric_limits<double>::quiet_NaN();

}  // namespace

Column& Table::column(const std::string& column_name, const std::string& unit) {
    for (Column& c : columns)
        if (c.name == column_name) return c;
    return columns.emplace_back(Column{column_name, unit, {}});
}

const Column* Table::find(const std::string& column_name) const {
    const auto found = std::ranges::find(columns, column_name, &Column::name);
    return found == columns.end() ? nullptr : &*found;
}

std::size_t Table::append(double at) {
    time.push_back(at);
    for (Column& c : columns) c.values.resize(time.size(), unknown);
    return time.size() - 1;
}

void Table::set(std::size_t row, const std::string& column_name, const std::string& unit, double value) {
    Column& c = column(column_name, unit);
    c.values.resize(time.size(), unknown);
    c.values[row] = value;
}

void Table::rewind(double to) {
    time.erase(std::ranges::upper_bound(time, to), time.end());
    for (Column& c : columns) c.values.resize(time.size(), unknown);
}

}  // namespace tw
